// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What the precompiled headers are compiled for: nothing of its own.

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Compiled once per test program, to save time only.
#pragma once

#include <gtest/gtest.h>

#include "precompiled.h"

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// All ways from a picture to a silhouette.
#pragma once

#include "tegata/segment/background_difference.h"
#include "tegata/segment/infrared.h"
#include "tegata/segment/skin.h"

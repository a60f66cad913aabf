// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tegata/take/result.h"

namespace tegata {

/// The four joint angles of a digit over the frames as an inline SVG, with the grasp's as dashed
/// lines. Frames without a pose leave a gap. Colours come from the page: classes line0 .. line3.
std::string angle_chart(const Result& result, int digit);

/// How much of each bone the pictures back up, frame by frame: a table of shaded cells.
std::string support_table(const Result& result);

}  // namespace tegata

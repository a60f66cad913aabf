// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tegata/take/result.h"

namespace tegata {

/// Everything that result.json says of the frames as one table, a row a frame, world coordinates as
/// there; the header names each column's unit (docs/formats.md). Cells of frames without a pose are
/// empty.
std::string csv_text(const Result& result);

}  // namespace tegata

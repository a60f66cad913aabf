// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tegata/take/result.h"

namespace tegata {

/// A result in a few lines, to be read in ten seconds: how good it is, which frames not to trust
/// and why (frame_doubts.h), which angles are least sure and which bones were hardly seen. Each
/// line ends in a line break; there are never more than a dozen.
std::string fit_summary(const Result& result);

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tegata/experiment/table1.h"

namespace tegata {

/// The table for people, the paper's figures first.
std::string table1_text(const Table1& table);
/// One JSON object with every seed's figures and the weights.
std::string table1_json(const Table1& table);

}  // namespace tegata

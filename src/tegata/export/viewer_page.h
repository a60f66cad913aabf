// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace tegata {

/// The page of viewer/ as it was built, one file that needs no other: a template with
/// kReportPlace where the result belongs. Empty where the program was built without it
/// (TEGATA_VIEWER=OFF).
std::string_view viewer_page();

/// Throws Error where there is no page.
void require_viewer_page();

/// Where the JSON of the report goes.
inline constexpr std::string_view kReportPlace = "<!--tegata-report-->";

}  // namespace tegata

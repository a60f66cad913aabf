// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tegata/export/report_json.h"

namespace tegata {

/// A page of viewer_page() with the data in its place. Throws Error where the template has none.
std::string report_page(std::string_view page, std::string_view json);

/// Writes report.html: one page that carries everything it shows and needs no network. Throws Error
/// where the program was built without the page.
void write_report_page(const ReportContent& content, const std::filesystem::path& file);

}  // namespace tegata

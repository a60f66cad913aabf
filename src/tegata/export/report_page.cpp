// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_page.h"

#include "tegata/base/error.h"
#include "tegata/export/viewer_page.h"
#include "tegata/take/staged_folder.h"

namespace tegata {

std::string report_page(std::string_view page, std::string_view json) {
  const std::size_t place = page.find(kReportPlace);
  if (place == std::string_view::npos) {
    throw Error("report page: the template has no ", kReportPlace, " for the result");
  }
  std::string filled;
  filled.reserve(page.size() + json.size() + 100);
  filled += page.substr(0, place);
  filled += "<script type=\"application/json\" id=\"tegata-report\">";
  filled += json;
  filled += "</script>";
  filled += page.substr(place + kReportPlace.size());
  return filled;
}

void write_report_page(const ReportContent& content, const std::filesystem::path& file) {
  require_viewer_page();
  write_file(file, report_page(viewer_page(), report_json(content)));
}

}  // namespace tegata

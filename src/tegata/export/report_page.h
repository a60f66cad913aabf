// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tegata/image/image.h"
#include "tegata/take/result.h"

namespace tegata {

/// A picture of the report: which frame and camera it shows and its JPEG bytes.
struct ReportPicture {
  std::string frame, camera;
  std::vector<std::uint8_t> jpeg;
};

/// Writes report.html: one page that carries everything it shows and needs no network: a summary,
/// the frames with their status and overlaps, joint angles over time, support of each bone by
/// frame, pictures.
void write_report_page(const Result& result, const std::vector<ReportPicture>& pictures,
                       const std::filesystem::path& file);

}  // namespace tegata

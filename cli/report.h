// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The report page, for the commands that write one.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "tegata/base/observer.h"
#include "tegata/hand/hand_model.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/take/result.h"
#include "tegata/take/take.h"

namespace tegata {

/// What a report is made of. `hulls` are as report_hull() makes them, by frame.
struct ReportSource {
  Take* take = nullptr;  ///< absent: a page without cameras and pictures
  std::optional<SegmentationMethod> segmentation = std::nullopt;
  std::map<std::string, TriangleMesh> hulls = {};
  int threads = 0;
};

/// Writes report.html for a result, of a hand at the scale it was fitted with.
void write_report(const Result& result, const HandModel& hand, ReportSource source,
                  const std::filesystem::path& file, const Observer& observer);

}  // namespace tegata

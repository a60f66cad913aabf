// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/export/report_pictures.h"
#include "tegata/hand/hand_model.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/take/result.h"

namespace tegata {

/// What a report page shows. Without the take there are no cameras and no pictures.
struct ReportContent {
  const Result& result;
  const HandModel& hand;
  CameraRig rig;
  ReportPictures pictures;
  std::map<std::string, TriangleMesh> hulls;  ///< by frame, see report_hull()
};

/// Whose hulls a page of these frames can carry: those of all, or of a long take of evenly spread
/// ones. Others need not be kept for it.
std::set<std::string> frames_with_hull(const std::vector<std::string>& frames);

/// A visual hull as coarse as a page of so many frames can carry it.
TriangleMesh report_hull(const TriangleMesh& hull, std::size_t frame_count);

/// The page's data: one JSON object, "tegata-report" in docs/formats.md. `<` is written \u003c, so
/// that the text may stand in a script element.
std::string report_json(const ReportContent& content);

}  // namespace tegata

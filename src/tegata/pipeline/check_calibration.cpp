// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/check_calibration.h"

#include <algorithm>

#include "tegata/base/error.h"
#include "tegata/calibrate/hull_coverage.h"
#include "tegata/pipeline/frame_views.h"

namespace tegata {
namespace {

using Severity = CalibrationProblem::Severity;

// The undistorted cameras, which outlines are of.
CameraRig undistorted(const CameraRig& rig) {
  CameraRig ideal;
  for (const Camera& camera : rig) ideal.push_back(camera.undistorted());
  return ideal;
}

std::size_t camera_index(const CameraRig& rig, const std::string& name) {
  const auto found = std::find_if(rig.begin(), rig.end(),
                                  [&](const Camera& camera) { return camera.name == name; });
  return static_cast<std::size_t>(found - rig.begin());
}

// At most so many of the indices, spread evenly.
std::vector<std::size_t> spread(const std::vector<std::size_t>& indices, std::size_t most) {
  const std::size_t count = std::min(indices.size(), most);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(indices[i * indices.size() / count]);
  return chosen;
}

void throw_hard(const std::vector<CalibrationProblem>& problems, const Take& take) {
  for (const CalibrationProblem& problem : problems) {
    if (problem.severity == Severity::error) {
      throw Error((take.folder() / "calibration.toml").string(), ": ", problem.message);
    }
  }
}

void warn_of(const std::vector<CalibrationProblem>& problems, const Observer& observer) {
  for (const CalibrationProblem& problem : problems) {
    observer.warn("calibration: " + problem.message);
  }
}

RigOutlines outlines_of(const PreparedTake& prepared, const CameraRig& rig) {
  constexpr std::size_t kMostFrames = 24;
  RigOutlines outlines;
  for (const std::size_t i : spread(prepared.usable(), kMostFrames)) {
    outlines.emplace_back(rig.size());
    for (const HullView& view : prepared.frames().views(i)) {
      outlines.back()[camera_index(rig, view.camera.name)] =
          outline_rays(view.silhouette, view.camera);
    }
  }
  return outlines;
}

// What the check says of a take that cannot be prepared; empty where it says nothing.
std::string explanation(Take& take, const PrepareOptions& options) {
  CheckTakeOptions check;
  check.frames = options.frames;
  check.segmentation = options.segmentation;
  check.threads = options.threads;
  try {
    // Without an observer: what there is to say of the frames has been said.
    const TakeCheck found = check_take(take, check, Observer{});
    return found.calibration.agrees() ? "" : found.calibration.problems.front().message;
  } catch (const Error&) {
    return "";  // the take cannot be read, which is what the first Error says
  }
}

}  // namespace

TakeCheck check_take(Take& take, const CheckTakeOptions& options, const Observer& observer) {
  const Segmenter segmenter(take, options.segmentation, observer);
  const std::vector<std::size_t> indices =
      spread(selected_frames(options.frames, take), options.most_frames);
  const CameraRig rig = undistorted(take.rig());
  RigOutlines outlines(indices.size(), std::vector<std::optional<OutlineRays>>(take.rig().size()));
  std::vector<std::vector<double>> coverages(indices.size());
  std::vector<FrameViews> frames(indices.size());
  for_each_frame(take, indices, options.threads,
                 {.work =
                      [&](std::size_t i, const TakeFrame& pictures) {
                        FrameViews frame = frame_views(segmenter, pictures);
                        for (const HullView& view : frame.views) {
                          outlines[i][camera_index(rig, view.camera.name)] =
                              outline_rays(view.silhouette, view.camera);
                        }
                        if (frame.refusal.empty()) coverages[i] = hull_coverage(frame.views);
                        for (HullView& view : frame.views) view.silhouette = {};
                        frames[i] = std::move(frame);
                      },
                  .finish =
                      [&](std::size_t i) {
                        for (const std::string& note : frames[i].notes) observer.warn(note);
                      }},
                 observer);
  TakeCheck check;
  check.calibration = check_calibration(rig, outlines);
  std::map<std::string, double> counts;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    check.frame_count += frames[i].refusal.empty() ? 1 : 0;
    for (std::size_t v = 0; v < coverages[i].size(); ++v) {
      check.hull_coverage[frames[i].views[v].camera.name] += coverages[i][v];
      counts[frames[i].views[v].camera.name] += 1.0;
    }
  }
  for (auto& [camera, sum] : check.hull_coverage) sum /= counts[camera];
  return check;
}

void refuse_bad_numbers(const Take& take) { throw_hard(check_numbers(take.rig()), take); }

PreparedTake prepare_checked_take(Take& take, const PrepareOptions& options,
                                  const Observer& observer) {
  refuse_bad_numbers(take);
  try {
    PreparedTake prepared = prepare_take(take, options, observer);
    const CameraRig rig = undistorted(take.rig());
    const CalibrationCheck check = check_calibration(rig, outlines_of(prepared, rig));
    throw_hard(check.problems, take);
    warn_of(check.problems, observer);
    return prepared;
  } catch (const Error& error) {
    const std::string why = explanation(take, options);
    if (why.empty() || std::string_view(error.what()).find(why) != std::string_view::npos) throw;
    throw Error(error.what(), "; ", why);
  }
}

}  // namespace tegata

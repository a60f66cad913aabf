// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/fit_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tegata/base/angle.h"
#include "tegata/export/frame_doubts.h"

namespace tegata {
namespace {

constexpr std::size_t kMostDoubts = 5;  // lines

/// Frames in a row with the same thing against them.
struct DoubtfulRun {
  std::size_t first = 0, last = 0;
  std::string reason;
  double severity = 0.0;
};

std::vector<DoubtfulRun> doubtful_runs(const Result& result,
                                       const std::vector<FrameDoubt>& doubts) {
  std::vector<DoubtfulRun> runs;
  for (const FrameDoubt& doubt : doubts) {
    if (doubt.reasons.empty()) continue;
    const bool has_pose = result.frames[doubt.frame].pose.has_value();
    const std::string reason = (has_pose ? "" : "no pose: ") + doubt.reasons.front();
    if (!runs.empty() && runs.back().last + 1 == doubt.frame && runs.back().reason == reason) {
      runs.back().last = doubt.frame;
      runs.back().severity = std::max(runs.back().severity, doubt.severity);
    } else {
      runs.push_back({doubt.frame, doubt.frame, reason, doubt.severity});
    }
  }
  return runs;
}

/// The worst of them, in the frames' order, a line each.
std::string doubt_lines(const Result& result, std::vector<DoubtfulRun> runs) {
  std::size_t left_out = 0;
  if (runs.size() > kMostDoubts) {
    std::stable_sort(runs.begin(), runs.end(), [](const DoubtfulRun& a, const DoubtfulRun& b) {
      return a.severity > b.severity;
    });
    for (std::size_t i = kMostDoubts; i < runs.size(); ++i) {
      left_out += runs[i].last - runs[i].first + 1;
    }
    runs.resize(kMostDoubts);
    std::sort(runs.begin(), runs.end(),
              [](const DoubtfulRun& a, const DoubtfulRun& b) { return a.first < b.first; });
  }
  std::string lines;
  for (const DoubtfulRun& run : runs) {
    const std::string& first = result.frames[run.first].name;
    lines += run.first == run.last
                 ? fmt::format("  {}: {}\n", first, run.reason)
                 : fmt::format("  {} to {}: {}\n", first, result.frames[run.last].name, run.reason);
  }
  if (left_out > 0) lines += fmt::format("  and {} more\n", left_out);
  return lines;
}

/// "left 0.97, right 0.95", over the frames to be trusted.
std::string overlaps(const Result& result, const std::vector<FrameDoubt>& doubts) {
  std::map<std::string, std::pair<double, int>> sums;
  for (const FrameDoubt& doubt : doubts) {
    if (!doubt.reasons.empty()) continue;
    for (const auto& [camera, overlap] : result.frames[doubt.frame].silhouette_iou) {
      sums[camera].first += overlap;
      ++sums[camera].second;
    }
  }
  std::string list;
  for (const auto& [camera, sum] : sums) {
    list += fmt::format("{}{} {:.2f}", list.empty() ? "" : ", ", camera, sum.first / sum.second);
  }
  return list;
}

/// "index_dip_flexion by 12 deg", the worst first.
std::string unsure_angles(const Result& result) {
  constexpr double kSure = 3.0;  // [deg]
  constexpr std::size_t kMost = 3;
  std::vector<std::pair<double, std::string_view>> angles;
  for (int i = 0; i < kAngleCount; ++i) {
    const double deviation = kDegreesPerRadian * result.grasp_standard_deviations[i];
    if (deviation > kSure) {
      angles.emplace_back(deviation, angle_names()[static_cast<std::size_t>(i)]);
    }
  }
  std::stable_sort(angles.begin(), angles.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string list;
  for (std::size_t i = 0; i < std::min(kMost, angles.size()); ++i) {
    list +=
        fmt::format("{}{} by {:.0f} deg", i == 0 ? "" : ", ", angles[i].second, angles[i].first);
  }
  if (angles.size() > kMost) list += fmt::format(" and {} more", angles.size() - kMost);
  return list;
}

/// Of a start that hardly leads what was found elsewhere; else nothing.
std::string unsure_start(const Result& result) {
  constexpr double kSureLead = 1.1;  // as for the choice of a side
  if (!result.start || result.start->lead >= kSureLead) return {};
  return fmt::format(
      "unsure start: in frame {} a pose elsewhere has only {:.2f} times the energy; [initial_pose] "
      "in take.toml would decide\n",
      result.start->frame, result.start->lead);
}

/// The bones that the pictures say nearly nothing of: their angles are a guess.
std::string unseen_bones(const Result& result) {
  constexpr double kSeen = 0.1;
  std::array<double, kBoneCount> sums = {};
  std::size_t count = 0;
  for (const ResultFrame& frame : result.frames) {
    if (!frame.pose) continue;
    ++count;
    for (std::size_t bone = 0; bone < sums.size(); ++bone) sums[bone] += frame.support[bone];
  }
  std::string list;
  for (std::size_t bone = 0; bone < sums.size() && count > 0; ++bone) {
    if (sums[bone] >= kSeen * static_cast<double>(count)) continue;
    list += fmt::format("{}{}", list.empty() ? "" : ", ", bone_names()[bone]);
  }
  return list;
}

}  // namespace

std::string fit_summary(const Result& result) {
  const std::vector<FrameDoubt> doubts = frame_doubts(result);
  const FitVerdict verdict = fit_verdict(result, doubts);
  std::string lines = fmt::format("{}: {}\n", verdict.word, verdict.sentence);
  if (verdict.trusted < doubts.size()) {
    lines += "not to be trusted:\n" + doubt_lines(result, doubtful_runs(result, doubts));
  }
  if (verdict.trusted > 0) {
    lines += fmt::format("overlap with the silhouettes: {}\n", overlaps(result, doubts));
  }
  lines += unsure_start(result);
  if (const std::string angles = unsure_angles(result); !angles.empty()) {
    lines += fmt::format("least sure: {}\n", angles);
  }
  if (const std::string bones = unseen_bones(result); !bones.empty()) {
    lines += fmt::format("hardly seen, so guessed: {}\n", bones);
  }
  return lines;
}

}  // namespace tegata

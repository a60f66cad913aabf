// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/frame_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "tegata/math/median.h"

namespace tegata {
namespace {

// Lengths are those of a hand of scale 1.
//
// Something that hides the hand may leave little overlap; with all that is seen of the hand covered
// (by less than kCovered [m]) less is enough.
constexpr double kLeastOverlap = 0.5, kLeastCoveredOverlap = 0.25, kCovered = 5e-4;
constexpr double kLeastDrop = 0.15, kLeastJump = 0.03;
// More of a seen hand beside the fitted one than so much [m] and so many times what is usual in the
// frames' worst views: a hand of another shape has some in all.
constexpr double kMostUncovered = 1.5e-3, kMostUncoveredRatio = 3.0;
// A frame without all its cameras is where to look, but for those that are not to be trusted.
constexpr double kLeftOutSeverity = 0.6;
// Over all frames, of a result that is good and that is fair [m].
constexpr double kGoodUncovered = 5e-4, kFairUncovered = 4e-3;
constexpr double kSigmaOfDeviation = 1.4826;  // of a normal distribution
constexpr std::size_t kEnoughViews = 3, kFramesAround = 5;

using Reason = std::pair<double, std::string>;  // severity, words

double median_or_zero(std::vector<double> values) {
  return values.empty() ? 0.0 : median(std::move(values));
}

/// What a camera's overlap is in the frames around one, and how much it varies there. Overlaps
/// change slowly, as a held object hides more of the hand from one side than from another.
struct Usual {
  double overlap = 0.0, sigma = 0.0;
};

Usual usual_overlap(const Result& result, const std::string& camera, std::size_t around) {
  const std::size_t first = around - std::min(around, kFramesAround);
  const std::size_t end = std::min(result.frames.size(), around + kFramesAround + 1);
  std::vector<double> values;
  for (std::size_t i = first; i < end; ++i) {
    const auto found = result.frames[i].silhouette_iou.find(camera);
    if (found != result.frames[i].silhouette_iou.end()) values.push_back(found->second);
  }
  const double middle = median_or_zero(values);
  for (double& value : values) value = std::abs(value - middle);
  return {middle, kSigmaOfDeviation * median_or_zero(values)};
}

/// How far each wrist lies off the middle of the one before and the one after [m]; negative where
/// one of the three is missing. A single jump shows half as large in its neighbours.
std::vector<double> wrist_jumps(const std::vector<ResultFrame>& frames) {
  std::vector<double> jumps(frames.size(), -1.0);
  for (std::size_t i = 1; i + 1 < frames.size(); ++i) {
    if (!frames[i - 1].pose || !frames[i].pose || !frames[i + 1].pose) continue;
    const auto wrist = [&frames](std::size_t at) {
      return frames[at].pose->world_from_hand.translation;
    };
    jumps[i] = (wrist(i) - 0.5 * (wrist(i - 1) + wrist(i + 1))).norm();
  }
  return jumps;
}

double usual_jump(std::vector<double> jumps) {
  std::erase_if(jumps, [](double jump) { return jump < 0.0; });
  return median_or_zero(jumps);
}

double usual_view_count(const Result& result) {
  std::vector<double> counts;
  for (const ResultFrame& frame : result.frames) {
    if (frame.pose) counts.push_back(static_cast<double>(frame.views.size()));
  }
  return median_or_zero(counts);
}

bool is_covered(const Result& result, const ResultFrame& frame, const std::string& camera) {
  const auto found = frame.uncovered.find(camera);
  return found != frame.uncovered.end() && found->second < result.model_scale * kCovered;
}

/// The camera that sees most of a hand beside the fitted one; nothing where none can tell.
std::optional<std::pair<std::string, double>> most_uncovered(const ResultFrame& frame) {
  const auto most =
      std::max_element(frame.uncovered.begin(), frame.uncovered.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == frame.uncovered.end()) return std::nullopt;
  return *most;
}

double usual_uncovered(const Result& result) {
  std::vector<double> values;
  for (const ResultFrame& frame : result.frames) {
    if (const auto most = most_uncovered(frame)) values.push_back(most->second);
  }
  return median_or_zero(std::move(values));
}

void doubt_uncovered(const Result& result, std::size_t index, double usual, double& severity,
                     std::vector<Reason>& reasons) {
  const auto most = most_uncovered(result.frames[index]);
  if (!most) return;
  const double limit = result.model_scale * kMostUncovered;
  const double weight = 0.9 * std::min(1.0, most->second / (4.0 * limit));
  severity = std::max(severity, weight);
  if (most->second <= std::max(limit, kMostUncoveredRatio * usual)) return;
  reasons.emplace_back(weight, fmt::format("the hand in {} reaches {:.1f} mm beyond the fitted one",
                                           most->first, 1e3 * most->second));
}

/// "; camera_1 was left out of 3: it contradicts the other cameras", for each camera and reason.
std::string left_out_views(const Result& result) {
  std::map<std::pair<std::string, std::string>, std::size_t> counts;
  for (const ResultFrame& frame : result.frames) {
    for (const auto& [camera, why] : frame.left_out) ++counts[{camera, why}];
  }
  std::string list;
  for (const auto& [which, count] : counts) {
    list += fmt::format(" {} was left out of {}: {}.", which.first, count, which.second);
  }
  return list;
}

/// The mean over all frames of what is uncovered where most is [m].
double mean_uncovered(const Result& result) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const ResultFrame& frame : result.frames) {
    if (const auto most = most_uncovered(frame)) {
      sum += most->second;
      ++count;
    }
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

void doubt_overlaps(const Result& result, std::size_t index, double& severity,
                    std::vector<Reason>& reasons) {
  for (const auto& [camera, overlap] : result.frames[index].silhouette_iou) {
    const Usual expected = usual_overlap(result, camera, index);
    const double drop = expected.overlap - overlap;
    const double missing = 0.9 * std::clamp(1.0 - overlap, 0.0, 1.0);
    const double least =
        is_covered(result, result.frames[index], camera) ? kLeastCoveredOverlap : kLeastOverlap;
    severity = std::max(severity, missing);
    if (drop > std::max(kLeastDrop, 4.0 * expected.sigma)) {
      reasons.emplace_back(missing, fmt::format("overlap in {} {:.2f}, around it {:.2f}", camera,
                                                overlap, expected.overlap));
    } else if (overlap < least) {
      reasons.emplace_back(missing, fmt::format("overlap in {} only {:.2f}", camera, overlap));
    }
  }
}

}  // namespace

std::vector<FrameDoubt> frame_doubts(const Result& result) {
  const std::vector<double> jumps = wrist_jumps(result.frames);
  const double jump_limit = std::max(result.model_scale * kLeastJump, 6.0 * usual_jump(jumps));
  const double view_count = usual_view_count(result);
  const double uncovered = usual_uncovered(result);
  std::vector<FrameDoubt> doubts;
  for (std::size_t i = 0; i < result.frames.size(); ++i) {
    const ResultFrame& frame = result.frames[i];
    double severity = 0.0;
    std::vector<Reason> reasons;
    if (!frame.pose) {
      severity = 1.0;
      reasons.emplace_back(1.0, frame.status);
    } else {
      if (frame.status != "ok") reasons.emplace_back(0.95, frame.status);
      doubt_overlaps(result, i, severity, reasons);
      doubt_uncovered(result, i, uncovered, severity, reasons);
      if (!frame.left_out.empty()) severity = std::max(severity, kLeftOutSeverity);
      if (frame.views.size() < kEnoughViews &&
          static_cast<double>(frame.views.size()) < view_count) {
        reasons.emplace_back(0.5, fmt::format("seen by {} cameras only", frame.views.size()));
      }
      if (jumps[i] > jump_limit && jumps[i] >= std::max(jumps[i - 1], jumps[i + 1])) {
        reasons.emplace_back(0.6, fmt::format("the wrist jumps by {:.0f} mm", 1e3 * jumps[i]));
      }
    }
    std::stable_sort(reasons.begin(), reasons.end(),
                     [](const Reason& a, const Reason& b) { return a.first > b.first; });
    FrameDoubt doubt{i, severity, frame.pose.has_value(), {}};
    for (const auto& [weight, words] : reasons) {
      doubt.severity = std::max(doubt.severity, weight);
      doubt.reasons.push_back(words);
    }
    doubts.push_back(std::move(doubt));
  }
  return doubts;
}

std::size_t worst_frame(const std::vector<FrameDoubt>& doubts) {
  const auto rank = [](const FrameDoubt& doubt) {
    const int kind = doubt.reasons.empty() ? 0 : (doubt.has_pose ? 2 : 1);
    return std::pair(kind, doubt.severity);
  };
  const auto worst = std::max_element(
      doubts.begin(), doubts.end(),
      [&rank](const FrameDoubt& a, const FrameDoubt& b) { return rank(a) < rank(b); });
  return worst == doubts.end() ? 0 : worst->frame;
}

FitVerdict fit_verdict(const Result& result, const std::vector<FrameDoubt>& doubts) {
  FitVerdict verdict;
  std::size_t overlap_count = 0;
  for (const FrameDoubt& doubt : doubts) {
    if (!doubt.reasons.empty()) continue;
    ++verdict.trusted;
    for (const auto& [camera, overlap] : result.frames[doubt.frame].silhouette_iou) {
      verdict.mean_overlap += overlap;
      ++overlap_count;
    }
  }
  if (overlap_count > 0) verdict.mean_overlap /= static_cast<double>(overlap_count);
  const double share =
      doubts.empty() ? 0.0
                     : static_cast<double>(verdict.trusted) / static_cast<double>(doubts.size());
  // A cold object eats up to half of a silhouette; what is left must still be covered.
  const double uncovered = mean_uncovered(result);
  const auto reaches = [&](double least_share, double least_overlap, double most_uncovered) {
    return share >= least_share && verdict.mean_overlap >= least_overlap &&
           uncovered <= result.model_scale * most_uncovered;
  };
  verdict.word = reaches(0.9, 0.75, kGoodUncovered)  ? "good"
                 : reaches(0.6, 0.6, kFairUncovered) ? "fair"
                                                     : "poor";
  verdict.sentence = fmt::format("{} of {} frames can be trusted.{}", verdict.trusted,
                                 doubts.size(), left_out_views(result));
  if (uncovered > result.model_scale * kGoodUncovered) {
    verdict.sentence += fmt::format(
        " The seen hand reaches {:.1f} mm beyond the fitted one: its pose, its size or a camera "
        "may "
        "be wrong.",
        1e3 * uncovered);
  }
  return verdict;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/agreeing_pieces.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "tegata/base/angle.h"
#include "tegata/calibrate/tangency.h"
#include "tegata/segment/components.h"

namespace tegata {
namespace {

using Outline = std::optional<OutlineRays>;

// The outlines of each camera's candidates.
std::vector<std::vector<Outline>> outlines_of(const CameraRig& rig,
                                              const HandCandidates& candidates) {
  std::vector<std::vector<Outline>> outlines;
  for (std::size_t c = 0; c < rig.size(); ++c) {
    outlines.emplace_back();
    for (const Silhouette& silhouette : candidates[c]) {
      outlines.back().push_back(outline_rays(silhouette, rig[c]));
    }
  }
  return outlines;
}

// What two candidates cost that stand for the same thing. Those without whole tangents prove
// nothing, which is not as good as to agree.
double pair_cost(const CameraRig& rig, std::size_t a, std::size_t b, const Outline& in_a,
                 const Outline& in_b) {
  constexpr double kUnproven = 2.0 * kDegree, kMost = 30.0 * kDegree;
  if (!in_a || !in_b) return kMost;
  const auto pairs = pair_tangencies({rig[a], rig[b]}, {{in_a, in_b}});
  return pairs.empty() ? kUnproven : std::min(pairs.front().median, kMost);
}

// The costs of all pairs of candidates of two cameras.
struct PairCosts {
  std::size_t a, b;
  std::vector<std::vector<double>> cost;
};

std::vector<PairCosts> pair_costs(const CameraRig& rig,
                                  const std::vector<std::vector<Outline>>& outlines) {
  std::vector<PairCosts> costs;
  for (std::size_t a = 0; a < rig.size(); ++a) {
    for (std::size_t b = a + 1; b < rig.size(); ++b) {
      if (outlines[a].empty() || outlines[b].empty()) continue;
      costs.push_back({a, b, {}});
      for (const Outline& in_a : outlines[a]) {
        costs.back().cost.emplace_back();
        for (const Outline& in_b : outlines[b]) {
          costs.back().cost.back().push_back(pair_cost(rig, a, b, in_a, in_b));
        }
      }
    }
  }
  return costs;
}

double cost_of(const std::vector<PairCosts>& pairs, const std::vector<std::size_t>& choice) {
  double sum = 0.0;
  for (const PairCosts& pair : pairs) sum += pair.cost[choice[pair.a]][choice[pair.b]];
  return pairs.empty() ? 0.0 : sum / static_cast<double>(pairs.size());
}

// Goes on to the next choice, the first camera's first; false after the last.
bool advance(std::vector<std::size_t>& choice, const std::vector<std::size_t>& counts) {
  for (std::size_t c = 0; c < choice.size(); ++c) {
    if (++choice[c] < counts[c]) return true;
    choice[c] = 0;
  }
  return false;
}

// The silhouette with so many pixels more on all sides: what shines and blurs beside it.
Silhouette widened(const Silhouette& silhouette, int margin) {
  Silhouette wide(silhouette.width(), silhouette.height(), PixelLabel::background);
  for (int y = 0; y < silhouette.height(); ++y) {
    for (int x = 0; x < silhouette.width(); ++x) {
      if (silhouette(x, y) != PixelLabel::hand) continue;
      const int first = std::max(0, x - margin);
      while (x < silhouette.width() && silhouette(x, y) == PixelLabel::hand) ++x;
      const int last = std::min(silhouette.width(), x + margin) - 1;
      for (int v = std::max(0, y - margin); v <= std::min(wide.height() - 1, y + margin); ++v) {
        std::fill(&wide(first, v), &wide(last, v) + 1, PixelLabel::hand);
      }
    }
  }
  return wide;
}

// Fills the columns [first, last) of a row between what is on their left and right; a whole row is
// that above it.
void fill_run(Image<std::uint16_t>& values, int y, int first, int last) {
  const bool has_left = first > 0, has_right = last < values.width();
  if (!has_left && !has_right && y == 0) return;
  for (int x = first; x < last; ++x) {
    for (int channel = 0; channel < values.channels(); ++channel) {
      if (!has_left && !has_right) {
        values(x, y, channel) = values(x, y - 1, channel);
        continue;
      }
      const int left = values(has_left ? first - 1 : last, y, channel);
      const int right = values(has_right ? last : first - 1, y, channel);
      values(x, y, channel) =
          static_cast<std::uint16_t>(left + (right - left) * (x - first + 1) / (last - first + 1));
    }
  }
}

// How many candidates of each camera are tried: all, unless there are too many combinations.
std::vector<std::size_t> tried_counts(const HandCandidates& candidates) {
  constexpr double kMost = 20000.0;
  std::vector<std::size_t> counts;
  for (const auto& of_camera : candidates)
    counts.push_back(std::max<std::size_t>(1, of_camera.size()));
  for (;;) {
    double product = 1.0;
    for (const std::size_t count : counts) product *= static_cast<double>(count);
    if (product <= kMost) return counts;
    --*std::max_element(counts.begin(), counts.end());
  }
}

}  // namespace

double disagreement(const CameraRig& rig, const std::vector<std::optional<Silhouette>>& views) {
  RigOutlines outlines(1);
  for (std::size_t c = 0; c < rig.size(); ++c) {
    outlines[0].push_back(views[c] ? outline_rays(*views[c], rig[c]) : std::nullopt);
  }
  return tangency_cost(pair_tangencies(rig, outlines));
}

std::vector<Silhouette> pieces_alone(const Silhouette& silhouette) {
  constexpr std::size_t kMostPieces = 3;
  constexpr double kLeastShare = 0.1;  // of the largest
  std::vector<Silhouette> pieces;
  Silhouette left = silhouette;
  std::size_t largest = 0;
  while (pieces.size() < kMostPieces) {
    Silhouette piece = left;
    keep_large_components(piece, 1.0);
    const std::size_t pixels = count_pixels(piece, PixelLabel::hand);
    largest = std::max(largest, pixels);
    if (pixels == 0 || static_cast<double>(pixels) < kLeastShare * static_cast<double>(largest)) {
      break;
    }
    for (std::size_t i = 0; i < left.values().size(); ++i) {
      if (piece.values()[i] == PixelLabel::hand) left.values()[i] = PixelLabel::background;
    }
    pieces.push_back(std::move(piece));
  }
  if (pieces.size() == 1) pieces.clear();
  return pieces;
}

CameraImage without_hand(const CameraImage& picture, const Silhouette& silhouette) {
  CameraImage filled = picture;
  const Silhouette covered = widened(silhouette, 2 + silhouette.width() / 100);
  for (int y = 0; y < covered.height(); ++y) {
    for (int x = 0; x < covered.width(); ++x) {
      if (covered(x, y) != PixelLabel::hand) continue;
      const int first = x;
      while (x < covered.width() && covered(x, y) == PixelLabel::hand) ++x;
      fill_run(filled.values, y, first, x);
    }
  }
  return filled;
}

std::vector<std::size_t> agreeing_candidates(const CameraRig& rig,
                                             const HandCandidates& candidates) {
  constexpr double kFarBetter = 0.4;  // of the cost of the first ones
  constexpr double kAgreement = 2.0 * kDegree;
  constexpr double kLater = 1e-3 * kDegree;  // of what costs the same, the likelier
  const auto costs = pair_costs(rig, outlines_of(rig, candidates));
  const std::vector<std::size_t> counts = tried_counts(candidates);
  const std::vector<std::size_t> firsts(rig.size(), 0);
  std::vector<std::size_t> choice = firsts, best = firsts;
  double least = std::numeric_limits<double>::infinity();
  do {
    double cost = cost_of(costs, choice);
    for (const std::size_t index : choice) cost += kLater * static_cast<double>(index);
    if (cost < least) {
      least = cost;
      best = choice;
    }
  } while (advance(choice, counts));
  return least <= std::min(kAgreement, kFarBetter * cost_of(costs, firsts)) ? best : firsts;
}

}  // namespace tegata

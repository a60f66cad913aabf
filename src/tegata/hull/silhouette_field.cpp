// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/silhouette_field.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "tegata/base/error.h"

namespace tegata {
namespace {

std::size_t count_views(ViewSet views) { return static_cast<std::size_t>(std::popcount(views)); }

void check_view(const HullView& view) {
  check_camera(view.camera);
  if (view.camera.is_distorted()) {
    throw Error("hull: camera '", view.camera.name,
                "' has lens distortion, expected undistorted views: Undistortion gives silhouette "
                "and camera");
  }
  if (view.silhouette.width() != view.camera.width ||
      view.silhouette.height() != view.camera.height) {
    throw Error("hull: camera '", view.camera.name, "': got a silhouette of ",
                view.silhouette.width(), " x ", view.silhouette.height(),
                ", expected the camera's ", view.camera.width, " x ", view.camera.height);
  }
  if (view.camera.width < 2 || view.camera.height < 2) {
    throw Error("hull: camera '", view.camera.name, "': got a picture of ", view.camera.width,
                " x ", view.camera.height, " pixels, expected 2 x 2 or more");
  }
}

// More than half of the views, and at least two.
std::size_t majority(std::size_t view_count) {
  return std::max(std::size_t{2}, view_count / 2 + 1);
}

void check_options(const HullOptions& options, std::size_t view_count) {
  if (!(options.voxel_size > 0.0) || !std::isfinite(options.voxel_size)) {
    throw Error("hull: got voxel_size = ", options.voxel_size, " m, expected a positive size");
  }
  if (view_count < 2 || view_count > kMostViews) {
    throw Error("hull: got ", view_count, " views, expected 2 to ", kMostViews);
  }
  const int count = static_cast<int>(view_count), asked = options.least_views;
  const int least = asked == 0 ? static_cast<int>(majority(view_count)) : asked;
  if (least < 1 || least > count) {
    throw Error("hull: got least_views = ", least, ", expected 1 to the number of views, ", count,
                ", or 0 to have it chosen");
  }
  const int most = std::min(least - 1, static_cast<int>(kMostDissentingViews));
  if (options.dissenting_views < 0 || options.dissenting_views > most) {
    throw Error("hull: got dissenting_views = ", options.dissenting_views, ", expected 0 to ", most,
                ": fewer than the ", least, " views that must see a point");
  }
}

// For each view the views that look across it: neither along with it nor towards it.
std::vector<ViewSet> views_across(const std::vector<Eigen::Vector3d>& directions) {
  constexpr double kLeastSine = 0.7071;  // of 45 and of 135 degrees
  std::vector<ViewSet> across(directions.size(), 0);
  for (std::size_t a = 0; a < directions.size(); ++a) {
    for (std::size_t b = 0; b < directions.size(); ++b) {
      const bool is_across = directions[a].cross(directions[b]).norm() > kLeastSine;
      if (is_across) across[a] |= ViewSet{1} << b;
    }
  }
  return across;
}

}  // namespace

SilhouetteField::SilhouetteField(const std::vector<HullView>& views, const HullOptions& options) {
  check_options(options, views.size());
  std::string empty_views;
  std::size_t empty_count = 0;
  bool has_hand = false;
  views_.reserve(views.size());
  for (const HullView& source : views) {
    check_view(source);
    const SilhouetteTable& view = views_.emplace_back(source);
    has_hand = has_hand || view.has_hand();
    if (!view.foreground().isEmpty()) continue;
    empty_views += text(empty_count++ == 0 ? "'" : ", '", source.camera.name, "'");
  }
  set_rule(options);
  if (empty_count > rule_.dissenting_views) {
    throw Error("hull: the silhouette of ", empty_views,
                " is all background, expected hand pixels in every view (or unknown ones where "
                "something stands before the hand): is the mask or the segmentation right?");
  }
  if (!has_hand) {
    throw Error(
        "hull: no view has a pixel that is hand, expected some: unknown pixels alone prove "
        "nothing");
  }
}

void SilhouetteField::set_rule(const HullOptions& options) {
  rule_.dissenting_views = static_cast<std::size_t>(options.dissenting_views);
  rule_.outside_value = -static_cast<float>(options.voxel_size);
  if (options.least_views > 0) {
    rule_.least_views = static_cast<std::size_t>(options.least_views);
    return;
  }
  std::vector<Eigen::Vector3d> directions;
  for (std::size_t i = 0; i < views_.size(); ++i) directions.push_back(middle_direction(i));
  rule_.across = views_across(directions);
  // Of many views two are too few: what clutters the pictures lies across each other somewhere.
  rule_.least_across = std::max<std::size_t>(2, views_.size() / 4) + rule_.dissenting_views;
  rule_.least_views = majority(views_.size());
}

SilhouetteField SilhouetteField::by_number() const {
  SilhouetteField strict = *this;
  strict.rule_.across.clear();
  return strict;
}

Eigen::Vector3d SilhouetteField::middle_direction(std::size_t view) const {
  const Eigen::AlignedBox2i box = foreground(view);
  const Eigen::Vector2d middle =
      box.isEmpty() ? Eigen::Vector2d(0.5 * camera(view).width, 0.5 * camera(view).height)
                    : Eigen::Vector2d(0.5 * (box.min() + box.max()).cast<double>());
  return pixel_direction(camera(view), middle);
}

void SilhouetteField::prepare_sampling(const OctreeRoot& root) {
  root_ = root;
  double largest_value = 0.0;
  for (const SilhouetteTable& view : views_) {
    largest_value = std::max(largest_value, view.leaf_reach(root));
  }
  rule_.largest_value = static_cast<float>(largest_value);
  sampled_views_.clear();
  for (SilhouetteTable& view : views_) {
    sampled_views_.push_back(view.prepare_sampling(root, largest_value));
  }
}

void SilhouetteField::sample(const LatticeIndex& low, const State& state,
                             SilhouetteBlock& block) const {
  const BlockKnowledge known{certain_views(low, state.inside), state.whole};
  sample_block(sampled_views_, rule_, known, low, instruction_set_, block);
}

ViewSet SilhouetteField::certain_views(const LatticeIndex& low, ViewSet inside) const {
  const double half_side = 0.5 * kBlockCells * root_.cell_size;
  const Eigen::Vector3d center = root_.origin +
                                 root_.cell_size * Eigen::Vector3d(low[0], low[1], low[2]) +
                                 Eigen::Vector3d::Constant(half_side);
  ViewSet certain = 0;
  for (; inside != 0; inside &= inside - 1) {
    const int view = std::countr_zero(inside);
    if (views_[static_cast<std::size_t>(view)].is_surely_inside(center, half_side)) {
      certain |= ViewSet{1} << view;
    }
  }
  return certain;
}

SilhouetteField SilhouetteField::without(std::size_t view) const {
  SilhouetteField rest = by_number();
  rest.views_.erase(rest.views_.begin() + static_cast<std::ptrdiff_t>(view));
  rest.rule_.least_views = std::min(rule_.least_views, rest.views_.size());
  rest.rule_.dissenting_views = std::min(rule_.dissenting_views, rest.rule_.least_views - 1);
  return rest;
}

Occupancy SilhouetteField::classify(const Eigen::Vector3d& center, double half_side,
                                    State& state) const {
  ViewSet outside_in_part = 0, inside_in_part = 0;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const ViewSet bit = ViewSet{1} << i;
    if (((state.inside | state.outside | state.blind) & bit) != 0) continue;
    const SilhouetteTable::Judgement judgement = views_[i].judge(center, half_side);
    if (judgement.sees_all) state.whole |= bit;
    switch (judgement.verdict) {
      case SilhouetteTable::Verdict::outside:
        state.outside |= bit;
        break;
      case SilhouetteTable::Verdict::blind:
        state.blind |= bit;
        break;
      case SilhouetteTable::Verdict::inside:
        state.inside |= bit;
        break;
      case SilhouetteTable::Verdict::outside_as_far_as_seen:
        outside_in_part |= bit;
        break;
      case SilhouetteTable::Verdict::inside_as_far_as_seen:
        inside_in_part |= bit;
        break;
      case SilhouetteTable::Verdict::undecided:
        break;
    }
    if (count_views(state.outside) > rule_.dissenting_views) return Occupancy::outside;
  }
  // A point that survives is seen by so many views at most: where no more may dissent, none of
  // those that see background wherever they see anything.
  ViewSet may_see = ~state.blind & (~ViewSet{0} >> (kMostViews - views_.size()));
  if (count_views(state.outside) == rule_.dissenting_views) may_see &= ~outside_in_part;
  if (!rule_.suffices(may_see)) return Occupancy::outside;
  const ViewSet content = state.inside | inside_in_part | state.blind;
  return views_.size() - count_views(content) <= rule_.dissenting_views &&
                 rule_.suffices(state.whole)
             ? Occupancy::inside
             : Occupancy::mixed;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Space carving (Kutulakos and Seitz 2000) the other way round: the object is dark in front of
// what is known to be bright.
#include "tegata/fit/hidden_object.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tegata/base/parallel.h"
#include "tegata/hull/leaf_components.h"
#include "tegata/hull/marching_cubes.h"
#include "tegata/hull/octree.h"
#include "tegata/image/banded_distance.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

constexpr double kSmallestPiece = 0.2;  // of the largest one

// A view of the hand where it is estimated to be, and what the pixels say.
struct DrawnView {
  const FitView* view;
  Rigid3d camera_from_hand;
  Eigen::Vector3d eye_in_hand;
  Image<float> depth;  // of the drawn hand [m]; infinite beside it
  // How far inside the drawn hand, beyond the wrist, up to a little more than the margin asked for;
  // negative outside.
  Image<float> inside_px;
};

DrawnView drawn(const FitHand& hand, const TriangleMesh& in_world, const Rigid3d& world_from_hand,
                const FitView& view, double margin_px) {
  DrawnView result;
  result.view = &view;
  result.camera_from_hand = view.camera.camera_from_world * world_from_hand;
  result.eye_in_hand = result.camera_from_hand.inverse().translation;
  const RenderedMesh picture = render(in_world, view.camera);
  Image<std::uint8_t> beyond_wrist(view.camera.width, view.camera.height, 0);
  for (int y = 0; y < beyond_wrist.height(); ++y) {
    for (int x = 0; x < beyond_wrist.width(); ++x) {
      const std::int32_t triangle = picture.triangle(x, y);
      if (triangle < 0) continue;
      const Triangle& corners = in_world.triangles[static_cast<std::size_t>(triangle)];
      beyond_wrist(x, y) = hand.beyond_wrist[corners[0]];
    }
  }
  result.inside_px = banded_distance(beyond_wrist, static_cast<int>(margin_px) + 2);
  result.depth = picture.depth;
  return result;
}

enum class Vote { none, free, blocked };

Vote vote(const DrawnView& drawn, const Eigen::Vector3d& point_in_hand,
          const HiddenObjectOptions& options, double skin) {
  const Eigen::Vector3d point = drawn.camera_from_hand * point_in_hand;
  const Camera& camera = drawn.view->camera;
  if (!(point.z() > 0.0)) return Vote::none;
  const int x = static_cast<int>(std::lround(camera.fx * point.x() / point.z() + camera.cx));
  const int y = static_cast<int>(std::lround(camera.fy * point.y() / point.z() + camera.cy));
  if (!drawn.depth.contains(x, y) || drawn.view->is_forearm(Eigen::Vector2d(x, y))) {
    return Vote::none;
  }
  const double depth = drawn.depth(x, y);
  if (!(point.z() < depth - skin) || std::isinf(depth)) return Vote::none;
  switch (drawn.view->silhouette(x, y)) {
    case PixelLabel::hand:
      return Vote::free;
    case PixelLabel::unknown:
      return Vote::none;
    case PixelLabel::background:
      break;
  }
  const bool is_hidden = drawn.inside_px(x, y) > options.margin_px &&
                         (*drawn.view->hand_distance)(x, y) < -options.margin_px;
  return is_hidden ? Vote::blocked : Vote::none;
}

struct Votes {
  float free = 0.0F, blocked = 0.0F;
  Eigen::Vector3f blocked_along = Eigen::Vector3f::Zero();  // sum of the rays' directions

  // 0 where all blocked rays run alike: then nothing tells how far along them the object stands.
  float spread() const { return blocked > 0.0F ? 1.0F - blocked_along.norm() / blocked : 0.0F; }
};

// Votes on the voxels of a box of the hand's frame.
class VotedGrid {
 public:
  VotedGrid(const Eigen::AlignedBox3d& box, double voxel_size)
      : origin_(box.min()), voxel_size_(voxel_size) {
    const Eigen::Array3d cells = (box.sizes().array() / voxel_size).ceil();
    size_ = cells.cast<int>() + 1;
    votes_.resize(static_cast<std::size_t>(size_.prod()));
  }

  void add(const std::vector<DrawnView>& views, const HiddenObjectOptions& options, double skin,
           int threads) {
    parallel_for(static_cast<std::size_t>(size_.z()), threads, [&](std::size_t z) {
      for (int y = 0; y < size_.y(); ++y) {
        for (int x = 0; x < size_.x(); ++x) {
          const Eigen::Array3i index(x, y, static_cast<int>(z));
          Votes& votes = votes_[place(index)];
          for (const DrawnView& view : views) {
            const Vote said = vote(view, point(index), options, skin);
            if (said == Vote::free) votes.free += 1.0F;
            if (said != Vote::blocked) continue;
            votes.blocked += 1.0F;
            votes.blocked_along += (point(index) - view.eye_in_hand).normalized().cast<float>();
          }
        }
      }
    });
  }

  const Votes& at(const Eigen::Vector3d& point) const { return votes_[place(nearest(point))]; }
  const Votes& operator[](const Eigen::Array3i& index) const { return votes_[place(index)]; }
  /// The voxel nearest to a point; that on the face beyond which the point lies.
  Eigen::Array3i nearest(const Eigen::Vector3d& point) const {
    return ((point - origin_).array() / voxel_size_).round().cast<int>().max(0).min(size_ - 1);
  }
  const Eigen::Array3i& size() const { return size_; }
  Eigen::AlignedBox3d box() const { return {point(Eigen::Array3i::Zero()), point(size_ - 1)}; }

 private:
  std::size_t place(const Eigen::Array3i& index) const {
    return static_cast<std::size_t>((index.z() * size_.y() + index.y()) * size_.x() + index.x());
  }
  Eigen::Vector3d point(const Eigen::Array3i& index) const {
    return origin_ + voxel_size_ * index.cast<double>().matrix();
  }

  Eigen::Vector3d origin_;
  double voxel_size_;
  Eigen::Array3i size_;
  std::vector<Votes> votes_;
};

// Positive where the votes make an object, between -1 and 1.
float evidence(const Votes& votes, const HiddenObjectOptions& options) {
  const double known = std::min(votes.spread() / options.least_spread, 1.0);
  const double balance = known * votes.blocked - options.blocked_per_free * votes.free;
  return static_cast<float>(std::clamp(balance / options.least_blocked - 0.9, -1.0, 1.0));
}

// The evidence on a grid, each the mean of a voxel and its neighbours: single voxels are chance,
// and stairs are none of it.
class SmoothEvidence {
 public:
  SmoothEvidence(const VotedGrid& grid, const HiddenObjectOptions& options, int threads)
      : grid_(grid), size_(grid.size()) {
    const auto count = static_cast<std::size_t>(size_.prod());
    std::vector<float> raw(count);
    each_voxel(threads, [&](const Eigen::Array3i& index, std::size_t i) {
      raw[i] = evidence(grid[index], options);
    });
    values_.resize(count);
    each_voxel(threads, [&](const Eigen::Array3i& index, std::size_t i) {
      constexpr float kCenter = 2.0F;
      float sum = kCenter * raw[i];
      for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
          Eigen::Array3i neighbour = index;
          neighbour[axis] = std::clamp(index[axis] + side, 0, size_[axis] - 1);
          sum += raw[place(neighbour)];
        }
      }
      values_[i] = sum / (kCenter + 6.0F);
    });
  }

  float at(const Eigen::Vector3d& point) const { return values_[place(grid_.nearest(point))]; }
  bool is_any_positive(const Eigen::AlignedBox3d& box) const {
    // A point half-way between two voxels may be given to either.
    const Eigen::Vector3d slack = 1e-6 * box.sizes();
    const Eigen::Array3i low = grid_.nearest(box.min() - slack);
    const Eigen::Array3i high = grid_.nearest(box.max() + slack);
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        const float* row = &values_[place({0, y, z})];
        if (std::any_of(row + low.x(), row + high.x() + 1, [](float v) { return v > 0.0F; })) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  template <typename Body>
  void each_voxel(int threads, const Body& body) const {
    parallel_for(static_cast<std::size_t>(size_.z()), threads, [&](std::size_t z) {
      for (int y = 0; y < size_.y(); ++y) {
        for (int x = 0; x < size_.x(); ++x) {
          const Eigen::Array3i index(x, y, static_cast<int>(z));
          body(index, place(index));
        }
      }
    });
  }
  std::size_t place(const Eigen::Array3i& index) const {
    return static_cast<std::size_t>((index.z() * size_.y() + index.y()) * size_.x() + index.x());
  }

  const VotedGrid& grid_;
  Eigen::Array3i size_;
  std::vector<float> values_;
};

TriangleMesh surface_of(const VotedGrid& grid, const HiddenObjectOptions& options, double voxel,
                        int threads) {
  const SmoothEvidence smooth(grid, options, threads);
  FieldSource source;
  source.classify = [&](const Eigen::AlignedBox3d& box) {
    return smooth.is_any_positive(box) ? Occupancy::mixed : Occupancy::outside;
  };
  source.sample = [&](const Eigen::Vector3d& point, bool&) { return smooth.at(point); };
  return extract_isosurface(
      without_small_components(build_octree(grid.box(), voxel, source), kSmallestPiece));
}

}  // namespace

HiddenObject find_hidden_object(const FitHand& hand, std::span<const FitFrame* const> frames,
                                const HandEstimate& estimate, const HiddenObjectOptions& options,
                                int threads) {
  const double voxel = options.voxel_size * hand.scale;
  Eigen::AlignedBox3d box;
  const PosedHand at_origin = hand.posed({Rigid3d(), estimate.angles});
  for (std::size_t i = 0; i < at_origin.vertices().size(); ++i) {
    if (hand.beyond_wrist[i] != 0) box.extend(at_origin.vertices()[i]);
  }
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(options.reach * hand.scale);
  VotedGrid grid({box.min() - reach, box.max() + reach}, voxel);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const TriangleMesh surface = hand.posed(estimate.pose(f)).surface();
    std::vector<DrawnView> views(frames[f]->views.size());
    parallel_for(views.size(), threads, [&](std::size_t v) {
      views[v] =
          drawn(hand, surface, estimate.world_from_hand[f], frames[f]->views[v], options.margin_px);
    });
    grid.add(views, options, options.skin * hand.scale, threads);
  }
  HiddenObject object;
  object.surface = surface_of(grid, options, voxel, threads);
  for (const Eigen::Vector3d& vertex : object.surface.vertices) {
    const Votes& votes = grid.at(vertex);
    const double many = 1.0 - std::exp(-votes.blocked / options.least_blocked);
    object.confidence.push_back(
        static_cast<float>(many * votes.blocked / std::max(votes.blocked + votes.free, 1.0F)));
  }
  return object;
}

}  // namespace tegata

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

// The voxels of a box, one after the other, x fastest.
class Voxels {
 public:
  Voxels(const Eigen::AlignedBox3d& box, double size)
      : origin_(box.min()),
        size_(size),
        counts_((box.sizes().array() / size).ceil().cast<int>() + 1) {}

  std::size_t count() const { return static_cast<std::size_t>(counts_.prod()); }
  std::size_t place(const Eigen::Array3i& index) const {
    return static_cast<std::size_t>((index.z() * counts_.y() + index.y()) * counts_.x() +
                                    index.x());
  }
  Eigen::Vector3d point(const Eigen::Array3i& index) const {
    return origin_ + size_ * index.cast<double>().matrix();
  }
  // The voxel nearest to an index or a point; for what lies beyond a face, one on that face.
  Eigen::Array3i within(const Eigen::Array3i& index) const { return index.max(0).min(counts_ - 1); }
  Eigen::Array3i nearest(const Eigen::Vector3d& point) const {
    return within(((point - origin_).array() / size_).round().cast<int>());
  }
  Eigen::AlignedBox3d box() const { return {point(Eigen::Array3i::Zero()), point(counts_ - 1)}; }

  template <typename Body>
  void each(int threads, const Body& body) const {
    parallel_for(static_cast<std::size_t>(counts_.z()), threads, [&](std::size_t z) {
      for (int y = 0; y < counts_.y(); ++y) {
        for (int x = 0; x < counts_.x(); ++x) body(Eigen::Array3i(x, y, static_cast<int>(z)));
      }
    });
  }

 private:
  Eigen::Vector3d origin_;
  double size_;
  Eigen::Array3i counts_;
};

void add_votes(const Voxels& voxels, const std::vector<DrawnView>& views,
               const HiddenObjectOptions& options, double skin, int threads,
               std::vector<Votes>& all_votes) {
  voxels.each(threads, [&](const Eigen::Array3i& index) {
    const Eigen::Vector3d point = voxels.point(index);
    Votes& votes = all_votes[voxels.place(index)];
    for (const DrawnView& view : views) {
      const Vote said = vote(view, point, options, skin);
      if (said == Vote::free) votes.free += 1.0F;
      if (said != Vote::blocked) continue;
      votes.blocked += 1.0F;
      votes.blocked_along += (point - view.eye_in_hand).normalized().cast<float>();
    }
  });
}

// Positive where the votes make an object, between -1 and 1.
float evidence(const Votes& votes, const HiddenObjectOptions& options) {
  const double known = std::min(votes.spread() / options.least_spread, 1.0);
  const double balance = known * votes.blocked - options.blocked_per_free * votes.free;
  return static_cast<float>(std::clamp(balance / options.least_blocked - 0.9, -1.0, 1.0));
}

// The evidence, for each voxel the mean of its own and its neighbours': single voxels are chance,
// and stairs are none of it.
std::vector<float> smooth_evidence(const Voxels& voxels, const std::vector<Votes>& votes,
                                   const HiddenObjectOptions& options, int threads) {
  std::vector<float> raw(votes.size()), smooth(votes.size());
  std::transform(votes.begin(), votes.end(), raw.begin(),
                 [&](const Votes& of_voxel) { return evidence(of_voxel, options); });
  voxels.each(threads, [&](const Eigen::Array3i& index) {
    constexpr float kCenter = 2.0F;
    float sum = kCenter * raw[voxels.place(index)];
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Eigen::Array3i neighbour = index;
        neighbour[axis] += side;
        sum += raw[voxels.place(voxels.within(neighbour))];
      }
    }
    smooth[voxels.place(index)] = sum / (kCenter + 6.0F);
  });
  return smooth;
}

bool is_any_positive(const Voxels& voxels, const std::vector<float>& values,
                     const Eigen::AlignedBox3d& box) {
  // A point half-way between two voxels may be given to either.
  const Eigen::Vector3d slack = 1e-6 * box.sizes();
  const Eigen::Array3i low = voxels.nearest(box.min() - slack);
  const Eigen::Array3i high = voxels.nearest(box.max() + slack);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      const float* row = &values[voxels.place({0, y, z})];
      if (std::any_of(row + low.x(), row + high.x() + 1, [](float v) { return v > 0.0F; })) {
        return true;
      }
    }
  }
  return false;
}

TriangleMesh surface_of(const Voxels& voxels, const std::vector<float>& values, double cell_size) {
  FieldSource source;
  source.classify = [&](const Eigen::AlignedBox3d& box) {
    return is_any_positive(voxels, values, box) ? Occupancy::mixed : Occupancy::outside;
  };
  source.sample = [&](const Eigen::Vector3d& point, bool&) {
    return values[voxels.place(voxels.nearest(point))];
  };
  return extract_isosurface(
      without_small_components(build_octree(voxels.box(), cell_size, source), kSmallestPiece));
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
  const Voxels voxels({box.min() - reach, box.max() + reach}, voxel);
  std::vector<Votes> votes(voxels.count());
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const TriangleMesh surface = hand.posed(estimate.pose(f)).surface();
    std::vector<DrawnView> views(frames[f]->views.size());
    parallel_for(views.size(), threads, [&](std::size_t v) {
      views[v] =
          drawn(hand, surface, estimate.world_from_hand[f], frames[f]->views[v], options.margin_px);
    });
    add_votes(voxels, views, options, options.skin * hand.scale, threads, votes);
  }
  HiddenObject object;
  object.surface = surface_of(voxels, smooth_evidence(voxels, votes, options, threads), voxel);
  for (const Eigen::Vector3d& vertex : object.surface.vertices) {
    const Votes& near = votes[voxels.place(voxels.nearest(vertex))];
    const double many = 1.0 - std::exp(-near.blocked / options.least_blocked);
    object.confidence.push_back(
        static_cast<float>(many * near.blocked / std::max(near.blocked + near.free, 1.0F)));
  }
  return object;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/silhouette_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tegata/image/banded_distance.h"

namespace tegata {
namespace {

// What rounding may move a projection by [px], and more.
constexpr double kSlack = 1e-6;
// Around the foreground, distances are measured so far [px]; beyond they go on as a straight line.
constexpr int kDistanceMargin = 4;
// What a few roundings of single precision make of a sum of terms.
constexpr float kRounding = 4.0f * std::numeric_limits<float>::epsilon();

static_assert(static_cast<int>(PixelLabel::background) == 0);
bool is_foreground(PixelLabel label) { return label != PixelLabel::background; }

}  // namespace

SilhouetteTable::SilhouetteTable(const HullView& view) : source_(&view) {
  const Camera& camera = view.camera;
  Eigen::Matrix3d pixel_from_camera;
  pixel_from_camera << camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0;
  pixel_from_world_ = pixel_from_camera * camera.camera_from_world.rotation.toRotationMatrix();
  pixel_offset_ = pixel_from_camera * camera.camera_from_world.translation;
  depth_reach_ = pixel_from_world_.row(2).cwiseAbs().sum();
  metres_per_pixel_ = static_cast<float>(2.0 / (camera.fx + camera.fy));
  find_foreground();
  if (!foreground_.isEmpty()) sum_foreground();
}

void SilhouetteTable::find_foreground() {
  const Silhouette& silhouette = source_->silhouette;
  const auto width = static_cast<std::size_t>(silhouette.width());
  std::vector<std::uint8_t> in_column(width, 0);
  int top = silhouette.height(), bottom = -1;
  for (int y = 0; y < silhouette.height(); ++y) {
    const PixelLabel* row = &silhouette(0, y);
    std::uint8_t in_row = 0;
    for (std::size_t x = 0; x < width; ++x) {
      const auto label = static_cast<std::uint8_t>(row[x]);
      in_row |= label;
      in_column[x] |= label;
    }
    if (in_row == 0) continue;
    top = std::min(top, y);
    bottom = y;
  }
  if (bottom < 0) return;
  const auto is_any = [](std::uint8_t labels) { return labels != 0; };
  const auto left = std::find_if(in_column.begin(), in_column.end(), is_any) - in_column.begin();
  const auto after = std::find_if(in_column.rbegin(), in_column.rend(), is_any).base();
  const auto right = after - in_column.begin() - 1;
  foreground_ = {Eigen::Vector2i(static_cast<int>(left), top),
                 Eigen::Vector2i(static_cast<int>(right), bottom)};
}

void SilhouetteTable::sum_foreground() {
  const Eigen::Vector2i low = foreground_.min();
  const Eigen::Vector2i size = foreground_.sizes() + Eigen::Vector2i::Ones();
  const auto width = static_cast<std::size_t>(size.x());
  const std::size_t stride = width + 1;
  sums_.assign(stride * (static_cast<std::size_t>(size.y()) + 1), 0);
  std::uint8_t any_hand = 0, any_unknown = 0;
  for (int y = 0; y < size.y(); ++y) {
    const PixelLabel* row = &source_->silhouette(low.x(), low.y() + y);
    const std::uint32_t* above = &sums_[static_cast<std::size_t>(y) * stride + 1];
    std::uint32_t* sums = &sums_[(static_cast<std::size_t>(y) + 1) * stride + 1];
    // Loops of one thing each, of which compilers make vectors where they can.
    for (std::size_t x = 0; x < width; ++x) any_hand |= row[x] == PixelLabel::hand ? 1 : 0;
    for (std::size_t x = 0; x < width; ++x) any_unknown |= row[x] == PixelLabel::unknown ? 1 : 0;
    std::uint32_t in_row = 0;
    for (std::size_t x = 0; x < width; ++x) {
      in_row += is_foreground(row[x]) ? 1u : 0u;
      sums[x] = in_row;
    }
    for (std::size_t x = 0; x < width; ++x) sums[x] += above[x];
  }
  has_hand_ = any_hand != 0;
  has_unknown_ = any_unknown != 0;
}

// The depth of the nearest point of the root cube [m].
double SilhouetteTable::nearest_depth(const OctreeRoot& root) const {
  double nearest = pixel_from_world_.row(2).dot(root.origin) + pixel_offset_.z();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    nearest += std::min(0.0, root.cells() * root.cell_size * pixel_from_world_(2, axis));
  }
  return nearest;
}

// The leaf's diagonal, seen askew, times what bilinear interpolation of distances may rise by. Such
// a corner lies before the foreground, or not a pixel beside it.
double SilhouetteTable::leaf_reach(const OctreeRoot& root) const {
  if (foreground_.isEmpty()) return 0.0;
  const Camera& camera = source_->camera;
  const Eigen::Array2d center(camera.cx, camera.cy), focal(camera.fx, camera.fy);
  const Eigen::Array2d before = center - foreground_.min().cast<double>().array() + 1.0;
  const Eigen::Array2d behind = foreground_.max().cast<double>().array() - center + 1.0;
  const double slant = std::sqrt(1.0 + (before.max(behind) / focal).square().sum());
  const double diagonal = std::sqrt(3.0) * root.cell_size, nearest = nearest_depth(root);
  const double deepening = nearest > 0.0 ? std::min(2.0, 1.0 + diagonal / nearest) : 2.0;
  return std::sqrt(2.0) * diagonal * slant * deepening;
}

SampledView SilhouetteTable::prepare_sampling(const OctreeRoot& root, double largest_value) {
  SampledView sampled;
  const Eigen::Vector3d first = project(root.origin);
  std::array<float, 3> terms = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    sampled.origin[i] = static_cast<float>(first[row]);
    terms[i] = std::abs(sampled.origin[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = root.cell_size * pixel_from_world_(row, static_cast<Eigen::Index>(axis));
      sampled.steps[axis][i] = static_cast<float>(step);
      terms[i] += static_cast<float>(root.cells()) * std::abs(sampled.steps[axis][i]);
    }
  }
  sampled.width = static_cast<float>(source_->camera.width);
  sampled.height = static_cast<float>(source_->camera.height);
  sampled.metres_per_pixel = metres_per_pixel_;
  sampled.least_depth = kRounding * terms[2];
  rounding_ = static_cast<double>(kRounding * std::max(terms[0], terms[1]) +
                                  std::max(sampled.width, sampled.height) * sampled.least_depth);

  largest_value_ = largest_value;
  const double nearest = nearest_depth(root);
  const double band = largest_value / (nearest * static_cast<double>(metres_per_pixel_));
  band_ = nearest > 0.0 && band < kMostBand - 1 ? static_cast<int>(band) + 1 : kMostBand;

  const Silhouette& silhouette = source_->silhouette;
  Eigen::AlignedBox2i box = foreground_;
  if (box.isEmpty()) box.extend(Eigen::Vector2i(0, 0));
  const Eigen::Vector2i last(silhouette.width() - 1, silhouette.height() - 1);
  const Eigen::Vector2i low = (box.min().array() - kDistanceMargin).max(0);
  const Eigen::Vector2i high = (box.max().array() + kDistanceMargin).min(last.array());
  const int width = high.x() - low.x() + 1, height = high.y() - low.y() + 1;
  Image<std::uint8_t> mask(width, height);
  if (has_unknown_) sampled.unknown = Image<float>(width, height);
  for (int y = 0; y < height; ++y) {
    const PixelLabel* row = &silhouette(low.x(), low.y() + y);
    std::transform(row, row + width, &mask(0, y),
                   [](PixelLabel label) { return static_cast<std::uint8_t>(label); });
    if (!has_unknown_) continue;
    std::transform(row, row + width, &sampled.unknown(0, y),
                   [](PixelLabel label) { return label == PixelLabel::unknown ? 1.0f : 0.0f; });
  }
  const auto largest = static_cast<float>(band_);
  sampled.distance = packed_pairs(banded_distance(mask, band_), largest);
  sampled.distance_step = packing_step(largest);
  sampled.left = static_cast<float>(low.x());
  sampled.top = static_cast<float>(low.y());
  return sampled;
}

bool SilhouetteTable::is_surely_inside(const Eigen::Vector3d& center, double half_side) const {
  // Unknown pixels keep, but prove nothing: they must be asked. A band that was cut short says too
  // little.
  if (has_unknown_ || band_ == kMostBand) return false;
  const Eigen::Vector3d h = project(center);
  const double nearest = h.z() - half_side * depth_reach_;
  const double needed = largest_value_ / (nearest * static_cast<double>(metres_per_pixel_));
  const Count seen = count(footprint(h, half_side), static_cast<int>(needed) + 2);
  return seen.foreground == seen.pixels;
}

// How many of the pixels that bilinear interpolation reads in a footprint, and of those around it,
// are foreground.
SilhouetteTable::Count SilhouetteTable::count(const Footprint& footprint, int around) const {
  const int last_x = source_->camera.width - 1, last_y = source_->camera.height - 1;
  const auto low = [around](double position) {
    return std::max(0, (position > 0.0 ? static_cast<int>(position) : 0) - around);
  };
  const auto high = [around](double position, int last) {
    if (!(position < last)) return last;
    return position < 0.0 ? std::min(last, around)
                          : std::min(last, static_cast<int>(position) + 1 + around);
  };
  const int left = low(footprint.left), right = high(footprint.right, last_x);
  const int top = low(footprint.top), bottom = high(footprint.bottom, last_y);
  Count count;
  count.pixels =
      static_cast<std::uint32_t>(right - left + 1) * static_cast<std::uint32_t>(bottom - top + 1);
  const int first_x = foreground_.min().x(), first_y = foreground_.min().y();
  const int in_left = std::max(left, first_x), in_right = std::min(right, foreground_.max().x());
  const int in_top = std::max(top, first_y), in_bottom = std::min(bottom, foreground_.max().y());
  if (in_left > in_right || in_top > in_bottom) return count;
  const auto stride = static_cast<std::size_t>(foreground_.max().x() - first_x) + 2;
  const std::uint32_t* above = sums_.data() + static_cast<std::size_t>(in_top - first_y) * stride;
  const std::uint32_t* below =
      sums_.data() + (static_cast<std::size_t>(in_bottom - first_y) + 1) * stride;
  const auto before = static_cast<std::size_t>(in_left - first_x);
  const auto end = static_cast<std::size_t>(in_right - first_x) + 1;
  count.foreground = below[end] - below[before] - above[end] + above[before];
  return count;
}

// Whether a cube lies beyond one of the four planes through the camera and the picture's sides, as
// far as it is in front of the camera at all. `h` is its middle, homogeneous.
bool SilhouetteTable::misses_frustum(const Eigen::Vector3d& h, double half_side) const {
  const Eigen::Matrix3d& m = pixel_from_world_;
  for (int axis = 0; axis < 2; ++axis) {
    const double last = (axis == 0 ? source_->camera.width : source_->camera.height) - 0.5;
    const double below = h[axis] + 0.5 * h.z(), above = h[axis] - last * h.z();
    const double below_reach = half_side * (m.row(axis) + 0.5 * m.row(2)).cwiseAbs().sum();
    const double above_reach = half_side * (m.row(axis) - last * m.row(2)).cwiseAbs().sum();
    if (below + below_reach < -rounding_ || above - above_reach > rounding_) return true;
  }
  return false;
}

SilhouetteTable::Footprint SilhouetteTable::footprint(const Eigen::Vector3d& h,
                                                      double half_side) const {
  const Eigen::Matrix3d& m = pixel_from_world_;
  const double over_nearest = 1.0 / (h.z() - half_side * depth_reach_);
  const double over_depth = 1.0 / h.z();
  // For a point at center + d the pixel is off by (m0 - x m2) . d / (depth there), exactly.
  const double x = h.x() * over_depth, y = h.y() * over_depth;
  const double scale = half_side * over_nearest, slack = kSlack + rounding_ * over_nearest;
  const double reach_x = scale * (m.row(0) - x * m.row(2)).cwiseAbs().sum() + slack;
  const double reach_y = scale * (m.row(1) - y * m.row(2)).cwiseAbs().sum() + slack;
  return {x - reach_x, x + reach_x, y - reach_y, y + reach_y};
}

SilhouetteTable::Judgement SilhouetteTable::judge(const Eigen::Vector3d& center,
                                                  double half_side) const {
  const Eigen::Vector3d h = project(center);
  const double depth_reach = half_side * depth_reach_;
  if (h.z() + depth_reach <= 0.0) return {Verdict::blind, false};
  if (!(h.z() - depth_reach > 0.0)) {
    return {misses_frustum(h, half_side) ? Verdict::blind : Verdict::undecided, false};
  }
  const double width = source_->camera.width, height = source_->camera.height;
  const Footprint seen = footprint(h, half_side);
  if (seen.right < -0.5 || seen.bottom < -0.5 || seen.left > width - 0.5 ||
      seen.top > height - 0.5) {
    return {Verdict::blind, false};
  }
  const bool sees_all = seen.left >= 0.0 && seen.top >= 0.0 && seen.right <= width - 1.0 &&
                        seen.bottom <= height - 1.0;
  const Count counted = count(seen, 0);
  if (counted.foreground == counted.pixels) {
    return {sees_all ? Verdict::inside : Verdict::inside_as_far_as_seen, sees_all};
  }
  if (counted.foreground > 0) return {Verdict::undecided, sees_all};
  return {sees_all ? Verdict::outside : Verdict::outside_as_far_as_seen, sees_all};
}

}  // namespace tegata

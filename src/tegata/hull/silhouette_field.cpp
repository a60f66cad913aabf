// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/silhouette_field.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "tegata/base/error.h"
#include "tegata/image/banded_distance.h"

namespace tegata {
namespace {

// What rounding may move a projection by [px], and more.
constexpr double kSlack = 1e-6;
// Around the foreground, distances are measured so far [px]; beyond they go on as a straight line.
constexpr int kDistanceMargin = 4;

std::size_t count_views(ViewSet views) { return static_cast<std::size_t>(std::popcount(views)); }

static_assert(static_cast<int>(PixelLabel::background) == 0);
bool is_foreground(PixelLabel label) { return label != PixelLabel::background; }

void check_view(const HullView& view) {
  check_camera(view.camera);
  if (view.camera.is_distorted()) {
    throw Error("hull: camera '", view.camera.name,
                "' has lens distortion, expected undistorted views: undistort() the silhouette and "
                "take camera.undistorted()");
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

// The box of all pixels that are not background. What lies between is not looked at.
Eigen::AlignedBox2i foreground_box(const Silhouette& silhouette) {
  Eigen::AlignedBox2i box;
  const int width = silhouette.width();
  for (int y = 0; y < silhouette.height(); ++y) {
    const PixelLabel* row = &silhouette(0, y);
    std::uint8_t any = 0;  // cheaper than a search, and most rows have nothing
    for (int x = 0; x < width; ++x) any |= static_cast<std::uint8_t>(row[x]);
    if (any == 0) continue;
    const PixelLabel* first = std::find_if(row, row + width, is_foreground);
    const PixelLabel* last = row + width - 1;
    while (!is_foreground(*last)) --last;
    box.extend(Eigen::Vector2i(static_cast<int>(first - row), y));
    box.extend(Eigen::Vector2i(static_cast<int>(last - row), y));
  }
  return box;
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
    views_.push_back(make_view(source));
    const auto& labels = source.silhouette.values();
    has_hand =
        has_hand || std::find(labels.begin(), labels.end(), PixelLabel::hand) != labels.end();
    if (!views_.back().foreground.isEmpty()) continue;
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

SilhouetteField::View SilhouetteField::make_view(const HullView& source) {
  View view;
  const Camera& camera = source.camera;
  view.source = &source;
  Eigen::Matrix3d pixel_from_camera;
  pixel_from_camera << camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0;
  view.pixel_from_world = pixel_from_camera * camera.camera_from_world.rotation.toRotationMatrix();
  view.pixel_offset = pixel_from_camera * camera.camera_from_world.translation;
  view.width = camera.width;
  view.height = camera.height;
  view.metres_per_pixel = static_cast<float>(2.0 / (camera.fx + camera.fy));
  view.foreground = foreground_box(source.silhouette);
  if (view.foreground.isEmpty()) return view;

  const Eigen::Vector2i low = view.foreground.min();
  const Eigen::Vector2i size = view.foreground.sizes() + Eigen::Vector2i::Ones();
  const auto stride = static_cast<std::size_t>(size.x()) + 1;
  view.sums.assign(stride * (static_cast<std::size_t>(size.y()) + 1), 0);
  for (int y = 0; y < size.y(); ++y) {
    const std::size_t above = static_cast<std::size_t>(y) * stride;
    std::uint32_t in_row = 0;
    for (int x = 0; x < size.x(); ++x) {
      const PixelLabel label = source.silhouette(low.x() + x, low.y() + y);
      in_row += is_foreground(label) ? 1u : 0u;
      view.has_unknown |= label == PixelLabel::unknown;
      const std::size_t column = static_cast<std::size_t>(x) + 1;
      view.sums[above + stride + column] = view.sums[above + column] + in_row;
    }
  }
  return view;
}

void SilhouetteField::prepare_sampling(const OctreeRoot& root) {
  root_ = root;
  double largest_value = 0.0;
  for (const View& view : views_) largest_value = std::max(largest_value, leaf_reach(view, root));
  rule_.largest_value = static_cast<float>(largest_value);

  // What a few roundings of single precision make of a sum of terms.
  constexpr float kRounding = 4.0f * std::numeric_limits<float>::epsilon();
  sampled_views_.clear();
  for (View& view : views_) {
    SampledView& sampled = sampled_views_.emplace_back(sampled_view(view, root, largest_value));
    std::array<float, 3> terms = {};
    for (std::size_t i = 0; i < 3; ++i) {
      terms[i] = std::abs(sampled.origin[i]);
      for (const auto& step : sampled.steps) {
        terms[i] += static_cast<float>(root.cells()) * std::abs(step[i]);
      }
    }
    sampled.least_depth = kRounding * terms[2];
    view.rounding =
        static_cast<double>(kRounding * std::max(terms[0], terms[1]) +
                            std::max(sampled.width, sampled.height) * sampled.least_depth);
  }
}

// How far inside a view's edge the corner of a leaf can lie that has another corner outside it [m]:
// the leaf's diagonal, seen askew, times what bilinear interpolation of distances may rise by.
double SilhouetteField::leaf_reach(const View& view, const OctreeRoot& root) {
  const Camera& camera = view.source->camera;
  const double tangent_x = std::max(camera.cx, view.width - camera.cx) / camera.fx;
  const double tangent_y = std::max(camera.cy, view.height - camera.cy) / camera.fy;
  const double slant = std::sqrt(1.0 + tangent_x * tangent_x + tangent_y * tangent_y);
  const double diagonal = std::sqrt(3.0) * root.cell_size, nearest = nearest_depth(view, root);
  const double deepening = nearest > 0.0 ? std::min(2.0, 1.0 + diagonal / nearest) : 2.0;
  return std::sqrt(2.0) * diagonal * slant * deepening;
}

// The depth of the nearest point of the root cube [m].
double SilhouetteField::nearest_depth(const View& view, const OctreeRoot& root) {
  double nearest = view.pixel_from_world.row(2).dot(root.origin) + view.pixel_offset.z();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    nearest += std::min(0.0, root.cells() * root.cell_size * view.pixel_from_world(2, axis));
  }
  return nearest;
}

SampledView SilhouetteField::sampled_view(View& view, const OctreeRoot& root,
                                          double largest_value) {
  SampledView sampled;
  const Eigen::Vector3d first = view.pixel_from_world * root.origin + view.pixel_offset;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    sampled.origin[i] = static_cast<float>(first[row]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step =
          root.cell_size * view.pixel_from_world(row, static_cast<Eigen::Index>(axis));
      sampled.steps[axis][i] = static_cast<float>(step);
    }
  }
  sampled.width = static_cast<float>(view.width);
  sampled.height = static_cast<float>(view.height);
  sampled.metres_per_pixel = view.metres_per_pixel;

  const double nearest = nearest_depth(view, root);
  const double band = largest_value / (nearest * static_cast<double>(view.metres_per_pixel));
  view.band = nearest > 0.0 && band < kMostBand - 1 ? static_cast<int>(band) + 1 : kMostBand;

  const Silhouette& silhouette = view.source->silhouette;
  Eigen::AlignedBox2i box = view.foreground;
  if (box.isEmpty()) box.extend(Eigen::Vector2i(0, 0));
  const Eigen::Vector2i last(silhouette.width() - 1, silhouette.height() - 1);
  const Eigen::Vector2i low = (box.min().array() - kDistanceMargin).max(0);
  const Eigen::Vector2i high = (box.max().array() + kDistanceMargin).min(last.array());
  const int width = high.x() - low.x() + 1, height = high.y() - low.y() + 1;
  Image<std::uint8_t> mask(width, height);
  if (view.has_unknown) sampled.unknown = Image<float>(width, height, 0.0f);
  for (int y = 0; y < height; ++y) {
    const PixelLabel* row = &silhouette(low.x(), low.y() + y);
    for (int x = 0; x < width; ++x) {
      mask(x, y) = static_cast<std::uint8_t>(row[x]);
      if (view.has_unknown && row[x] == PixelLabel::unknown) sampled.unknown(x, y) = 1.0f;
    }
  }
  const auto largest = static_cast<float>(view.band);
  sampled.distance = packed_pairs(banded_distance(mask, view.band), largest);
  sampled.distance_step = packing_step(largest);
  sampled.left = static_cast<float>(low.x());
  sampled.top = static_cast<float>(low.y());
  return sampled;
}

void SilhouetteField::sample(const LatticeIndex& low, const State& state,
                             SilhouetteBlock& block) const {
  sample_block(sampled_views_, rule_, certain_views(low, state.inside), low, instruction_set_,
               block);
}

ViewSet SilhouetteField::certain_views(const LatticeIndex& low, ViewSet inside) const {
  const double half_side = 0.5 * kBlockCells * root_.cell_size;
  const Eigen::Vector3d center = root_.origin +
                                 root_.cell_size * Eigen::Vector3d(low[0], low[1], low[2]) +
                                 Eigen::Vector3d::Constant(half_side);
  ViewSet certain = 0;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const View& view = views_[i];
    // Unknown pixels keep, but prove nothing: they must be asked. A band that was cut short says
    // too little.
    if ((inside >> i & 1u) == 0 || view.has_unknown || view.band == kMostBand) continue;
    const Eigen::Vector3d h = view.pixel_from_world * center + view.pixel_offset;
    if (is_all_foreground(view, footprint(view, h, half_side), view.band + 1, nullptr)) {
      certain |= ViewSet{1} << i;
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

std::uint32_t SilhouetteField::count_foreground(const View& view,
                                                const Eigen::AlignedBox2i& pixels) {
  const Eigen::Vector2i low = pixels.min().cwiseMax(view.foreground.min());
  const Eigen::Vector2i high = pixels.max().cwiseMin(view.foreground.max());
  if ((low.array() > high.array()).any()) return 0;
  const auto stride = static_cast<std::size_t>(view.foreground.sizes().x()) + 2;
  const auto left = static_cast<std::size_t>(low.x() - view.foreground.min().x());
  const auto right = static_cast<std::size_t>(high.x() - view.foreground.min().x()) + 1;
  const auto top = static_cast<std::size_t>(low.y() - view.foreground.min().y()) * stride;
  const auto bottom = (static_cast<std::size_t>(high.y() - view.foreground.min().y()) + 1) * stride;
  return view.sums[bottom + right] - view.sums[bottom + left] - view.sums[top + right] +
         view.sums[top + left];
}

// Whether a cube lies beyond one of the four planes through the camera and the picture's sides, as
// far as it is in front of the camera at all. `h` is its middle, homogeneous.
bool SilhouetteField::misses_frustum(const View& view, const Eigen::Vector3d& h, double half_side) {
  const Eigen::Matrix3d& m = view.pixel_from_world;
  for (int axis = 0; axis < 2; ++axis) {
    const double last = (axis == 0 ? view.width : view.height) - 0.5;
    const double below = h[axis] + 0.5 * h.z(), above = h[axis] - last * h.z();
    const double below_reach = half_side * (m.row(axis) + 0.5 * m.row(2)).cwiseAbs().sum();
    const double above_reach = half_side * (m.row(axis) - last * m.row(2)).cwiseAbs().sum();
    if (below + below_reach < -view.rounding || above - above_reach > view.rounding) return true;
  }
  return false;
}

SilhouetteField::Footprint SilhouetteField::footprint(const View& view, const Eigen::Vector3d& h,
                                                      double half_side) {
  const Eigen::Matrix3d& m = view.pixel_from_world;
  const double nearest = h.z() - half_side * m.row(2).cwiseAbs().sum();
  // For a point at center + d the pixel is off by (m0 - x m2) . d / (depth there), exactly.
  const double x = h.x() / h.z(), y = h.y() / h.z();
  const double scale = half_side / nearest, slack = kSlack + view.rounding / nearest;
  const double reach_x = scale * (m.row(0) - x * m.row(2)).cwiseAbs().sum() + slack;
  const double reach_y = scale * (m.row(1) - y * m.row(2)).cwiseAbs().sum() + slack;
  return {x - reach_x, x + reach_x, y - reach_y, y + reach_y};
}

bool SilhouetteField::is_all_foreground(const View& view, const Footprint& footprint, int around,
                                        bool* any) {
  const auto low = [&](double position) {
    return std::max(0, (position > 0.0 ? static_cast<int>(position) : 0) - around);
  };
  const auto high = [&](double position, double size) {
    const int last = static_cast<int>(size) - 1;
    return position < size - 1.0
               ? std::min(last, static_cast<int>(std::floor(position)) + 1 + around)
               : last;
  };
  const Eigen::AlignedBox2i pixels(
      Eigen::Vector2i(low(footprint.left), low(footprint.top)),
      Eigen::Vector2i(high(footprint.right, view.width), high(footprint.bottom, view.height)));
  const std::uint32_t count = count_foreground(view, pixels);
  if (any != nullptr) *any = count > 0;
  const Eigen::Vector2i size = pixels.sizes() + Eigen::Vector2i::Ones();
  return count == static_cast<std::uint32_t>(size.x()) * static_cast<std::uint32_t>(size.y());
}

SilhouetteField::Judgement SilhouetteField::judge(const View& view, const Eigen::Vector3d& center,
                                                  double half_side) {
  const Eigen::Vector3d h = view.pixel_from_world * center + view.pixel_offset;
  const double depth_reach = half_side * view.pixel_from_world.row(2).cwiseAbs().sum();
  if (h.z() + depth_reach <= 0.0) return {Verdict::blind, false};
  if (!(h.z() - depth_reach > 0.0)) {
    return {misses_frustum(view, h, half_side) ? Verdict::blind : Verdict::undecided, false};
  }
  const Footprint seen = footprint(view, h, half_side);
  if (seen.right < -0.5 || seen.bottom < -0.5 || seen.left > view.width - 0.5 ||
      seen.top > view.height - 0.5) {
    return {Verdict::blind, false};
  }
  const bool sees_all = seen.is_within(view);
  bool any = false;
  if (is_all_foreground(view, seen, 0, &any)) {
    return {sees_all ? Verdict::inside : Verdict::inside_as_far_as_seen, sees_all};
  }
  if (any) return {Verdict::undecided, sees_all};
  return {sees_all ? Verdict::outside : Verdict::outside_as_far_as_seen, sees_all};
}

Occupancy SilhouetteField::classify(const Eigen::Vector3d& center, double half_side,
                                    State& state) const {
  ViewSet outside_in_part = 0, inside_in_part = 0, see_all = 0;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const ViewSet bit = ViewSet{1} << i;
    if (((state.inside | state.outside) & bit) != 0) see_all |= bit;
    if (((state.inside | state.outside | state.blind) & bit) != 0) continue;
    const Judgement judgement = judge(views_[i], center, half_side);
    if (judgement.sees_all) see_all |= bit;
    switch (judgement.verdict) {
      case Verdict::outside:
        state.outside |= bit;
        break;
      case Verdict::blind:
        state.blind |= bit;
        break;
      case Verdict::inside:
        state.inside |= bit;
        break;
      case Verdict::outside_as_far_as_seen:
        outside_in_part |= bit;
        break;
      case Verdict::inside_as_far_as_seen:
        inside_in_part |= bit;
        break;
      case Verdict::undecided:
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
  return views_.size() - count_views(content) <= rule_.dissenting_views && rule_.suffices(see_all)
             ? Occupancy::inside
             : Occupancy::mixed;
}

}  // namespace tegata

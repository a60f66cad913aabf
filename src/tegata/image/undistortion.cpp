// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/undistortion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tegata/base/error.h"
#include "tegata/image/image.h"
#include "tegata/image/lens_range.h"

namespace tegata {
namespace {

// Of the distorted picture's size, at each side: what is cut off at most, and what is added.
constexpr double kMostCutOff = 0.05, kMostAdded = 0.25;

// Columns (axis 0) and rows (1) of the undistorted picture, counted as the distorted one's are.
struct Box {
  int begin[2], end[2];
  int size(int axis) const { return end[axis] - begin[axis]; }
};

Box whole_picture(const Camera& camera) { return {{0, 0}, {camera.width, camera.height}}; }

// The picture and what the lens shows beyond its edges.
Box widest_box(const Camera& camera, const LensRange& range) {
  Box box = whole_picture(camera);
  const int size[2] = {camera.width, camera.height};
  const auto include = [&](double x, double y) {
    const Eigen::Vector2d ideal = undistort_pixel(camera, {x, y});
    if (!ideal.allFinite() || !range.contains(ideal)) return;
    for (int axis = 0; axis < 2; ++axis) {
      const double most = kMostAdded * size[axis];
      const double at = std::clamp(ideal[axis], -most, size[axis] - 1 + most);
      box.begin[axis] = std::min(box.begin[axis], static_cast<int>(std::ceil(at)));
      box.end[axis] = std::max(box.end[axis], static_cast<int>(std::floor(at)) + 1);
    }
  };
  for (int x = 0; x < size[0]; ++x) {
    include(x, 0);
    include(x, size[1] - 1);
  }
  for (int y = 0; y < size[1]; ++y) {
    include(0, y);
    include(size[0] - 1, y);
  }
  return box;
}

// For each pixel of a box the one of the distorted picture, or -1.
Image<std::int32_t> sources_of(const Camera& camera, const LensRange& range, const Box& box) {
  Image<std::int32_t> sources(box.size(0), box.size(1));
  for (int y = 0; y < sources.height(); ++y) {
    for (int x = 0; x < sources.width(); ++x) {
      const Eigen::Vector2d pixel(x + box.begin[0], y + box.begin[1]);
      const Eigen::Vector2d seen = distort_pixel(camera, pixel);
      const bool is_seen = camera.contains(seen) && range.contains(pixel);
      sources(x, y) = is_seen ? static_cast<int>(std::floor(seen.y() + 0.5)) * camera.width +
                                    static_cast<int>(std::floor(seen.x() + 0.5))
                              : -1;
    }
  }
  return sources;
}

// Finds the part of a box in which no pixel lacks a source: cuts lines off its edges, the one that
// lacks most first.
class FilledBox {
 public:
  FilledBox(const Image<std::int32_t>& sources, const Box& box)
      : sources_(sources), whole_(box), filled_(box) {
    while (cut_off_worst()) {
    }
  }
  const Box& box() const { return filled_; }

 private:
  // False where no line at an edge lacks anything.
  bool cut_off_worst() {
    double worst_share = 0.0;
    int *worst = nullptr, inwards = 0;
    const auto consider = [&](int axis, int line, int& edge, int step) {
      const double share = missing_share(axis, line);
      if (share <= worst_share) return;
      worst_share = share;
      worst = &edge;
      inwards = step;
    };
    for (int axis = 0; axis < 2; ++axis) {
      consider(axis, filled_.begin[axis], filled_.begin[axis], 1);
      consider(axis, filled_.end[axis] - 1, filled_.end[axis], -1);
    }
    if (worst != nullptr) *worst += inwards;
    return worst != nullptr;
  }

  // Of a column or a row of what is left.
  double missing_share(int axis, int line) const {
    const int along = 1 - axis;
    int missing = 0;
    for (int i = filled_.begin[along]; i < filled_.end[along]; ++i) {
      const int x = (axis == 0 ? line : i) - whole_.begin[0];
      const int y = (axis == 0 ? i : line) - whole_.begin[1];
      missing += sources_(x, y) < 0 ? 1 : 0;
    }
    return missing == 0 ? 0.0 : static_cast<double>(missing) / filled_.size(along);
  }

  const Image<std::int32_t>& sources_;
  const Box whole_;
  Box filled_;
};

bool cuts_off_too_much(const Box& box, const Camera& camera) {
  const int size[2] = {camera.width, camera.height};
  for (int axis = 0; axis < 2; ++axis) {
    const double most = kMostCutOff * size[axis];
    if (box.begin[axis] > most || size[axis] - box.end[axis] > most) return true;
  }
  return false;
}

}  // namespace

Undistortion::Undistortion(const Camera& camera)
    : width_(camera.width), height_(camera.height), ideal_(camera.undistorted()) {
  if (!camera.is_distorted()) return;
  const LensRange range(camera);
  const Box widest = widest_box(camera, range);
  const Image<std::int32_t> sources = sources_of(camera, range, widest);
  Box box = FilledBox(sources, widest).box();
  if (cuts_off_too_much(box, camera)) box = whole_picture(camera);
  ideal_.width = box.size(0);
  ideal_.height = box.size(1);
  ideal_.cx -= box.begin[0];
  ideal_.cy -= box.begin[1];
  for (int y = box.begin[1]; y < box.end[1]; ++y) {
    for (int x = box.begin[0]; x < box.end[0]; ++x) {
      sources_.push_back(sources(x - widest.begin[0], y - widest.begin[1]));
    }
  }
}

Silhouette Undistortion::apply(const Silhouette& silhouette) const {
  if (silhouette.width() != width_ || silhouette.height() != height_) {
    throw Error("camera '", ideal_.name, "': got a silhouette of ", silhouette.width(), " x ",
                silhouette.height(), ", expected the calibration's ", width_, " x ", height_);
  }
  if (sources_.empty()) return silhouette;
  Silhouette ideal(ideal_.width, ideal_.height);
  std::transform(sources_.begin(), sources_.end(), ideal.values().begin(),
                 [labels = silhouette.values().data()](std::int32_t source) {
                   return source < 0 ? PixelLabel::unknown : labels[source];
                 });
  return ideal;
}

}  // namespace tegata

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

// At most so much of the picture's size is cut off at each side.
constexpr double kMostCutOff = 0.05;

// The pixel of the distorted picture for each of the undistorted one, or -1.
Image<std::int32_t> sources_of(const Camera& camera) {
  const LensRange range(camera);
  Image<std::int32_t> sources(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector2d pixel(x, y);
      const Eigen::Vector2d seen = distort_pixel(camera, pixel);
      const bool is_seen = camera.contains(seen) && range.contains(pixel);
      sources(x, y) = is_seen ? static_cast<int>(std::floor(seen.y() + 0.5)) * camera.width +
                                    static_cast<int>(std::floor(seen.x() + 0.5))
                              : -1;
    }
  }
  return sources;
}

// The part of a picture that is left when lines that lack sources are cut off its edges, until none
// lacks any: the whole picture where that took too much.
class FilledBox {
 public:
  explicit FilledBox(const Image<std::int32_t>& sources)
      : sources_(sources), size_{sources.width(), sources.height()}, end_{size_[0], size_[1]} {
    while (cut_off_worst()) {
    }
    for (int axis = 0; axis < 2; ++axis) {
      const double most = kMostCutOff * size_[axis];
      if (begin_[axis] <= most && size_[axis] - end_[axis] <= most) continue;
      for (int either = 0; either < 2; ++either) {
        begin_[either] = 0;
        end_[either] = size_[either];
      }
    }
  }

  int begin(int axis) const { return begin_[axis]; }
  int end(int axis) const { return end_[axis]; }

 private:
  // Cuts off the line at an edge that lacks most; false where none lacks anything.
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
      consider(axis, begin_[axis], begin_[axis], 1);
      consider(axis, end_[axis] - 1, end_[axis], -1);
    }
    if (worst != nullptr) *worst += inwards;
    return worst != nullptr;
  }

  // Of a column (axis 0) or a row (1) of what is left.
  double missing_share(int axis, int line) const {
    const int along = 1 - axis;
    int missing = 0;
    for (int i = begin_[along]; i < end_[along]; ++i) {
      missing += (axis == 0 ? sources_(line, i) : sources_(i, line)) < 0 ? 1 : 0;
    }
    return missing == 0 ? 0.0 : static_cast<double>(missing) / (end_[along] - begin_[along]);
  }

  const Image<std::int32_t>& sources_;
  int size_[2], begin_[2] = {0, 0}, end_[2];
};

}  // namespace

Undistortion::Undistortion(const Camera& camera)
    : width_(camera.width), height_(camera.height), ideal_(camera.undistorted()) {
  if (!camera.is_distorted()) return;
  const Image<std::int32_t> sources = sources_of(camera);
  const FilledBox box(sources);
  ideal_.width = box.end(0) - box.begin(0);
  ideal_.height = box.end(1) - box.begin(1);
  ideal_.cx -= box.begin(0);
  ideal_.cy -= box.begin(1);
  for (int y = box.begin(1); y < box.end(1); ++y) {
    for (int x = box.begin(0); x < box.end(0); ++x) sources_.push_back(sources(x, y));
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

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tegata/image/distance_transform.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

constexpr float kNearlyInsidePx = 2.0F;
constexpr double kLeastUncoveredPx = 1.0;  // what is uncovered by less may be the picture's noise

// So many pixels at once.
constexpr int kAtOnce = 8;
bool is_background(const PixelLabel* first) {
  static_assert(PixelLabel::background == PixelLabel{0});
  std::uint64_t labels = 0;
  std::memcpy(&labels, first, kAtOnce);
  return labels == 0;
}

bool is_backed(const Eigen::Vector3d& vertex, const std::vector<FitView>& views) {
  bool is_shown = false;
  for (const FitView& view : views) {
    const auto pixel = project(view.camera, vertex);
    if (!pixel || !view.camera.contains(*pixel)) continue;
    is_shown = true;
    if (sample_bilinear(*view.hand_distance, pixel->x(), pixel->y()) < -kNearlyInsidePx) {
      return false;
    }
  }
  return is_shown;
}

// The line across the wrist in the picture: positive on the finger side. With the forearm along the
// line of sight there is no such line and all of the picture counts.
class WristLine {
 public:
  WristLine(const PosedHand& posed, const Camera& camera) {
    const auto wrist = project(camera, posed.keypoints()[kWrist]);
    const auto knuckle = project(camera, posed.keypoints()[kMiddleMcp]);
    if (!wrist || !knuckle) return;
    wrist_ = *wrist;
    const Eigen::Vector2d along = *knuckle - *wrist;
    const double length_px = (posed.keypoints()[kMiddleMcp] - posed.keypoints()[kWrist]).norm() *
                             camera.fx / (camera.camera_from_world * posed.keypoints()[kWrist]).z();
    constexpr double kLeastForeshortening = 0.2;
    if (along.norm() > kLeastForeshortening * length_px) direction_ = along.normalized();
  }
  bool is_there() const { return !direction_.isZero(); }
  bool is_finger_side(const Eigen::Vector2d& pixel) const {
    return direction_.dot(pixel - wrist_) >= 0.0;
  }

 private:
  Eigen::Vector2d wrist_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction_ = Eigen::Vector2d::Zero();
};

}  // namespace

std::array<double, kBoneCount> bone_support(const FitHand& hand, const PosedHand& posed,
                                            const std::vector<FitView>& views) {
  std::array<double, kBoneCount> backed = {}, total = {};
  for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
    if (hand.beyond_wrist[i] == 0) continue;
    const auto bone = static_cast<std::size_t>(main_bone(hand.model->links[i]));
    total[bone] += 1.0;
    if (is_backed(posed.vertices()[i], views)) backed[bone] += 1.0;
  }
  for (std::size_t b = 0; b < backed.size(); ++b) {
    if (total[b] > 0.0) backed[b] /= total[b];
  }
  return backed;
}

double silhouette_overlap(const FitHand& hand, const PosedHand& posed, const FitView& view) {
  // Only what lies beyond the wrist is drawn: the hand model's stump must not count as hand.
  const Silhouette drawn =
      render_silhouette(posed.vertices(), hand.drawn_beyond_wrist, view.camera);
  const WristLine wrist(posed, view.camera);
  std::size_t both = 0, either = 0;
  for (int y = 0; y < drawn.height(); ++y) {
    for (int x = 0; x < drawn.width(); ++x) {
      if (x + kAtOnce <= drawn.width() && is_background(&drawn(x, y)) &&
          is_background(&view.silhouette(x, y))) {
        x += kAtOnce - 1;
        continue;
      }
      const bool is_drawn = drawn(x, y) == PixelLabel::hand;
      const bool is_seen = view.silhouette(x, y) == PixelLabel::hand;
      if (!is_drawn && !is_seen) continue;
      if (view.silhouette(x, y) == PixelLabel::unknown ||
          !wrist.is_finger_side(Eigen::Vector2d(x, y)))
        continue;
      either += 1;
      if (is_drawn && is_seen) both += 1;
    }
  }
  return either == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(either);
}

std::optional<double> uncovered_distance(const FitHand& hand, const PosedHand& posed,
                                         const FitView& view) {
  const WristLine wrist(posed, view.camera);
  if (!wrist.is_there()) return std::nullopt;
  const Image<float> inside =
      signed_distance(render_silhouette(posed.surface(), view.camera),
                      [](PixelLabel label) { return label == PixelLabel::hand; });
  const double metres_per_px =
      (view.camera.camera_from_world * posed.keypoints()[kMiddleMcp]).z() / view.camera.fx;
  double sum = 0.0;
  std::size_t count = 0;
  for (const ContourPoint& point : view.contour) {
    if (!wrist.is_finger_side(point.pixel) || view.is_forearm(point.pixel)) continue;
    const double outside_px = -sample_bilinear(inside, point.pixel.x(), point.pixel.y());
    if (outside_px > kLeastUncoveredPx) {
      sum += std::min(metres_per_px * outside_px, kWhollyUncovered * hand.scale);
    }
    count += 1;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

}  // namespace tegata

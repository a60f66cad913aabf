// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/infrared_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

constexpr int kSamplesPerSide = 4;  // of a pixel

// What the camera sees where nothing stands, and how its lens darkens: fixed for a take.
class EmptyRoom {
 public:
  EmptyRoom(const Camera& camera, std::uint64_t seed)
      : width_(camera.width), height_(camera.height) {
    Random random(seed);
    mean_ = random.uniform(0.24, 0.26);
    slope_ = {random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
    for (Clutter& clutter : clutter_) {
      clutter.place = {random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2)};
      clutter.size = random.uniform(0.08, 0.25);
      clutter.height = random.uniform(0.02, 0.06);
    }
    object_ = radiance(0.5 * width_, 0.5 * height_) * random.uniform(1.0, 1.02);
    corner_loss_ = random.uniform(0.1, 0.2);
  }

  double object_radiance() const { return object_; }

  double radiance(double x, double y) const {
    const Eigen::Vector2d at(x / width_, y / height_);
    double value = mean_ + slope_.dot(at - Eigen::Vector2d(0.5, 0.5));
    for (const Clutter& clutter : clutter_) {
      value += clutter.height *
               std::exp(-0.5 * (at - clutter.place).squaredNorm() / (clutter.size * clutter.size));
    }
    return value;
  }

  // cos^4 of an angle that grows with the distance from the centre: 1 there, least in the corners.
  double vignetting(double x, double y) const {
    const Eigen::Vector2d from_centre(2.0 * x / width_ - 1.0, 2.0 * y / height_ - 1.0);
    const double tangent2_at_corner = 1.0 / std::sqrt(1.0 - corner_loss_) - 1.0;
    const double cos2 = 1.0 / (1.0 + tangent2_at_corner * from_centre.squaredNorm() / 2.0);
    return cos2 * cos2;
  }

 private:
  struct Clutter {
    Eigen::Vector2d place;  // in picture widths and heights, as is the size
    double size = 0.0, height = 0.0;
  };
  double width_, height_;
  double mean_ = 0.0, object_ = 0.0, corner_loss_ = 0.0;
  Eigen::Vector2d slope_;
  std::array<Clutter, 4> clutter_;
};

// A part of the picture, in whole pixels: [x, x + width) x [y, y + height).
struct Window {
  int x = 0, y = 0, width = 0, height = 0;
};

// The pixels that the scene may cover; empty where it is out of the picture.
Window covered_window(const RoomScene& scene, const Camera& camera) {
  Eigen::AlignedBox2d box;
  for (const TriangleMesh* mesh : {&scene.warm.mesh, &scene.cold}) {
    for (const Eigen::Vector3d& vertex : mesh->vertices) {
      if (const auto pixel = project(camera, vertex)) box.extend(*pixel);
    }
  }
  const Eigen::AlignedBox2d picture(Eigen::Vector2d::Zero(),
                                    Eigen::Vector2d(camera.width - 1, camera.height - 1));
  const Eigen::AlignedBox2d inside = box.intersection(picture);
  if (inside.isEmpty()) return {};
  Window window{static_cast<int>(inside.min().x()), static_cast<int>(inside.min().y()), 0, 0};
  window.width = std::min(static_cast<int>(inside.max().x()) + 2, camera.width) - window.x;
  window.height = std::min(static_cast<int>(inside.max().y()) + 2, camera.height) - window.y;
  return window;
}

// The camera that sees the window alone, `kSamplesPerSide` times as fine.
Camera sampling_camera(const Camera& camera, const Window& window) {
  Camera fine = camera;
  fine.width = window.width * kSamplesPerSide;
  fine.height = window.height * kSamplesPerSide;
  fine.fx *= kSamplesPerSide;
  fine.fy *= kSamplesPerSide;
  fine.cx = (camera.cx - window.x + 0.5) * kSamplesPerSide - 0.5;
  fine.cy = (camera.cy - window.y + 0.5) * kSamplesPerSide - 0.5;
  return fine;
}

// Radiance between a triangle's projected corners, linear in the picture.
class SkinShade {
 public:
  SkinShade(const WarmSurface& warm, const Camera& camera) : warm_(&warm) {
    for (const Eigen::Vector3d& vertex : warm.mesh.vertices) {
      pixels_.push_back(project(camera, vertex).value_or(Eigen::Vector2d::Zero()));
    }
  }
  double at(std::size_t triangle, const Eigen::Vector2d& pixel) const {
    const Triangle& corners = warm_->mesh.triangles[triangle];
    const Eigen::Vector2d u = pixels_[corners[1]] - pixels_[corners[0]];
    const Eigen::Vector2d v = pixels_[corners[2]] - pixels_[corners[0]];
    const Eigen::Vector2d w = pixel - pixels_[corners[0]];
    const double a = warm_->radiance[corners[0]], b = warm_->radiance[corners[1]],
                 c = warm_->radiance[corners[2]];
    const double area = u.x() * v.y() - u.y() * v.x();
    if (std::abs(area) < 1e-9) return (a + b + c) / 3.0;
    const double to_b = std::clamp((w.x() * v.y() - w.y() * v.x()) / area, 0.0, 1.0);
    const double to_c = std::clamp((u.x() * w.y() - u.y() * w.x()) / area, 0.0, 1.0 - to_b);
    return a + to_b * (b - a) + to_c * (c - a);
  }

 private:
  const WarmSurface* warm_;
  std::vector<Eigen::Vector2d> pixels_;
};

// Adds to the picture of the empty room what the scene's samples differ from it by.
void add_scene(const RoomScene& scene, const Camera& camera, const EmptyRoom& room,
               Image<float>& picture) {
  const Window window = covered_window(scene, camera);
  if (window.width <= 0 || window.height <= 0) return;
  const Camera fine = sampling_camera(camera, window);
  const RenderedMesh warm = render(scene.warm.mesh, fine);
  const RenderedMesh cold = render(scene.cold, fine);
  const SkinShade skin(scene.warm, fine);
  constexpr float kShare = 1.0f / (kSamplesPerSide * kSamplesPerSide);
  for (int y = 0; y < fine.height; ++y) {
    for (int x = 0; x < fine.width; ++x) {
      const std::int32_t triangle = warm.triangle(x, y);
      const bool hidden = cold.depth(x, y) < warm.depth(x, y);
      if (triangle < 0 && !hidden) continue;
      const double radiance =
          hidden ? room.object_radiance()
                 : skin.at(static_cast<std::size_t>(triangle), Eigen::Vector2d(x, y));
      const int px = window.x + x / kSamplesPerSide, py = window.y + y / kSamplesPerSide;
      picture(px, py) += kShare * static_cast<float>(radiance - room.radiance(px, py));
    }
  }
}

Image<float> blurred(const Image<float>& picture, double sigma_px) {
  const int reach = static_cast<int>(std::ceil(3.0 * sigma_px));
  std::vector<float> kernel;
  float sum = 0.0f;
  for (int i = -reach; i <= reach; ++i) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma_px * sigma_px))));
    sum += kernel.back();
  }
  for (float& weight : kernel) weight /= sum;
  const auto along = [&](const Image<float>& from, int step_x, int step_y) {
    Image<float> to(from.width(), from.height());
    for (int y = 0; y < from.height(); ++y) {
      for (int x = 0; x < from.width(); ++x) {
        float value = 0.0f;
        for (int i = -reach; i <= reach; ++i) {
          value += kernel[static_cast<std::size_t>(i + reach)] *
                   from(std::clamp(x + i * step_x, 0, from.width() - 1),
                        std::clamp(y + i * step_y, 0, from.height() - 1));
        }
        to(x, y) = value;
      }
    }
    return to;
  };
  return along(along(picture, 1, 0), 0, 1);
}

std::uint16_t quantised(double radiance, int bits) {
  if (bits == 8) return static_cast<std::uint16_t>(std::clamp(radiance, 0.0, 1.0) * 255.0 + 0.5);
  return static_cast<std::uint16_t>(std::clamp(7000.0 + 2500.0 * radiance, 0.0, 65535.0) + 0.5);
}

}  // namespace

Silhouette room_mask(const RoomScene& scene, const Camera& camera) {
  const RenderedMesh warm = render(scene.warm.mesh, camera);
  const RenderedMesh cold = render(scene.cold, camera);
  Silhouette mask(camera.width, camera.height, PixelLabel::background);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      if (cold.depth(x, y) < warm.depth(x, y)) {
        mask(x, y) = PixelLabel::unknown;
      } else if (warm.triangle(x, y) >= 0) {
        mask(x, y) = PixelLabel::hand;
      }
    }
  }
  return mask;
}

CameraImage infrared_picture(const RoomScene& scene, const Camera& camera,
                             const InfraredSensor& sensor) {
  if (sensor.bits != 8 && sensor.bits != 16) {
    throw Error("simulated take: got ", sensor.bits, " bits a pixel, expected 8 or 16");
  }
  constexpr double kBlur = 0.9;    // [px]
  constexpr double kNoise = 0.01;  // of the range
  const EmptyRoom room(camera, sensor.room_seed);
  Image<float> radiance(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      radiance(x, y) = static_cast<float>(room.radiance(x, y));
    }
  }
  add_scene(scene, camera, room, radiance);
  radiance = blurred(radiance, kBlur);

  Random random(sensor.noise_seed);
  CameraImage picture{Image<std::uint16_t>(camera.width, camera.height), sensor.bits};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const double value = radiance(x, y) * room.vignetting(x, y) + random.normal(0.0, kNoise);
      picture.values(x, y) = quantised(value, sensor.bits);
    }
  }
  return picture;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "tegata/base/error.h"
#include "tegata/image/distance_transform.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

void expect_display_picture(const CameraImage& picture, const char* who) {
  if (picture.values.channels() == 3 && picture.bits == 8) return;
  throw Error(who, ": got a picture of ", picture.values.channels(), " channels and ", picture.bits,
              " bits, expected 3 channels of 8 bits; for_display() makes one");
}

void expect_size(const CameraImage& picture, int width, int height, const std::string& what) {
  if (picture.values.width() == width && picture.values.height() == height) return;
  throw Error(what, ": got a picture of ", picture.values.width(), " x ", picture.values.height(),
              ", expected ", width, " x ", height);
}

void set_pixel(CameraImage& picture, int x, int y, Colour colour) {
  for (int c = 0; c < 3; ++c) picture.values(x, y, c) = colour[static_cast<std::size_t>(c)];
}

// The value below which the given share of all values lies.
double percentile(std::vector<std::uint16_t> values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

// The surface's unit normal where a pixel's ray meets a triangle, between its corners' normals.
Eigen::Vector3d normal_at(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                          const Triangle& triangle, const Eigen::Vector3d& camera_center,
                          const Eigen::Vector3d& direction) {
  const Eigen::Vector3d origin = mesh.vertices[triangle[0]];
  const Eigen::Vector3d u = mesh.vertices[triangle[1]] - origin;
  const Eigen::Vector3d v = mesh.vertices[triangle[2]] - origin;
  // Barycentric coordinates by Cramer's rule (Moeller and Trumbore 1997).
  const Eigen::Vector3d from_origin = camera_center - origin;
  const Eigen::Vector3d p = direction.cross(v), q = from_origin.cross(u);
  const double determinant = u.dot(p);
  if (determinant == 0.0) return u.cross(v).normalized();
  const double b = from_origin.dot(p) / determinant, c = direction.dot(q) / determinant;
  const Eigen::Vector3d sum =
      (1.0 - b - c) * normals[triangle[0]] + b * normals[triangle[1]] + c * normals[triangle[2]];
  const double length = sum.norm();
  return length > 1e-6 ? Eigen::Vector3d(sum / length) : u.cross(v).normalized();
}

}  // namespace

CameraImage for_display(const CameraImage& picture) {
  const Image<std::uint16_t>& source = picture.values;
  if (source.empty() || (source.channels() != 1 && source.channels() != 3)) {
    throw Error("for_display: got a picture of ", source.width(), " x ", source.height(), " with ",
                source.channels(), " channels, expected pixels with 1 or 3 channels");
  }
  double darkest = 0.0, brightest = std::exp2(picture.bits) - 1.0;
  if (source.channels() == 1) {
    darkest = percentile(source.values(), 0.01);
    brightest = std::max(darkest + 1.0, percentile(source.values(), 0.999));
  }
  CameraImage shown{Image<std::uint16_t>(source.width(), source.height(), 0, 3), 8};
  for (int y = 0; y < source.height(); ++y) {
    for (int x = 0; x < source.width(); ++x) {
      for (int c = 0; c < 3; ++c) {
        const double value = source(x, y, source.channels() == 1 ? 0 : c);
        const double share = std::clamp((value - darkest) / (brightest - darkest), 0.0, 1.0);
        shown.values(x, y, c) = static_cast<std::uint16_t>(std::lround(255.0 * share));
      }
    }
  }
  return shown;
}

void draw_outline(CameraImage& picture, const Silhouette& silhouette, Colour colour, int width_px) {
  expect_display_picture(picture, "draw_outline");
  expect_size(picture, silhouette.width(), silhouette.height(), "draw_outline");
  const auto is_hand = [](PixelLabel label) { return label == PixelLabel::hand; };
  const Image<float> distance = signed_distance(silhouette, is_hand);
  // A line of odd width has its middle on the hand's outermost pixels.
  const auto inner = static_cast<float>((width_px + 1) / 2);
  const auto outer = static_cast<float>(width_px / 2);
  for (int y = 0; y < silhouette.height(); ++y) {
    for (int x = 0; x < silhouette.width(); ++x) {
      if (distance(x, y) < inner && distance(x, y) > -outer) set_pixel(picture, x, y, colour);
    }
  }
}

CameraImage shrunk(const CameraImage& picture, int widest) {
  const Image<std::uint16_t>& source = picture.values;
  if (widest < 1) throw Error("shrunk: got a width of ", widest, ", expected 1 pixel or more");
  const int factor = std::max(1, (source.width() + widest - 1) / widest);
  if (factor == 1) return picture;
  CameraImage small{
      Image<std::uint16_t>(source.width() / factor, std::max(1, source.height() / factor), 0,
                           source.channels()),
      picture.bits};
  for (int y = 0; y < small.values.height(); ++y) {
    const int rows = std::min(factor, source.height() - y * factor);
    for (int x = 0; x < small.values.width(); ++x) {
      for (int c = 0; c < source.channels(); ++c) {
        int sum = rows * factor / 2;  // half of the divisor: rounds to the nearest
        for (int v = y * factor; v < y * factor + rows; ++v) {
          for (int u = x * factor; u < (x + 1) * factor; ++u) sum += source(u, v, c);
        }
        small.values(x, y, c) = static_cast<std::uint16_t>(sum / (rows * factor));
      }
    }
  }
  return small;
}

CameraImage contact_sheet(const std::vector<CameraImage>& pictures, int columns, Colour paper) {
  if (columns < 1) throw Error("contact_sheet: got ", columns, " columns, expected 1 or more");
  const int count = static_cast<int>(pictures.size());
  int cell_width = 0, cell_height = 0;
  for (const CameraImage& picture : pictures) {
    expect_display_picture(picture, "contact_sheet");
    cell_width = std::max(cell_width, picture.values.width());
    cell_height = std::max(cell_height, picture.values.height());
  }
  const int rows = (count + columns - 1) / columns;
  CameraImage sheet{
      Image<std::uint16_t>(std::min(count, columns) * cell_width, rows * cell_height, 0, 3), 8};
  for (int y = 0; y < sheet.values.height(); ++y) {
    for (int x = 0; x < sheet.values.width(); ++x) set_pixel(sheet, x, y, paper);
  }
  for (int i = 0; i < count; ++i) {
    const Image<std::uint16_t>& source = pictures[static_cast<std::size_t>(i)].values;
    const int left = i % columns * cell_width + (cell_width - source.width()) / 2;
    const int top = i / columns * cell_height + (cell_height - source.height()) / 2;
    for (int y = 0; y < source.height(); ++y) {
      for (int x = 0; x < source.width(); ++x) {
        for (int c = 0; c < 3; ++c) sheet.values(left + x, top + y, c) = source(x, y, c);
      }
    }
  }
  return sheet;
}

void draw_shaded(CameraImage& picture, const TriangleMesh& mesh, const Camera& camera,
                 Colour colour) {
  expect_display_picture(picture, "draw_shaded");
  expect_size(picture, camera.width, camera.height,
              text("draw_shaded, camera '", camera.name, "'"));
  const RenderedMesh rendered = render(mesh, camera);
  const std::vector<Eigen::Vector3d> normals =
      mesh.normals.size() == mesh.vertices.size() ? mesh.normals : vertex_normals(mesh);
  const Eigen::Vector3d center = camera.center_in_world();
  constexpr double kAmbient = 0.2;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      if (rendered.triangle(x, y) < 0) continue;
      const Triangle& triangle = mesh.triangles[static_cast<std::size_t>(rendered.triangle(x, y))];
      const Eigen::Vector3d direction = pixel_direction(camera, {x, y});
      const Eigen::Vector3d normal = normal_at(mesh, normals, triangle, center, direction);
      const double light = kAmbient + (1.0 - kAmbient) * std::abs(normal.dot(direction));
      for (int c = 0; c < 3; ++c) {
        picture.values(x, y, c) =
            static_cast<std::uint16_t>(std::lround(light * colour[static_cast<std::size_t>(c)]));
      }
    }
  }
}

}  // namespace tegata

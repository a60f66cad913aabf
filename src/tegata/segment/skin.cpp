// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// A chrominance divided by the luminance is the same in light and shadow. On it, skin is the
// direction from the colour of the room to that of the largest piece that may be skin, in this very
// picture.
#include "tegata/segment/skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/segment/border.h"
#include "tegata/segment/components.h"
#include "tegata/segment/noise.h"

namespace tegata {
namespace {

constexpr int kLargestSkinPinhole = 60;  // [px]
constexpr int kRounds = 3;
constexpr double kDarkest = 30.0;  // luminance by which the division is kept from blowing up noise
constexpr double kNoise = 2.0;     // of compressed 8-bit video, per channel

// Channels Y, Cr, Cb on the scale of 8 bits, smoothed; Cr and Cb are 0 for grey.
Image<float> luminance_and_chrominance(const CameraImage& picture, double blur_px) {
  const Image<std::uint16_t>& source = picture.values;
  if (source.empty() || source.channels() != 3) {
    throw Error("segment_skin: got a picture of ", source.width(), " x ", source.height(), " with ",
                source.channels(), " channels, expected 3: red, green and blue");
  }
  const float scale = 255.0F / static_cast<float>((1 << picture.bits) - 1);
  Image<float> result(source.width(), source.height(), 0.0F, 3);
  for (int y = 0; y < source.height(); ++y) {
    for (int x = 0; x < source.width(); ++x) {
      const float red = scale * source(x, y, 0), green = scale * source(x, y, 1),
                  blue = scale * source(x, y, 2);
      const float luminance = 0.299F * red + 0.587F * green + 0.114F * blue;  // ITU-R BT.601
      result(x, y, 0) = luminance;
      result(x, y, 1) = 0.713F * (red - luminance);
      result(x, y, 2) = 0.564F * (blue - luminance);
    }
  }
  if (blur_px > 0.0) {
    cv::Mat view(result.height(), result.width(), CV_32FC3, result.values().data());
    cv::GaussianBlur(view, view, {0, 0}, blur_px, blur_px, cv::BORDER_REPLICATE);
  }
  return result;
}

// Chrominance in per cent of the luminance, and the luminance.
struct Tint {
  double cr = 0.0, cb = 0.0, luminance = 0.0;
};

Tint tint_of(const Image<float>& colours, int x, int y) {
  const double scale = 100.0 / (colours(x, y, 0) + kDarkest);
  return {scale * colours(x, y, 1), scale * colours(x, y, 2), colours(x, y, 0)};
}

template <typename Condition>
Silhouette select(const Image<float>& colours, const Condition& condition) {
  Silhouette silhouette(colours.width(), colours.height(), PixelLabel::background);
  for (int y = 0; y < colours.height(); ++y) {
    for (int x = 0; x < colours.width(); ++x) {
      if (condition(tint_of(colours, x, y))) silhouette(x, y) = PixelLabel::hand;
    }
  }
  return silhouette;
}

// What the skin of any person may have under any white light.
bool may_be_skin(const Tint& tint) {
  return tint.cr > 5.0 && tint.cr < 40.0 && tint.cb < -1.0 && tint.cb > -40.0;
}

// The tints of this picture's skin.
class SkinTint {
 public:
  // The medians over the silhouette and over the rest.
  SkinTint(const Image<float>& colours, const Silhouette& silhouette) {
    constexpr int kStride = 3;
    std::array<std::vector<float>, 2> cr, cb, luminance;
    for (int y = 0; y < colours.height(); y += kStride) {
      for (int x = 0; x < colours.width(); x += kStride) {
        const Tint tint = tint_of(colours, x, y);
        const std::size_t side = silhouette(x, y) == PixelLabel::hand ? 1 : 0;
        cr[side].push_back(static_cast<float>(tint.cr));
        cb[side].push_back(static_cast<float>(tint.cb));
        luminance[side].push_back(static_cast<float>(tint.luminance));
      }
    }
    if (cr[0].empty() || cr[1].empty()) return;
    room_ = {median(std::move(cr[0])), median(std::move(cb[0]))};
    step_ = {median(std::move(cr[1])) - room_.cr, median(std::move(cb[1])) - room_.cb};
    luminance_ = median(std::move(luminance[1]));
  }

  // Beige card and wood come up to 9 per cent, pale skin in bright light begins at 11.
  bool is_skin() const { return std::hypot(step_.cr, step_.cb) > 10.0; }
  // Half way or more from the room's tint to the skin's, not far aside, and no darker than shadow.
  bool has(const Tint& tint) const {
    const double squared = step_.cr * step_.cr + step_.cb * step_.cb;
    const double cr = tint.cr - room_.cr, cb = tint.cb - room_.cb;
    const double along = (cr * step_.cr + cb * step_.cb) / squared;
    const double aside = (cb * step_.cr - cr * step_.cb) / squared;
    return along > 0.5 && along < 2.0 && std::abs(aside) < 0.35 * along &&
           tint.luminance > 0.15 * luminance_;
  }

 private:
  Tint room_, step_;
  double luminance_ = 0.0;  // of the skin
};

// Cuts off what is narrower than `breadth` pixels (an odd number).
void open(Silhouette& silhouette, int breadth) {
  cv::Mat view(silhouette.height(), silhouette.width(), CV_8U, silhouette.values().data());
  cv::morphologyEx(view, view, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {breadth, breadth}));
}

}  // namespace

Silhouette segment_skin(const CameraImage& picture, const SkinOptions& options,
                        SegmentationReport* report) {
  const Image<float> colours = luminance_and_chrominance(picture, options.blur_px);
  const auto clean = [&](Silhouette& silhouette, int breadth) {
    open(silhouette, breadth);
    keep_large_components(silhouette, options.smallest_share);
  };
  // Cables and seams of a skin-like tint are narrower than fingers.
  const int narrow = 1 + 2 * (std::max(colours.width(), colours.height()) / 200);
  Silhouette silhouette = select(colours, may_be_skin);
  clean(silhouette, narrow);
  for (int round = 0; round < kRounds; ++round) {
    const SkinTint skin(colours, silhouette);
    if (!skin.is_skin()) {
      silhouette = Silhouette(colours.width(), colours.height(), PixelLabel::background);
      break;
    }
    silhouette = select(colours, [&](const Tint& tint) { return skin.has(tint); });
    clean(silhouette, narrow);
  }
  BorderReport border;
  for (int round = 0; round < 2; ++round) {
    // Shadows beside a hand would look like a slope that leads to its colour.
    border = move_border_to_half_height(colours, kNoise, {.shading = Shading::none}, silhouette);
    clean(silhouette, 3);
    fill_pinholes(silhouette, kLargestSkinPinhole);
  }
  std::size_t hand_pixels = count_pixels(silhouette, PixelLabel::hand);
  if (static_cast<double>(hand_pixels) <
      options.smallest_part * static_cast<double>(silhouette.pixel_count())) {
    silhouette = Silhouette(silhouette.width(), silhouette.height(), PixelLabel::background);
    hand_pixels = 0;
  }
  if (report != nullptr) {
    *report = {0.0, hand_pixels, hand_pixels == 0 ? 0.0 : border.clear_share};
  }
  return silhouette;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/background_difference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/segment/border.h"
#include "tegata/segment/components.h"
#include "tegata/segment/noise.h"

namespace tegata {
namespace {

constexpr double kThreshold = 6.0;  // times the noise
constexpr int kLargestGap = 30;     // [px]

void check_pair(const CameraImage& picture, const CameraImage& background) {
  const Image<std::uint16_t>&a = picture.values, &b = background.values;
  if (!a.empty() && a.width() == b.width() && a.height() == b.height() &&
      a.channels() == b.channels() && picture.bits == background.bits &&
      (a.channels() == 1 || a.channels() == 3)) {
    return;
  }
  throw Error("segment_background: got a picture of ", a.width(), " x ", a.height(), " with ",
              a.channels(), " channels of ", picture.bits, " bits and a background of ", b.width(),
              " x ", b.height(), " with ", b.channels(), " of ", background.bits,
              ", expected two alike with 1 or 3 channels");
}

// One channel of the difference in units of its noise. Its median is taken off: the light may have
// changed since the empty scene was taken, and the hand covers less than half of the picture.
Image<float> channel_difference(const CameraImage& picture, const CameraImage& background,
                                int channel, double& noise) {
  Image<float> difference(picture.values.width(), picture.values.height());
  for (int y = 0; y < difference.height(); ++y) {
    for (int x = 0; x < difference.width(); ++x) {
      difference(x, y) = static_cast<float>(picture.values(x, y, channel)) -
                         static_cast<float>(background.values(x, y, channel));
    }
  }
  const float offset = median(difference.values());
  noise = std::max(0.41, pixel_noise(difference));  // at least what rounding both of them leaves
  for (float& value : difference.values()) value = (value - offset) / static_cast<float>(noise);
  return difference;
}

}  // namespace

Silhouette segment_background(const CameraImage& picture, const CameraImage& background,
                              const BackgroundOptions& options, SegmentationReport* report) {
  check_pair(picture, background);
  const int width = picture.values.width(), height = picture.values.height();
  const int channels = picture.values.channels();
  Image<float> difference(width, height, 0.0F, channels);
  double least_noise = std::exp2(picture.bits);
  for (int c = 0; c < channels; ++c) {
    double noise = 0.0;
    const Image<float> one = channel_difference(picture, background, c, noise);
    least_noise = std::min(least_noise, noise);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) difference(x, y, c) = one(x, y);
    }
  }
  if (options.blur_px > 0.0) {
    cv::Mat view(height, width, CV_32FC(channels), difference.values().data());
    cv::GaussianBlur(view, view, {0, 0}, options.blur_px, options.blur_px, cv::BORDER_REPLICATE);
  }

  Silhouette silhouette(width, height, PixelLabel::background);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double largest = 0.0;
      for (int c = 0; c < channels; ++c) {
        largest = std::max<double>(largest, std::abs(difference(x, y, c)));
      }
      if (largest > kThreshold) silhouette(x, y) = PixelLabel::hand;
    }
  }
  BorderReport border;
  for (int round = 0; round < 2; ++round) {
    keep_large_components(silhouette, options.smallest_share);
    fill_pinholes(silhouette, kLargestGap);
    border = move_border_to_half_height(difference, 1.0, BorderOptions{}, silhouette);
  }
  keep_large_components(silhouette, options.smallest_share);
  fill_pinholes(silhouette, kLargestGap);
  std::size_t hand_pixels = count_pixels(silhouette, PixelLabel::hand);
  if (static_cast<double>(hand_pixels) < options.smallest_part * width * height) {
    silhouette = Silhouette(width, height, PixelLabel::background);
    hand_pixels = 0;
  }
  if (report != nullptr) {
    *report = {kThreshold * least_noise, hand_pixels, hand_pixels == 0 ? 0.0 : border.clear_share};
  }
  return silhouette;
}

}  // namespace tegata

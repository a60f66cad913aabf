// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/infrared.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
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

constexpr int kLargestPinhole = 30;  // [px]

Image<float> grey(const CameraImage& picture) {
  const Image<std::uint16_t>& source = picture.values;
  if (source.empty() || (source.channels() != 1 && source.channels() != 3)) {
    throw Error("segment_infrared: got a picture of ", source.width(), " x ", source.height(),
                " with ", source.channels(), " channels, expected pixels with 1 or 3 channels");
  }
  Image<float> mean(source.width(), source.height());
  const float share = 1.0F / static_cast<float>(source.channels());
  for (int y = 0; y < source.height(); ++y) {
    for (int x = 0; x < source.width(); ++x) {
      float sum = 0.0F;
      for (int c = 0; c < source.channels(); ++c) sum += source(x, y, c);
      mean(x, y) = sum * share;
    }
  }
  return mean;
}

void smooth(Image<float>& image, double sigma_px) {
  cv::Mat view(image.height(), image.width(), CV_32F, image.values().data());
  if (sigma_px > 0.0)
    cv::GaussianBlur(view, view, {0, 0}, sigma_px, sigma_px, cv::BORDER_REPLICATE);
}

// Otsu's threshold: between the two classes of values whose means are farthest apart.
double otsu_threshold(const Image<float>& image) {
  constexpr std::size_t kBins = 512;
  const auto [low, high] = std::minmax_element(image.values().begin(), image.values().end());
  const double start = *low, width = std::max(1e-6, (static_cast<double>(*high) - start) / kBins);
  std::array<double, kBins> histogram = {};
  for (const float value : image.values()) {
    const auto bin = static_cast<std::size_t>((static_cast<double>(value) - start) / width);
    histogram[std::min(bin, kBins - 1)] += 1.0;
  }
  double total = 0.0;
  for (std::size_t i = 0; i < kBins; ++i) total += static_cast<double>(i) * histogram[i];
  const double count = static_cast<double>(image.values().size());
  double below = 0.0, sum = 0.0, best = -1.0;
  std::size_t best_bin = 0;
  for (std::size_t i = 0; i + 1 < kBins; ++i) {
    below += histogram[i];
    sum += static_cast<double>(i) * histogram[i];
    const double above = count - below;
    if (below == 0.0 || above == 0.0) continue;
    const double gap = sum / below - (total - sum) / above;
    const double between = below * above * gap * gap;
    if (between > best) {
      best = between;
      best_bin = i;
    }
  }
  return start + width * static_cast<double>(best_bin + 1);
}

using Quadratic = Eigen::Matrix<double, 6, 1>;

Quadratic monomials(int x, int y, const Image<float>& image) {
  const double u = 2.0 * x / image.width() - 1.0, v = 2.0 * y / image.height() - 1.0;
  return (Quadratic() << 1.0, u, v, u * u, u * v, v * v).finished();
}

// Takes from the image the quadratic that fits its pixels below the threshold best, outliers
// trimmed: what is left of a slope or a vignetting of the background is then little.
void flatten(Image<float>& image, double threshold) {
  constexpr int kStride = 4;
  constexpr double kTrim = 2.5 * 1.4826;  // medians of the absolute residual
  struct Sample {
    Quadratic row;
    double value;
  };
  std::vector<Sample> samples;
  for (int y = kStride / 2; y < image.height(); y += kStride) {
    for (int x = kStride / 2; x < image.width(); x += kStride) {
      if (image(x, y) <= threshold) samples.push_back({monomials(x, y, image), image(x, y)});
    }
  }
  if (samples.size() < 100) return;
  Quadratic fit = Quadratic::Zero();
  std::vector<float> residuals(samples.size(), 0.0F);
  for (int round = 0; round < 4; ++round) {
    const double limit = kTrim * median(residuals);
    Eigen::Matrix<double, 6, 6> normal = 1e-9 * Eigen::Matrix<double, 6, 6>::Identity();
    Quadratic right = Quadratic::Zero();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (residuals[i] > limit) continue;
      normal += samples[i].row * samples[i].row.transpose();
      right += samples[i].row * samples[i].value;
    }
    fit = normal.ldlt().solve(right);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      residuals[i] = static_cast<float>(std::abs(samples[i].value - fit.dot(samples[i].row)));
    }
  }
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image(x, y) -= static_cast<float>(fit.dot(monomials(x, y, image)));
    }
  }
}

// What lies above a threshold and what below, by their medians.
struct Classes {
  double low, high;
  double middle() const { return 0.5 * (low + high); }
};

Classes split_classes(const Image<float>& image, double threshold) {
  std::vector<float> below, above;
  for (const float value : image.values()) (value > threshold ? above : below).push_back(value);
  if (below.empty() || above.empty()) return {threshold, threshold};
  return {median(below), median(above)};
}

}  // namespace

Silhouette segment_infrared(const CameraImage& picture, const InfraredOptions& options,
                            SegmentationReport* report) {
  Image<float> image = grey(picture);
  // Never less than what rounding to whole counts leaves.
  const double noise = std::max(0.29, pixel_noise(image));
  smooth(image, options.blur_px);
  flatten(image, otsu_threshold(image));
  const Classes classes = split_classes(image, otsu_threshold(image));

  Silhouette silhouette(image.width(), image.height(), PixelLabel::background);
  std::transform(image.values().begin(), image.values().end(), silhouette.values().begin(),
                 [&](float value) {
                   return value > classes.middle() ? PixelLabel::hand : PixelLabel::background;
                 });
  keep_large_components(silhouette, options.smallest_share);
  const BorderOptions border;
  constexpr double kLeastContrast = 6.0;  // times the noise
  for (int round = 0; round < 2; ++round) {
    fill_pinholes(silhouette, kLargestPinhole);
    move_border_to_half_height(image, noise, border, silhouette);
  }
  keep_large_components(silhouette, options.smallest_share);
  fill_pinholes(silhouette, kLargestPinhole);
  // A hand stands out from what is around it: shading fades away, noise has no border of its size.
  const double contrast = border_contrast(image, border, silhouette);
  if (contrast < std::max(kLeastContrast * noise, 0.5 * (classes.high - classes.low))) {
    silhouette = Silhouette(image.width(), image.height(), PixelLabel::background);
  }
  if (report != nullptr) *report = {classes.middle(), count_pixels(silhouette, PixelLabel::hand)};
  return silhouette;
}

}  // namespace tegata

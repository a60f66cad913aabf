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
#include <optional>
#include <utility>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/segment/border.h"
#include "tegata/segment/components.h"
#include "tegata/segment/noise.h"

namespace tegata {
namespace {

constexpr int kLargestPinhole = 30;  // [px]
// Of the step between hand and room, at the border: shading takes off the rest.
constexpr double kLeastContrast = 0.4;

Image<float> grey(const CameraImage& picture) {
  const Image<std::uint16_t>& source = picture.values;
  if (source.empty() || (source.channels() != 1 && source.channels() != 3)) {
    throw Error("segment_infrared: got a picture of ", source.width(), " x ", source.height(),
                " with ", source.channels(), " channels, expected pixels with 1 or 3 channels");
  }
  Image<float> mean(source.width(), source.height());
  const std::uint16_t* value = source.values().data();
  if (source.channels() == 1) {
    std::copy(value, value + source.values().size(), mean.values().begin());
    return mean;
  }
  for (float& grey : mean.values()) {
    grey = static_cast<float>(value[0] + value[1] + value[2]) / 3.0F;
    value += 3;
  }
  return mean;
}

void smooth(Image<float>& image, double sigma_px) {
  cv::Mat view(image.height(), image.width(), CV_32F, image.values().data());
  if (sigma_px > 0.0)
    cv::GaussianBlur(view, view, {0, 0}, sigma_px, sigma_px, cv::BORDER_REPLICATE);
}

// The stride of a lattice of about so many pixels.
int lattice_stride(const Image<float>& image, double count) {
  return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(image.pixel_count()) / count)));
}

// Values of the image on a lattice.
std::vector<float> lattice(const Image<float>& image) {
  constexpr double kEnough = 8000.0;
  const int stride = lattice_stride(image, kEnough);
  std::vector<float> values;
  values.reserve(image.pixel_count() / static_cast<std::size_t>(stride * stride) + 1);
  for (int y = stride / 2; y < image.height(); y += stride) {
    for (int x = stride / 2; x < image.width(); x += stride) values.push_back(image(x, y));
  }
  return values;
}

// Otsu's threshold: between the two classes of values whose means are farthest apart. The values
// may be reordered. One in a thousand at either end, as of dead and hot pixels, is moved to where
// the others end, so that they do not take the histogram for themselves.
double otsu_threshold(std::vector<float>& values) {
  constexpr std::size_t kBins = 512;
  if (values.empty()) return 0.0;
  const auto few = static_cast<std::ptrdiff_t>(values.size() / 1000);
  const auto low = values.begin() + few, high = values.end() - 1 - few;
  std::nth_element(values.begin(), low, values.end());
  std::nth_element(low, high, values.end());
  const double start = *low, width = std::max(1e-6, (static_cast<double>(*high) - start) / kBins);
  const double bins_a_unit = 1.0 / width;
  std::array<double, kBins> histogram = {};
  for (const float value : values) {
    const double bin = (static_cast<double>(value) - start) * bins_a_unit;
    histogram[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 0.5))] += 1.0;
  }
  double total = 0.0;
  for (std::size_t i = 0; i < kBins; ++i) total += static_cast<double>(i) * histogram[i];
  const double count = static_cast<double>(values.size());
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

// 1, u, v, u^2, u v, v^2 with u and v from -1 to 1 over the picture.
Quadratic monomials(double u, double v) {
  return (Quadratic() << 1.0, u, v, u * u, u * v, v * v).finished();
}
double across(int x, int width) { return 2.0 * x / width - 1.0; }

// The quadratic that fits the pixels below a threshold best, outliers trimmed; nothing where they
// are too few.
std::optional<Quadratic> fit_background(const Image<float>& image, double threshold) {
  constexpr double kEnough = 2500.0;
  constexpr std::size_t kLeast = 100;
  constexpr double kTrim = 2.5 * 1.4826;  // medians of the absolute residual
  const int stride = lattice_stride(image, kEnough);
  struct Sample {
    Quadratic row;
    double value;
  };
  std::vector<Sample> samples;
  for (int y = stride / 2; y < image.height(); y += stride) {
    for (int x = stride / 2; x < image.width(); x += stride) {
      if (image(x, y) > threshold) continue;
      samples.push_back(
          {monomials(across(x, image.width()), across(y, image.height())), image(x, y)});
    }
  }
  if (samples.size() < kLeast) return std::nullopt;
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
  return fit;
}

// Takes that quadratic off: what is left of a slope or a vignetting of the background is little.
void flatten(Image<float>& image, double threshold) {
  const std::optional<Quadratic> background = fit_background(image, threshold);
  if (!background) return;
  const Quadratic& fit = *background;
  for (int y = 0; y < image.height(); ++y) {
    // Of the row's x alone: a parabola.
    const double v = across(y, image.height()), step = 2.0 / image.width();
    const double at_zero = fit[0] + fit[2] * v + fit[5] * v * v, slope = fit[1] + fit[4] * v;
    const auto constant = static_cast<float>(at_zero - slope + fit[3]);
    const auto linear = static_cast<float>((slope - 2.0 * fit[3]) * step);
    const auto square = static_cast<float>(fit[3] * step * step);
    float* const row = &image(0, y);
    for (int x = 0; x < image.width(); ++x) {
      const auto along = static_cast<float>(x);
      row[x] -= constant + along * (linear + along * square);
    }
  }
}

// Marks as hand what is above a threshold, all else as background.
void above(const Image<float>& image, double threshold, Silhouette& silhouette) {
  const cv::Mat from(image.height(), image.width(), CV_32F,
                     // Only read from.
                     const_cast<float*>(image.values().data()));
  cv::Mat to(silhouette.height(), silhouette.width(), CV_8U, silhouette.values().data());
  cv::compare(from, threshold, to, cv::CMP_GT);  // 255 and 0, the labels of both
}

// What lies above a threshold and what below, by their medians.
struct Classes {
  double low, high;
  double middle() const { return 0.5 * (low + high); }
};

Classes split_classes(const std::vector<float>& values, double threshold) {
  std::vector<float> below, above;
  for (const float value : values) (value > threshold ? above : below).push_back(value);
  if (below.empty() || above.empty()) return {threshold, threshold};
  return {median(std::move(below)), median(std::move(above))};
}

// The pixels of one silhouette that are not hand in the other.
Silhouette without(Silhouette silhouette, const Silhouette& other) {
  for (std::size_t i = 0; i < silhouette.values().size(); ++i) {
    if (other.values()[i] == PixelLabel::hand) silhouette.values()[i] = PixelLabel::background;
  }
  return silhouette;
}

void add(Silhouette& silhouette, const Silhouette& other) {
  for (std::size_t i = 0; i < silhouette.values().size(); ++i) {
    if (other.values()[i] == PixelLabel::hand) silhouette.values()[i] = PixelLabel::hand;
  }
}

// Cuts off what is narrower than three pixels, as the blurred rims of what is warmer are.
void cut_off_rims(Silhouette& silhouette) {
  cv::Mat view(silhouette.height(), silhouette.width(), CV_8U, silhouette.values().data());
  cv::morphologyEx(view, view, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
}

// The edge between a piece of the warm and the rest of it.
BorderReport edge_of(const Silhouette& piece, const Silhouette& cooler, const Image<float>& image,
                     double noise) {
  Silhouette parts(image.width(), image.height(), PixelLabel::unknown);
  for (std::size_t i = 0; i < parts.values().size(); ++i) {
    if (piece.values()[i] == PixelLabel::hand) parts.values()[i] = PixelLabel::hand;
    if (cooler.values()[i] == PixelLabel::hand) parts.values()[i] = PixelLabel::background;
  }
  return move_border_to_half_height(image, noise, {}, parts);
}

// Whether a piece ends at an edge all around, as a hand does; a patch of warm cloth fades into the
// rest of it on most sides.
bool is_outlined(const Silhouette& piece, const Image<float>& image, double noise) {
  constexpr double kLeastClear = 0.25;  // of the outline
  Silhouette whole = piece;
  return move_border_to_half_height(image, noise, {}, whole).clear_share > kLeastClear;
}

// The mean value of the image over a silhouette's hand.
double mean_over(const Silhouette& silhouette, const Image<float>& image) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < silhouette.values().size(); ++i) {
    if (silhouette.values()[i] != PixelLabel::hand) continue;
    sum += static_cast<double>(image.values()[i]);
    count += 1.0;
  }
  return sum / std::max(1.0, count);
}

// Sleeves, clothes and what the hand has warmed lie between it and the room. Pieces that are warmer
// than the rest of the silhouette and parted from it by an edge, as skin is from cloth, take its
// place. Where skin is merely warmer here than there the warmth fades. Small cooler pieces beside
// them stay: cold fingers. Returns by how much the hand is warmer than what it was parted from;
// nothing where it stays as it is.
std::optional<double> narrow_to_warmest(const Image<float>& image, double noise,
                                        const Classes& picture, Silhouette& silhouette) {
  constexpr double kLeastStep = 0.25;   // of what the warmer part is above the room
  constexpr double kLeastEdge = 0.5;    // of the step must be there within the border's reach
  constexpr double kLeastClear = 0.6;   // of the border
  constexpr double kLeastLevel = 0.75;  // on the way from the cooler part's level to the warmer's
  constexpr double kMostCooler = 0.25;  // of the largest piece
  constexpr double kLeastPiece = 0.25;  // of the largest
  constexpr int kMostPieces = 6;
  std::vector<float> values;
  for (int y = 0; y < image.height(); y += 3) {
    for (int x = 0; x < image.width(); x += 3) {
      if (silhouette(x, y) == PixelLabel::hand) values.push_back(image(x, y));
    }
  }
  const Classes classes = split_classes(values, otsu_threshold(values));
  const double step = classes.high - classes.low;
  if (!(step > kLeastStep * (classes.high - picture.low))) return std::nullopt;
  Silhouette whole = silhouette;
  const BorderReport outline = move_border_to_half_height(image, noise, {}, whole);
  if (outline.contrast < kLeastContrast * (picture.high - picture.low)) return std::nullopt;
  Silhouette warmer = silhouette;
  for (std::size_t i = 0; i < warmer.values().size(); ++i) {
    if (static_cast<double>(image.values()[i]) <= classes.middle()) {
      warmer.values()[i] = PixelLabel::background;
    }
  }
  const Silhouette cooler = without(silhouette, warmer);
  Silhouette kept(image.width(), image.height(), PixelLabel::background);
  std::size_t largest = 0, least = 0;
  bool has_edge = false;
  for (int i = 0; i < kMostPieces; ++i) {
    Silhouette piece = warmer;
    keep_large_components(piece, 1.0);
    const std::size_t pixels = count_pixels(piece, PixelLabel::hand);
    if (i == 0) least = static_cast<std::size_t>(kLeastPiece * static_cast<double>(pixels));
    if (pixels <= least) break;
    warmer = without(std::move(warmer), piece);
    if (mean_over(piece, image) < classes.low + kLeastLevel * step) continue;
    const BorderReport edge = edge_of(piece, cooler, image, noise);
    const bool stands_alone = edge.contrast == 0.0;
    const bool is_edge = edge.contrast > kLeastEdge * step && edge.clear_share > kLeastClear;
    if ((!stands_alone && !is_edge) || !is_outlined(piece, image, noise)) continue;
    has_edge = has_edge || is_edge;
    largest = std::max(largest, pixels);
    add(kept, piece);
  }
  if (!has_edge) return std::nullopt;
  Silhouette beside = without(silhouette, kept);
  cut_off_rims(beside);
  drop_large_components(beside,
                        static_cast<std::size_t>(kMostCooler * static_cast<double>(largest)));
  add(beside, kept);
  keep_components_with(beside, kept);
  silhouette = std::move(beside);
  return step;
}

}  // namespace

Silhouette segment_infrared(const CameraImage& picture, const InfraredOptions& options,
                            SegmentationReport* report) {
  Image<float> image = grey(picture);
  // Never less than what rounding to whole counts leaves.
  const double noise = std::max(0.29, pixel_noise(image));
  smooth(image, options.blur_px);
  std::vector<float> values = lattice(image);
  flatten(image, otsu_threshold(values));
  values = lattice(image);
  const Classes classes = split_classes(values, otsu_threshold(values));

  Silhouette silhouette(image.width(), image.height(), PixelLabel::background);
  above(image, classes.middle(), silhouette);
  keep_large_components(silhouette, options.smallest_share);
  const double step =
      narrow_to_warmest(image, noise, classes, silhouette).value_or(classes.high - classes.low);
  fill_pinholes(silhouette, kLargestPinhole);
  BorderReport border = move_border_to_half_height(image, noise, {}, silhouette);
  constexpr int kMoves = 2;
  for (int move = 0; move < kMoves; ++move) {
    fill_pinholes(silhouette, kLargestPinhole);
    move_border_to_half_height(image, noise, {.shading = Shading::round}, silhouette);
  }
  keep_large_components(silhouette, options.smallest_share);
  fill_pinholes(silhouette, kLargestPinhole);
  // A hand stands out from what is around it: shading fades away, noise has no border of its size.
  constexpr double kLeastNoise = 6.0;  // times the noise
  if (border.contrast < std::max(kLeastNoise * noise, kLeastContrast * step)) {
    silhouette = Silhouette(image.width(), image.height(), PixelLabel::background);
    border = {};
  }
  if (report != nullptr) {
    *report = {classes.middle(), count_pixels(silhouette, PixelLabel::hand), border.clear_share};
  }
  return silhouette;
}

}  // namespace tegata

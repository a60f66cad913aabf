// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// J. Immerkaer: Fast Noise Variance Estimation. Computer Vision and Image Understanding 64, 1996.
#include "tegata/segment/noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tegata {

double pixel_noise(const Image<float>& image) {
  if (image.width() < 3 || image.height() < 3) return 0.0;
  // So many say the median to two in a hundred.
  constexpr double kEnough = 8000.0;
  const int stride =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(image.pixel_count()) / kEnough)));
  std::vector<float> responses;
  for (int y = 1; y + 1 < image.height(); y += stride) {
    for (int x = 1; x + 1 < image.width(); x += stride) {
      const float corners =
          image(x - 1, y - 1) + image(x + 1, y - 1) + image(x - 1, y + 1) + image(x + 1, y + 1);
      const float sides = image(x, y - 1) + image(x - 1, y) + image(x + 1, y) + image(x, y + 1);
      responses.push_back(std::abs(corners - 2.0F * sides + 4.0F * image(x, y)));
    }
  }
  constexpr double kMaskNorm = 6.0;           // root of the sum of the mask's squares
  constexpr double kMedianOfNormal = 0.6745;  // of |x| for a standard normal x
  return median(std::move(responses)) / (kMaskNorm * kMedianOfNormal);
}

float median(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace tegata

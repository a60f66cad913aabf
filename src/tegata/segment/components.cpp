// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/segment/components.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace tegata {
namespace {

struct Pieces {
  cv::Mat labels;             // 0 is what is not in any piece
  std::vector<int> pixels;    // of each label
  std::vector<bool> at_edge;  // whether a piece touches the edge of the picture
};

Pieces find_pieces(const Silhouette& silhouette, PixelLabel label, int connectivity) {
  const int width = silhouette.width(), height = silhouette.height();
  cv::Mat mask(height, width, CV_8U);
  std::transform(silhouette.values().begin(), silhouette.values().end(), mask.begin<std::uint8_t>(),
                 [&](PixelLabel l) { return static_cast<std::uint8_t>(l == label ? 1 : 0); });
  Pieces pieces;
  cv::Mat statistics, centres;
  const int count = cv::connectedComponentsWithStats(mask, pieces.labels, statistics, centres,
                                                     connectivity, CV_32S);
  for (int i = 0; i < count; ++i) {
    const int left = statistics.at<int>(i, cv::CC_STAT_LEFT);
    const int top = statistics.at<int>(i, cv::CC_STAT_TOP);
    pieces.pixels.push_back(statistics.at<int>(i, cv::CC_STAT_AREA));
    pieces.at_edge.push_back(left == 0 || top == 0 ||
                             left + statistics.at<int>(i, cv::CC_STAT_WIDTH) == width ||
                             top + statistics.at<int>(i, cv::CC_STAT_HEIGHT) == height);
  }
  return pieces;
}

template <typename Condition>
void relabel(Silhouette& silhouette, const Pieces& pieces, PixelLabel label,
             const Condition& condition) {
  auto piece = pieces.labels.begin<int>();
  for (PixelLabel& pixel : silhouette.values()) {
    if (*piece > 0 && condition(static_cast<std::size_t>(*piece))) pixel = label;
    ++piece;
  }
}

}  // namespace

void keep_large_components(Silhouette& silhouette, double smallest_share) {
  const Pieces pieces = find_pieces(silhouette, PixelLabel::hand, 8);
  if (pieces.pixels.size() < 2) return;
  const auto largest = std::max_element(pieces.pixels.begin() + 1, pieces.pixels.end());
  const auto largest_piece = static_cast<std::size_t>(largest - pieces.pixels.begin());
  const double smallest = smallest_share * *largest;
  relabel(silhouette, pieces, PixelLabel::background, [&](std::size_t piece) {
    return piece != largest_piece && (smallest_share >= 1.0 || pieces.pixels[piece] < smallest);
  });
}

void fill_pinholes(Silhouette& silhouette, int largest_px) {
  const Pieces pieces = find_pieces(silhouette, PixelLabel::background, 4);
  relabel(silhouette, pieces, PixelLabel::hand, [&](std::size_t piece) {
    return pieces.pixels[piece] <= largest_px && !pieces.at_edge[piece];
  });
}

}  // namespace tegata

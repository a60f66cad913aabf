// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/board_detection.h"

#include <algorithm>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "tegata/base/error.h"
#include "tegata/calibrate/charuco_board.h"
#include "tegata/image/overlay.h"

namespace tegata {
namespace {

// 8 bits of grey, black on white.
cv::Mat gray_picture(const CameraImage& picture, bool inverted) {
  const CameraImage shown = for_display(picture);
  cv::Mat gray(shown.values.height(), shown.values.width(), CV_8U);
  for (int y = 0; y < gray.rows; ++y) {
    for (int x = 0; x < gray.cols; ++x) {
      const int sum = 2 * shown.values(x, y, 0) + 5 * shown.values(x, y, 1) + shown.values(x, y, 2);
      const int value = sum / 8;
      gray.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(inverted ? 255 - value : value);
    }
  }
  return gray;
}

BoardView whole_view(const std::vector<cv::Point2f>& found) {
  BoardView view;
  for (std::size_t i = 0; i < found.size(); ++i) {
    view.points.push_back(static_cast<int>(i));
    view.pixels.emplace_back(found[i].x, found[i].y);
  }
  return view;
}

// The mean grey in the middle of the square between four inner corners.
double square_gray(const cv::Mat& gray, const std::vector<cv::Point2f>& corners, int columns, int x,
                   int y) {
  const auto corner = [&](int column, int row) {
    return corners[static_cast<std::size_t>(row * columns + column)];
  };
  const cv::Point2f middle =
      0.25f * (corner(x, y) + corner(x + 1, y) + corner(x, y + 1) + corner(x + 1, y + 1));
  const cv::Rect around(static_cast<int>(middle.x) - 1, static_cast<int>(middle.y) - 1, 3, 3);
  return cv::mean(gray(around & cv::Rect(0, 0, gray.cols, gray.rows)))[0];
}

BoardView detect_chessboard(const cv::Mat& gray, const Board& board) {
  std::vector<cv::Point2f> corners;
  const cv::Size size(board.columns, board.rows);
  if (!cv::findChessboardCorners(
          gray, size, corners,
          cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK)) {
    return {};
  }
  constexpr int kWidestWindow = 11;
  const double step = cv::norm(corners[1] - corners[0]);
  const int window = std::clamp(static_cast<int>(step / 3.0), 2, kWidestWindow);
  cv::cornerSubPix(gray, corners, {window, window}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 50, 1e-3});
  // The first square within is black, the last one white.
  const double first = square_gray(gray, corners, board.columns, 0, 0);
  const double last = square_gray(gray, corners, board.columns, board.columns - 2, board.rows - 2);
  if (first > last) std::reverse(corners.begin(), corners.end());
  return whole_view(corners);
}

// Centres of what may be a circle of a board of `count`, [px]. A picture without a board, stretched
// to all greys, shows thousands of specks of noise, among which a search for a grid takes hours:
// the largest are kept.
std::vector<cv::Point2f> round_blobs(const cv::Mat& gray, int count) {
  cv::SimpleBlobDetector::Params params;
  params.minThreshold = 20.0f;
  params.maxThreshold = 235.0f;
  params.thresholdStep = 10.0f;
  params.minDistBetweenBlobs = 4.0f;
  params.minArea = 12.0f;
  params.maxArea = 0.02f * static_cast<float>(gray.total());
  params.filterByConvexity = true;
  params.minConvexity = 0.85f;
  params.filterByInertia = true;
  params.minInertiaRatio = 0.15f;
  std::vector<cv::KeyPoint> blobs;
  cv::SimpleBlobDetector::create(params)->detect(gray, blobs);
  std::stable_sort(blobs.begin(), blobs.end(),
                   [](const cv::KeyPoint& a, const cv::KeyPoint& b) { return a.size > b.size; });
  const std::size_t most = 3 * static_cast<std::size_t>(count);
  if (blobs.size() > most) blobs.resize(most);
  std::vector<cv::Point2f> centers;
  cv::KeyPoint::convert(blobs, centers);
  return centers;
}

BoardView detect_circles(const cv::Mat& gray, const Board& board) {
  const int count = board.columns * board.rows;
  const std::vector<cv::Point2f> blobs = round_blobs(gray, count);
  if (blobs.size() < static_cast<std::size_t>(count)) return {};
  std::vector<cv::Point2f> centers;
  const cv::Size size(board.columns, board.rows);
  for (const int flags : {int{cv::CALIB_CB_ASYMMETRIC_GRID},
                          cv::CALIB_CB_ASYMMETRIC_GRID | cv::CALIB_CB_CLUSTERING}) {
    if (cv::findCirclesGrid(blobs, size, centers, flags, nullptr)) return whole_view(centers);
  }
  return {};
}

}  // namespace

struct BoardDetector::State {
  Board board;
  cv::Ptr<cv::aruco::CharucoBoard> charuco;

  BoardView detect_charuco(const cv::Mat& gray) const;
  /// A board that is printed on both sides, or shines through, shows its mirror image from behind:
  /// the same points.
  BoardView detect_charuco_from_behind(const cv::Mat& gray) const;
};

BoardView BoardDetector::State::detect_charuco(const cv::Mat& gray) const {
  std::vector<std::vector<cv::Point2f>> markers;
  std::vector<int> ids;
  cv::aruco::detectMarkers(gray, charuco->dictionary, markers, ids);
  if (ids.empty()) return {};
  cv::Mat corners, corner_ids;
  cv::aruco::interpolateCornersCharuco(markers, ids, gray, charuco, corners, corner_ids);
  BoardView view;
  for (int i = 0; i < corner_ids.rows; ++i) {
    const auto& pixel = corners.at<cv::Point2f>(i);
    view.points.push_back(corner_ids.at<int>(i));
    // OpenCV counts these from the corner of the first pixel, all others from its centre.
    view.pixels.emplace_back(pixel.x - 0.5, pixel.y - 0.5);
  }
  return view;
}

BoardView BoardDetector::State::detect_charuco_from_behind(const cv::Mat& gray) const {
  cv::Mat mirrored;
  cv::flip(gray, mirrored, 1);
  BoardView view = detect_charuco(mirrored);
  for (Eigen::Vector2d& pixel : view.pixels) pixel.x() = gray.cols - 1 - pixel.x();
  return view;
}

BoardDetector::BoardDetector(const Board& board) : state_(std::make_unique<State>()) {
  check_board(board);
  state_->board = board;
  if (board.kind != BoardKind::charuco) return;
  state_->charuco = charuco_board(board);
}

BoardDetector::~BoardDetector() = default;

BoardView BoardDetector::detect(const CameraImage& picture) const {
  constexpr int kSmall = 800;  // pictures of fewer columns are enlarged
  cv::Mat gray = gray_picture(picture, state_->board.inverted);
  const int factor = (kSmall + gray.cols - 1) / gray.cols;
  if (factor > 1) cv::resize(gray, gray, {}, factor, factor, cv::INTER_CUBIC);
  const Board& board = state_->board;
  BoardView view;
  if (board.kind == BoardKind::charuco) {
    view = state_->detect_charuco(gray);
    if (view.points.empty()) view = state_->detect_charuco_from_behind(gray);
  } else {
    view = board.kind == BoardKind::chessboard ? detect_chessboard(gray, board)
                                               : detect_circles(gray, board);
  }
  for (Eigen::Vector2d& pixel : view.pixels) {
    pixel = (pixel.array() + 0.5) / static_cast<double>(factor) - 0.5;
  }
  return view;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenCV's object for a ChArUco board; for this room's sources, so that no header that is installed
// names a type of OpenCV.
#pragma once

#include <algorithm>
#include <array>
#include <opencv2/aruco/charuco.hpp>
#include <string>
#include <string_view>

#include "tegata/base/error.h"
#include "tegata/calibrate/board.h"

namespace tegata {

/// OpenCV's number of a dictionary of markers. Throws Error for a name that is none of them.
inline int dictionary_number(const std::string& name) {
  // In the order of OpenCV's numbers.
  static constexpr std::array<std::string_view, 21> kDictionaries = {
      "DICT_4X4_50",         "DICT_4X4_100",       "DICT_4X4_250",       "DICT_4X4_1000",
      "DICT_5X5_50",         "DICT_5X5_100",       "DICT_5X5_250",       "DICT_5X5_1000",
      "DICT_6X6_50",         "DICT_6X6_100",       "DICT_6X6_250",       "DICT_6X6_1000",
      "DICT_7X7_50",         "DICT_7X7_100",       "DICT_7X7_250",       "DICT_7X7_1000",
      "DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_16h5", "DICT_APRILTAG_25h9", "DICT_APRILTAG_36h10",
      "DICT_APRILTAG_36h11"};
  const auto found = std::find(kDictionaries.begin(), kDictionaries.end(), name);
  if (found == kDictionaries.end()) {
    throw Error("board: got the dictionary '", name, "', expected one of OpenCV's, as '",
                kDictionaries.front(), "'");
  }
  return static_cast<int>(found - kDictionaries.begin());
}

/// Throws Error where the dictionary is none of OpenCV's.
inline cv::Ptr<cv::aruco::CharucoBoard> charuco_board(const Board& board) {
  return cv::aruco::CharucoBoard::create(
      board.columns, board.rows, static_cast<float>(board.spacing),
      static_cast<float>(board.marker),
      cv::aruco::getPredefinedDictionary(dictionary_number(board.dictionary)));
}

}  // namespace tegata

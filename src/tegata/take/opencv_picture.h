// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Between OpenCV's pictures and ours; for this room's sources, so that no header that is installed
// names a type of OpenCV.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "tegata/base/error.h"
#include "tegata/image/image.h"

namespace tegata {

/// OpenCV's channel (blue first) of one of ours (red first), and the other way round.
inline int swapped_channel(int channel, int channel_count) {
  return channel_count == 3 ? 2 - channel : channel;
}

/// Copies 8 or 16 bit values of 1 or 3 channels. Throws Error for other pictures.
inline CameraImage picture_from_opencv(const cv::Mat& mat) {
  const int channels = mat.channels();
  if ((mat.depth() != CV_8U && mat.depth() != CV_16U) || (channels != 1 && channels != 3)) {
    throw Error("got a picture of ", mat.elemSize1() * 8, " bits a value and ", channels,
                " channels, expected 8 or 16 bits and 1 or 3 channels");
  }
  CameraImage picture{Image<std::uint16_t>(mat.cols, mat.rows, 0, channels),
                      mat.depth() == CV_8U ? 8 : 16};
  for (int y = 0; y < mat.rows; ++y) {
    for (int x = 0; x < mat.cols; ++x) {
      for (int channel = 0; channel < channels; ++channel) {
        const int at = x * channels + swapped_channel(channel, channels);
        picture.values(x, y, channel) =
            picture.bits == 8 ? mat.ptr<std::uint8_t>(y)[at] : mat.ptr<std::uint16_t>(y)[at];
      }
    }
  }
  return picture;
}

inline cv::Mat opencv_picture(const CameraImage& picture) {
  const Image<std::uint16_t>& values = picture.values;
  const int channels = values.channels();
  cv::Mat mat(values.height(), values.width(),
              CV_MAKETYPE(picture.bits == 8 ? CV_8U : CV_16U, channels));
  for (int y = 0; y < mat.rows; ++y) {
    for (int x = 0; x < mat.cols; ++x) {
      for (int channel = 0; channel < channels; ++channel) {
        const int at = x * channels + swapped_channel(channel, channels);
        const std::uint16_t value = values(x, y, channel);
        if (picture.bits == 8) {
          mat.ptr<std::uint8_t>(y)[at] = static_cast<std::uint8_t>(value);
        } else {
          mat.ptr<std::uint16_t>(y)[at] = value;
        }
      }
    }
  }
  return mat;
}

}  // namespace tegata

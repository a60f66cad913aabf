// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/write_video.h"

#include <opencv2/videoio.hpp>

#include "tegata/base/error.h"
#include "tegata/take/opencv_picture.h"
#include "tegata/take/silent_opencv.h"

namespace tegata {

void write_video(const std::filesystem::path& file, double pictures_per_second, std::size_t count,
                 const std::function<CameraImage(std::size_t)>& picture) {
  cv::VideoWriter writer;
  cv::Size size;
  for (std::size_t i = 0; i < count; ++i) {
    const cv::Mat mat = opencv_picture(picture(i));
    if (i == 0) {
      size = mat.size();
      if (mat.type() != CV_8UC3 || size.width % 2 != 0 || size.height % 2 != 0) {
        throw Error(file.string(), ": got pictures of ", size.width, "x", size.height, " and ",
                    mat.channels(), " channels, expected 8-bit colour and even numbers");
      }
      const SilentOpenCv silent;
      writer.open(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('a', 'v', 'c', '1'),
                  pictures_per_second, size);
      if (!writer.isOpened()) throw Error(file.string(), ": cannot be written as an H.264 video");
    } else if (mat.size() != size || mat.type() != CV_8UC3) {
      throw Error(file.string(), ": picture ", i, " is not like the first");
    }
    writer.write(mat);
  }
}

}  // namespace tegata

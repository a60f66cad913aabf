// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/picture_file.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <string_view>

#include "tegata/base/error.h"
#include "tegata/take/opencv_picture.h"
#include "tegata/take/picture_container.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

cv::Mat decode(std::string_view bytes) {
  const PictureFormat format = check_picture_container(bytes);
  std::string filtered;
  int flags = cv::IMREAD_ANYDEPTH | cv::IMREAD_ANYCOLOR;
  if (format == PictureFormat::png) {
    // libpng prints warnings about faulty colour profiles, and OpenCV turns gray with alpha into
    // colour.
    filtered = png_without_remarks(bytes);
    bytes = filtered;
    flags = cv::IMREAD_ANYDEPTH | (png_is_gray(bytes) ? cv::IMREAD_GRAYSCALE : cv::IMREAD_COLOR);
  }
  const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8UC1,
                        const_cast<char*>(bytes.data()));  // a cv::Mat cannot be of const data
  cv::Mat picture = cv::imdecode(encoded, flags);
  if (picture.empty()) throw Error("the file is damaged: it cannot be decoded");
  return picture;
}

std::string lower_case_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::vector<std::uint8_t> encode(const CameraImage& picture, const std::string& ending,
                                 const std::vector<int>& parameters) {
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(ending, opencv_picture(picture), bytes, parameters)) {
    throw Error("the picture cannot be encoded as ", ending);
  }
  return bytes;
}

PixelLabel nearest_label(double value) {
  if (value < 64.0) return PixelLabel::background;
  return value < 191.5 ? PixelLabel::unknown : PixelLabel::hand;
}

}  // namespace

CameraImage read_picture(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  try {
    return picture_from_opencv(decode(bytes));
  } catch (const std::exception& error) {
    // Decoders throw exceptions of several kinds, some with line breaks in their text.
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw Error(file.string(), ": ", reason);
  }
}

void write_picture(const CameraImage& picture, const std::filesystem::path& file) {
  const std::string ending = lower_case_ending(file);
  const bool jpeg = ending == ".jpg" || ending == ".jpeg";
  if (!jpeg && ending != ".png" && ending != ".tif" && ending != ".tiff") {
    throw Error(file.string(), ": got the ending '", ending, "', expected .png, .jpg or .tif");
  }
  if (jpeg && picture.bits != 8) {
    throw Error(file.string(), ": got a picture of ", picture.bits,
                " bits, expected 8 for JPEG; PNG and TIFF take 16");
  }
  if (picture.values.empty()) throw Error(file.string(), ": got a picture without pixels");
  const std::vector<std::uint8_t> bytes = encode(picture, ending, {});
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::vector<std::uint8_t> encode_jpeg(const CameraImage& picture, int quality) {
  if (picture.bits != 8 || picture.values.empty()) {
    throw Error("JPEG: got a picture of ", picture.values.width(), " x ", picture.values.height(),
                " pixels and ", picture.bits, " bits, expected one of 8 bits");
  }
  return encode(picture, ".jpg", {cv::IMWRITE_JPEG_QUALITY, std::clamp(quality, 0, 100)});
}

Silhouette silhouette_from_mask(const CameraImage& mask) {
  const Image<std::uint16_t>& values = mask.values;
  const double scale = mask.bits == 16 ? 255.0 / 65535.0 : 1.0;
  constexpr double kMostColour = 64.0;  // JPEG makes some
  double brightest = 0.0;
  Silhouette silhouette(values.width(), values.height(), PixelLabel::background);
  for (int y = 0; y < values.height(); ++y) {
    for (int x = 0; x < values.width(); ++x) {
      double lowest = scale * values(x, y), highest = lowest;
      for (int channel = 1; channel < values.channels(); ++channel) {
        lowest = std::min(lowest, scale * values(x, y, channel));
        highest = std::max(highest, scale * values(x, y, channel));
      }
      if (highest - lowest > kMostColour) {
        throw Error("got a mask in colour (pixel ", x, ", ", y,
                    "), expected gray values of 0 (background), 128 (unknown) and 255 (hand)");
      }
      brightest = std::max(brightest, highest);
      silhouette(x, y) = nearest_label(0.5 * (lowest + highest));
    }
  }
  if (brightest == 1.0) {
    throw Error("got a mask of 0 and 1, expected 0 (background), 128 (unknown) and 255 (hand)");
  }
  return silhouette;
}

Silhouette silhouette_from_labels(const CameraImage& labels, int hand) {
  const Image<std::uint16_t>& values = labels.values;
  Silhouette silhouette(values.width(), values.height(), PixelLabel::unknown);
  for (int y = 0; y < values.height(); ++y) {
    for (int x = 0; x < values.width(); ++x) {
      for (int channel = 1; channel < values.channels(); ++channel) {
        if (values(x, y, channel) == values(x, y)) continue;
        throw Error("got a label image in colour (pixel ", x, ", ", y,
                    "), expected one channel with a number for each object");
      }
      if (values(x, y) == hand) {
        silhouette(x, y) = PixelLabel::hand;
      } else if (values(x, y) == 0) {
        silhouette(x, y) = PixelLabel::background;
      }
    }
  }
  return silhouette;
}

CameraImage mask_from_silhouette(const Silhouette& silhouette) {
  CameraImage mask{Image<std::uint16_t>(silhouette.width(), silhouette.height()), 8};
  std::transform(silhouette.values().begin(), silhouette.values().end(),
                 mask.values.values().begin(),
                 [](PixelLabel label) { return static_cast<std::uint16_t>(label); });
  return mask;
}

}  // namespace tegata

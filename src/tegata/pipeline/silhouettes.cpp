// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/silhouettes.h"

#include "tegata/base/error.h"
#include "tegata/segment/segmentation.h"
#include "tegata/take/picture_file.h"

namespace tegata {
namespace {

// A picture is grey where no channel departs from the first by more than a compressor would.
bool is_colour(const CameraImage& picture) {
  if (picture.values.channels() < 3) return false;
  const int tolerance = 1 << (picture.bits - 4);
  for (int y = 0; y < picture.values.height(); ++y) {
    for (int x = 0; x < picture.values.width(); ++x) {
      const int red = picture.values(x, y, 0);
      if (std::abs(red - picture.values(x, y, 1)) > tolerance ||
          std::abs(red - picture.values(x, y, 2)) > tolerance) {
        return true;
      }
    }
  }
  return false;
}

Silhouette segment_picture(const Take& take, std::size_t camera, const CameraImage& picture,
                           SegmentationMethod method) {
  switch (method) {
    case SegmentationMethod::infrared:
      return segment_infrared(picture);
    case SegmentationMethod::skin:
      return segment_skin(picture);
    case SegmentationMethod::mask:
      return silhouette_from_mask(picture);
    case SegmentationMethod::background:
      break;
  }
  const std::optional<CameraImage> background = take.background(camera);
  if (!background) {
    throw Error("camera '", take.rig()[camera].name,
                "': got no picture of the empty scene, expected ",
                (take.folder() / "background" / take.rig()[camera].name).string(),
                ".png for the segmentation method 'background'");
  }
  return segment_background(picture, *background);
}

}  // namespace

SegmentationMethod choose_segmentation(Take& take, const Observer& observer) {
  if (take.source() == PictureSource::masks) return SegmentationMethod::mask;
  if (take.info().segmentation) return *take.info().segmentation;
  bool has_background = true;
  for (std::size_t c = 0; c < take.rig().size(); ++c) {
    has_background = has_background && take.background(c).has_value();
  }
  if (has_background) return SegmentationMethod::background;
  const TakeFrame frame = take.read_frame(0, observer);
  for (const std::optional<CameraImage>& picture : frame.pictures) {
    if (picture && is_colour(*picture)) return SegmentationMethod::skin;
  }
  return SegmentationMethod::infrared;
}

std::vector<std::optional<Silhouette>> segment_frame(const Take& take, const TakeFrame& frame,
                                                     SegmentationMethod method) {
  std::vector<std::optional<Silhouette>> silhouettes(frame.pictures.size());
  for (std::size_t c = 0; c < frame.pictures.size(); ++c) {
    if (frame.pictures[c]) silhouettes[c] = segment_picture(take, c, *frame.pictures[c], method);
  }
  return silhouettes;
}

}  // namespace tegata

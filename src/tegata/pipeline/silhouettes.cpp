// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/silhouettes.h"

#include <utility>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"
#include "tegata/pipeline/agreeing_pieces.h"
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

CameraImage background_of(const Take& take, std::size_t camera) {
  std::optional<CameraImage> background = take.background(camera);
  if (background) return std::move(*background);
  throw Error("camera '", take.rig()[camera].name,
              "': got no picture of the empty scene, expected ",
              (take.folder() / "background" / take.rig()[camera].name).string(),
              ".png for the segmentation method 'background'");
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

Segmenter::Segmenter(Take& take, std::optional<SegmentationMethod> method, const Observer& observer,
                     const std::optional<SceneFrame>& scene)
    : method_(method ? *method : choose_segmentation(take, observer)), rig_(take.rig()) {
  if (scene) {
    for (Camera& camera : rig_) camera = scene->in_scene(camera);
  }
  for (std::size_t c = 0; c < rig_.size(); ++c) {
    undistortions_.emplace_back(rig_[c]);
    if (method_ == SegmentationMethod::background) backgrounds_.push_back(background_of(take, c));
  }
}

std::vector<std::optional<Silhouette>> Segmenter::segment(
    const TakeFrame& frame, std::vector<SegmentationReport>* reports) const {
  std::vector<std::optional<Silhouette>> silhouettes(frame.pictures.size());
  std::vector<SegmentationReport> found(frame.pictures.size());
  for (std::size_t c = 0; c < frame.pictures.size(); ++c) {
    if (frame.pictures[c]) silhouettes[c] = segment_picture(*frame.pictures[c], c, found[c]);
  }
  constexpr double kContradiction = 3.0 * kDegree;  // a real hand's stay well below
  if (method_ != SegmentationMethod::mask && disagreement(rig_, silhouettes) > kContradiction) {
    choose_agreeing(frame, silhouettes, found);
  }
  if (reports != nullptr) *reports = std::move(found);
  return silhouettes;
}

void Segmenter::choose_agreeing(const TakeFrame& frame,
                                std::vector<std::optional<Silhouette>>& silhouettes,
                                std::vector<SegmentationReport>& reports) const {
  constexpr int kRounds = 2;  // of looking at what is left of a picture
  HandCandidates candidates(silhouettes.size());
  std::vector<std::vector<SegmentationReport>> of_candidates(silhouettes.size());
  for (std::size_t c = 0; c < silhouettes.size(); ++c) {
    if (!silhouettes[c]) continue;
    const auto add = [&](const Silhouette& silhouette, const SegmentationReport& report) {
      std::vector<Silhouette> pieces = pieces_alone(silhouette);
      pieces.insert(pieces.begin(), silhouette);
      for (Silhouette& piece : pieces) candidates[c].push_back(std::move(piece));
      of_candidates[c].insert(of_candidates[c].end(), pieces.size(), report);
    };
    add(*silhouettes[c], reports[c]);
    CameraImage left = *frame.pictures[c];
    Silhouette taken = *silhouettes[c];
    for (int round = 0; round < kRounds && count_pixels(taken, PixelLabel::hand) > 0; ++round) {
      left = without_hand(left, taken);
      SegmentationReport report;
      taken = segment_picture(left, c, report);
      if (report.hand_pixels > 0) add(taken, report);
    }
  }
  const std::vector<std::size_t> choice = agreeing_candidates(rig_, candidates);
  for (std::size_t c = 0; c < silhouettes.size(); ++c) {
    if (choice[c] == 0) continue;
    silhouettes[c] = std::move(candidates[c][choice[c]]);
    reports[c] = of_candidates[c][choice[c]];
    reports[c].hand_pixels = count_pixels(*silhouettes[c], PixelLabel::hand);
  }
}

Silhouette Segmenter::segment_picture(const CameraImage& picture, std::size_t camera,
                                      SegmentationReport& report) const {
  switch (method_) {
    case SegmentationMethod::infrared:
      return segment_infrared(picture, {}, &report);
    case SegmentationMethod::skin:
      return segment_skin(picture, {}, &report);
    case SegmentationMethod::background:
      return segment_background(picture, backgrounds_[camera], {}, &report);
    case SegmentationMethod::mask:
      break;
  }
  Silhouette mask = silhouette_from_mask(picture);
  report.hand_pixels = count_pixels(mask, PixelLabel::hand);
  report.confidence = report.hand_pixels == 0 ? 0.0 : 1.0;
  return mask;
}

HullView Segmenter::undistorted(const Silhouette& silhouette, std::size_t camera) const {
  return {undistortions_[camera].camera(), undistortions_[camera].apply(silhouette)};
}

}  // namespace tegata

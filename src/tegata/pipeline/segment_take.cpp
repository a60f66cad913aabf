// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/segment_take.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include "tegata/base/text.h"
#include "tegata/image/overlay.h"
#include "tegata/pipeline/silhouettes.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/picture_file.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr Colour kPaper = {250, 250, 248};
constexpr Colour kOutline = {70, 200, 255};
constexpr int kDimming = 3;

// The picture with all that is not hand darkened, and the hand's outline.
CameraImage cut_out(const CameraImage& picture, const Silhouette& silhouette, int widest) {
  CameraImage shown = for_display(picture);
  for (int y = 0; y < silhouette.height(); ++y) {
    for (int x = 0; x < silhouette.width(); ++x) {
      if (silhouette(x, y) == PixelLabel::hand) continue;
      for (int c = 0; c < 3; ++c) {
        shown.values(x, y, c) = static_cast<std::uint16_t>(shown.values(x, y, c) / kDimming);
      }
    }
  }
  const int width = shown.values.width();
  draw_outline(shown, silhouette, kOutline, (width + widest - 1) / widest);
  return shrunk(shown, widest);
}

// Which of so many frames the sheet shows: at most `rows`, spread evenly.
std::map<std::size_t, std::size_t> sheet_rows(std::size_t frame_count, std::size_t rows) {
  std::map<std::size_t, std::size_t> row_of;
  const std::size_t count = std::min(frame_count, rows);
  for (std::size_t row = 0; row < count; ++row) row_of[row * frame_count / count] = row;
  return row_of;
}

TakeInfo info_of_masks(const Take& take, const SegmentTakeOptions& options) {
  TakeInfo info = take.info();
  info.segmentation = SegmentationMethod::mask;
  info.hand_label.reset();
  info.offsets.clear();
  info.metres_per_unit = 1.0;
  info.fps /= static_cast<double>(options.frames.step);
  if (options.frames.first != 0) info.initial_landmarks.reset();
  return info;
}

}  // namespace

SegmentedTake segment_take(Take& take, const fs::path& folder, const SegmentTakeOptions& options,
                           const Observer& observer) {
  const std::vector<std::size_t> indices = selected_frames(options.frames, take);
  const Segmenter segmenter(take, options.segmentation, observer);
  const CameraRig& rig = segmenter.rig();
  write_calibration(rig, folder / "calibration.toml");
  write_take_info(info_of_masks(take, options), folder / "take.toml");
  for (const Camera& camera : rig) fs::create_directories(folder / "masks" / camera.name);

  SegmentedTake segmented;
  segmented.method = segmenter.method();
  segmented.frames.resize(indices.size());
  const auto row_of = sheet_rows(indices.size(), options.sheet_rows);
  std::vector<CameraImage> cells(
      row_of.size() * rig.size(),
      CameraImage{Image<std::uint16_t>(1, 1, kPaper[0], 3), 8});  // where there is no picture
  const auto segment = [&](std::size_t i, const TakeFrame& pictures) {
    std::vector<SegmentationReport> reports;
    const auto silhouettes = segmenter.segment(pictures, &reports);
    segmented.frames[i].name = pictures.name;
    const auto row = row_of.find(i);
    for (std::size_t c = 0; c < rig.size(); ++c) {
      if (!silhouettes[c]) {
        segmented.frames[i].left_out[rig[c].name] = pictures.why_missing(rig[c].name);
        continue;
      }
      write_picture(mask_from_silhouette(*silhouettes[c]),
                    folder / "masks" / rig[c].name / (pictures.name + ".png"));
      segmented.frames[i].views.push_back(
          {rig[c].name, reports[c].hand_pixels, reports[c].confidence});
      if (row == row_of.end()) continue;
      cells[row->second * rig.size() + c] =
          cut_out(*pictures.pictures[c], *silhouettes[c], options.sheet_widest);
    }
  };
  const auto warn = [&](std::size_t i) {
    for (const SegmentedView& view : segmented.frames[i].views) {
      if (view.hand_pixels > 0) continue;
      observer.warn(text("frame ", segmented.frames[i].name, ", camera '", view.camera,
                         "': no hand was found in the picture"));
    }
  };
  for_each_frame(take, indices, options.threads,
                 {.work = segment, .finish = warn, .stage = "silhouettes"}, observer);
  segmented.contact_sheet = contact_sheet(cells, static_cast<int>(rig.size()), kPaper);
  return segmented;
}

}  // namespace tegata

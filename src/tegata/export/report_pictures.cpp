// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/export/frame_choice.h"
#include "tegata/export/frame_doubts.h"
#include "tegata/image/overlay.h"
#include "tegata/image/rasterizer.h"
#include "tegata/take/picture_file.h"

namespace tegata {
namespace {

constexpr int kWidest = 640;      // of a picture in the page [px]
constexpr double kMargin = 0.35;  // around the hand, of its size
// Below this overlap what matters may lie elsewhere in the picture.
constexpr double kLeastPictureOverlap = 0.5;
constexpr double kOutlineTolerance = 0.4;  // [px of the page's picture]
constexpr int kNarrowest = 160;  // of the widest picture; rather than smaller, they are fewer [px]
constexpr std::array<int, 2> kJpegQualities = {75, 60};
constexpr std::size_t kFramesAtOnce = 8, kSampledFrames = 4;

/// A frame of the result and where the take has it.
struct Shown {
  std::size_t in_result = 0, in_take = 0;
};

/// All frames of a result in its take. Throws Error where the take lacks one.
std::vector<Shown> frames_in_take(const Take& take, const Result& result) {
  std::map<std::string, std::size_t> index_of;
  for (std::size_t i = 0; i < take.frame_names().size(); ++i) index_of[take.frame_names()[i]] = i;
  std::vector<Shown> frames;
  for (std::size_t i = 0; i < result.frames.size(); ++i) {
    const auto found = index_of.find(result.frames[i].name);
    if (found == index_of.end()) {
      throw Error(take.folder().string(), ": got no frame '", result.frames[i].name,
                  "', expected the take that the result was made of");
    }
    frames.push_back({i, found->second});
  }
  return frames;
}

std::vector<double> severities_of(const Result& result) {
  std::vector<double> severities;
  for (const FrameDoubt& doubt : frame_doubts(result)) severities.push_back(doubt.severity);
  return severities;
}

/// What a picture takes of the page, where all of it is base64.
std::size_t page_bytes(const ReportPicture& picture) {
  std::size_t bytes = picture.jpeg.size();
  for (const auto* outlines : {&picture.hand, &picture.silhouette}) {
    for (const Outline& outline : *outlines) bytes += 2 + 4 * outline.size();
  }
  return 4 * bytes / 3;
}

PictureWindow whole(const Camera& camera) { return {0, 0, camera.width, camera.height}; }

PictureWindow window_around_hand(const Camera& camera, const Result& result,
                                 const HandModel& hand) {
  Eigen::AlignedBox2d box;
  for (const ResultFrame& frame : result.frames) {
    if (!frame.pose) continue;
    const auto overlap = frame.silhouette_iou.find(camera.name);
    if (overlap == frame.silhouette_iou.end() || overlap->second < kLeastPictureOverlap) {
      return whole(camera);
    }
    const PosedHand posed(hand, *frame.pose);
    for (const Eigen::Vector3d& vertex : posed.vertices()) {
      if (const auto pixel = project(camera, vertex)) box.extend(*pixel);
    }
  }
  if (box.isEmpty()) return whole(camera);
  const double margin = kMargin * box.sizes().maxCoeff();
  const auto within = [margin](double low, double high, int size) {
    const int first = static_cast<int>(std::clamp(std::floor(low - margin), 0.0, size - 1.0));
    const int last = static_cast<int>(std::clamp(std::ceil(high + margin), 0.0, size - 1.0));
    return std::pair(first, last - first + 1);
  };
  const auto [left, width] = within(box.min().x(), box.max().x(), camera.width);
  const auto [top, height] = within(box.min().y(), box.max().y(), camera.height);
  return {left, top, width, height};
}

CameraImage cut(const CameraImage& picture, const PictureWindow& window) {
  const int channels = picture.values.channels();
  CameraImage part{Image<std::uint16_t>(window.width, window.height, 0, channels), picture.bits};
  for (int y = 0; y < window.height; ++y) {
    for (int x = 0; x < window.width; ++x) {
      for (int c = 0; c < channels; ++c) {
        part.values(x, y, c) = picture.values(window.left + x, window.top + y, c);
      }
    }
  }
  return part;
}

/// The window without the last few rows and columns, so that whole blocks of pixels are left.
PictureWindow trimmed(PictureWindow window, int reduction) {
  window.width = std::max(1, window.width - window.width % reduction);
  window.height = std::max(1, window.height - window.height % reduction);
  return window;
}

/// How pictures are made small.
struct Size {
  int reduction = 1, quality = kJpegQualities[0];
};

std::vector<std::uint8_t> page_jpeg(const CameraImage& picture, const PictureWindow& window,
                                    const Size& size) {
  const int widest = std::max(1, window.width / size.reduction);
  return encode_jpeg(shrunk(cut(for_display(picture), window), widest), size.quality);
}

class PictureMaker {
 public:
  PictureMaker(Take& take, const Result& result, const HandModel& hand,
               const ReportPictureOptions& options, const Observer& observer)
      : take_(take), result_(result), hand_(hand), options_(options), observer_(observer) {}

  ReportPictures make(const SegmentFrame& segment) {
    const std::vector<Shown> all = frames_in_take(take_, result_);
    const std::vector<double> severities = severities_of(result_);
    for (const Camera& camera : take_.rig()) {
      made_.windows.push_back(window_around_hand(camera, result_, hand_));
    }
    std::vector<Shown> frames;
    for (const std::size_t i : choose_frames(severities, choose_size(all))) {
      frames.push_back(all[i]);
    }
    for (PictureWindow& window : made_.windows) window = trimmed(window, size_.reduction);
    for (std::size_t begin = 0; begin < frames.size(); begin += kFramesAtOnce) {
      const std::size_t count = std::min(kFramesAtOnce, frames.size() - begin);
      make_some({&frames[begin], count}, segment);
      observer_.progress("report", begin + count, frames.size());
    }
    say_limits(keep_what_fits(frames, severities));
    return std::move(made_);
  }

 private:
  /// The largest pictures that keep within the bytes, judged by a few frames; and of how many
  /// frames.
  std::size_t choose_size(const std::vector<Shown>& frames) {
    const std::size_t wanted = std::min(options_.most_frames, frames.size());
    std::vector<TakeFrame> samples;
    const std::size_t step = std::max<std::size_t>(1, frames.size() / kSampledFrames);
    for (std::size_t i = 0; i < frames.size(); i += step) {
      samples.push_back(take_.read_display_frame(frames[i].in_take, Observer{}));
    }
    int widest = 1;
    for (const PictureWindow& window : made_.windows) widest = std::max(widest, window.width);
    const int least = (widest + kWidest - 1) / kWidest;
    const int most = std::max(least, widest / kNarrowest);
    double bytes = 0.0;
    for (size_.reduction = least; size_.reduction <= most; ++size_.reduction) {
      for (const int quality : kJpegQualities) {
        size_.quality = quality;
        bytes = bytes_a_picture(samples);
        if (bytes * pictures_of_frames(wanted) <= room() &&
            bytes <= static_cast<double>(options_.usual_bytes)) {
          return wanted;
        }
      }
    }
    size_.reduction = most;
    const double fitting = room() / (bytes * pictures_of_frames(1));
    return std::min(wanted, static_cast<std::size_t>(std::max(1.0, fitting)));
  }

  double pictures_of_frames(std::size_t count) const {
    return static_cast<double>(count * take_.rig().size());
  }

  /// For all JPEGs, before they are base64; the outlines need some as well.
  double room() const { return 0.8 * 0.75 * static_cast<double>(options_.most_bytes); }

  double bytes_a_picture(const std::vector<TakeFrame>& samples) const {
    double bytes = 0.0, count = 0.0;
    for (const TakeFrame& sample : samples) {
      for (std::size_t c = 0; c < take_.rig().size(); ++c) {
        if (!sample.pictures[c]) continue;
        const PictureWindow window = trimmed(made_.windows[c], size_.reduction);
        bytes += static_cast<double>(page_jpeg(*sample.pictures[c], window, size_).size());
        count += 1.0;
      }
    }
    return bytes / std::max(1.0, count);
  }

  void make_some(std::span<const Shown> frames, const SegmentFrame& segment) {
    std::vector<TakeFrame> pictures, shown;
    for (const Shown& frame : frames) {
      pictures.push_back(take_.read_frame(frame.in_take, Observer{}));
      // Only masks may have other pictures for people.
      if (take_.source() == PictureSource::masks) {
        shown.push_back(take_.read_display_frame(frame.in_take, Observer{}));
      }
    }
    std::vector<std::vector<ReportPicture>> made(frames.size());
    parallel_for(frames.size(), options_.threads, [&](std::size_t i) {
      made[i] = pictures_of(frames[i].in_result, shown.empty() ? pictures[i] : shown[i],
                            segment(pictures[i]));
    });
    for (std::vector<ReportPicture>& some : made) {
      for (ReportPicture& picture : some) made_.pictures.push_back(std::move(picture));
    }
  }

  /// Leaves frames out where the few that the size was judged by were smaller than most. Returns
  /// how many frames are left.
  std::size_t keep_what_fits(const std::vector<Shown>& frames,
                             const std::vector<double>& severities) {
    std::map<std::size_t, std::size_t> bytes_of;  // by the frame's position in the result
    for (const Shown& frame : frames) bytes_of[frame.in_result] = 0;
    for (const ReportPicture& picture : made_.pictures) {
      bytes_of[picture.frame] += page_bytes(picture);
    }
    std::vector<double> their_severities;
    std::vector<std::size_t> positions, bytes;
    for (const auto& [frame, size] : bytes_of) {
      positions.push_back(frame);
      their_severities.push_back(severities[frame]);
      bytes.push_back(size);
    }
    std::set<std::size_t> kept;
    for (const std::size_t i :
         choose_frames_by_size(their_severities, bytes, options_.most_bytes)) {
      kept.insert(positions[i]);
    }
    std::erase_if(made_.pictures,
                  [&](const ReportPicture& picture) { return !kept.contains(picture.frame); });
    return kept.size();
  }

  std::vector<ReportPicture> pictures_of(
      std::size_t index, const TakeFrame& shown,
      const std::vector<std::optional<Silhouette>>& silhouettes) const {
    const ResultFrame& frame = result_.frames[index];
    TriangleMesh surface;
    if (frame.pose) surface = PosedHand(hand_, *frame.pose).surface();
    const double tolerance = kOutlineTolerance * size_.reduction;
    std::vector<ReportPicture> pictures;
    for (std::size_t c = 0; c < take_.rig().size(); ++c) {
      if (!shown.pictures[c]) continue;
      ReportPicture picture{
          index, c, page_jpeg(*shown.pictures[c], made_.windows[c], size_), {}, {}};
      if (silhouettes[c]) picture.silhouette = trace_outlines(*silhouettes[c], tolerance);
      if (frame.pose) {
        picture.hand = trace_outlines(render_silhouette(surface, take_.rig()[c]), tolerance);
      }
      pictures.push_back(std::move(picture));
    }
    return pictures;
  }

  void say_limits(std::size_t frame_count) {
    if (frame_count < result_.frames.size()) {
      made_.limits.push_back(fmt::format("Pictures of {} of {} frames are in this page.",
                                         frame_count, result_.frames.size()));
    }
    if (size_.reduction > 1) {
      made_.limits.push_back(fmt::format(
          "Pictures are reduced {} to 1, so that the page stays small.", size_.reduction));
    }
  }

  Take& take_;
  const Result& result_;
  const HandModel& hand_;
  const ReportPictureOptions& options_;
  const Observer& observer_;
  ReportPictures made_;
  Size size_;
};

}  // namespace

ReportPictures make_report_pictures(Take& take, const Result& result, const HandModel& hand,
                                    const SegmentFrame& segment,
                                    const ReportPictureOptions& options, const Observer& observer) {
  return PictureMaker(take, result, hand, options, observer).make(segment);
}

}  // namespace tegata

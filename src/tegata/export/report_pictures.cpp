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
constexpr int kMostReduction = 16;
constexpr std::array<int, 2> kJpegQualities = {75, 60};
constexpr std::size_t kFramesAtOnce = 8, kSampledFrames = 4;

/// A frame of the result and where the take has it.
struct Shown {
  std::size_t in_result = 0, in_take = 0;
};

std::vector<Shown> shown_frames(const Take& take, const Result& result, std::size_t most) {
  std::map<std::string, std::size_t> index_of;
  for (std::size_t i = 0; i < take.frame_names().size(); ++i) index_of[take.frame_names()[i]] = i;
  std::set<std::size_t> chosen;
  const std::size_t count = result.frames.size();
  if (count <= most) {
    for (std::size_t i = 0; i < count; ++i) chosen.insert(i);
  } else {
    std::vector<FrameDoubt> doubts = frame_doubts(result);
    std::stable_sort(doubts.begin(), doubts.end(), [](const FrameDoubt& a, const FrameDoubt& b) {
      return a.severity > b.severity;
    });
    for (std::size_t i = 0; i < most / 4; ++i) chosen.insert(doubts[i].frame);
    const std::size_t spread = most - chosen.size();
    for (std::size_t i = 0; i < spread; ++i) chosen.insert(i * count / spread);
  }
  std::vector<Shown> frames;
  for (const std::size_t i : chosen) {
    const auto found = index_of.find(result.frames[i].name);
    if (found == index_of.end()) {
      throw Error(take.folder().string(), ": got no frame '", result.frames[i].name,
                  "', expected the take that the result was made of");
    }
    frames.push_back({i, found->second});
  }
  return frames;
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
    const std::vector<Shown> frames = shown_frames(take_, result_, options_.most_frames);
    for (const Camera& camera : take_.rig()) {
      made_.windows.push_back(window_around_hand(camera, result_, hand_));
    }
    choose_size(frames);
    for (PictureWindow& window : made_.windows) window = trimmed(window, size_.reduction);
    for (std::size_t begin = 0; begin < frames.size(); begin += kFramesAtOnce) {
      const std::size_t count = std::min(kFramesAtOnce, frames.size() - begin);
      make_some({&frames[begin], count}, segment);
      observer_.progress("report", begin + count, frames.size());
    }
    say_limits(frames.size());
    return std::move(made_);
  }

 private:
  /// The largest pictures that keep within the bytes, judged by a few frames.
  void choose_size(const std::vector<Shown>& frames) {
    std::vector<TakeFrame> samples;
    const std::size_t step = std::max<std::size_t>(1, frames.size() / kSampledFrames);
    for (std::size_t i = 0; i < frames.size(); i += step) {
      samples.push_back(take_.read_display_frame(frames[i].in_take, Observer{}));
    }
    int least = 1;
    for (const PictureWindow& window : made_.windows) {
      least = std::max(least, (window.width + kWidest - 1) / kWidest);
    }
    for (size_.reduction = least; size_.reduction < kMostReduction; ++size_.reduction) {
      for (const int quality : kJpegQualities) {
        size_.quality = quality;
        if (fits(samples, frames.size())) return;
      }
    }
  }

  bool fits(const std::vector<TakeFrame>& samples, std::size_t frame_count) const {
    constexpr double kReserve = 0.9;
    double bytes = 0.0, count = 0.0;
    for (const TakeFrame& sample : samples) {
      for (std::size_t c = 0; c < take_.rig().size(); ++c) {
        if (!sample.pictures[c]) continue;
        const PictureWindow window = trimmed(made_.windows[c], size_.reduction);
        bytes += static_cast<double>(page_jpeg(*sample.pictures[c], window, size_).size());
        count += 1.0;
      }
    }
    const double expected = static_cast<double>(frame_count * take_.rig().size());
    const double most = kReserve * static_cast<double>(options_.most_bytes) / expected;
    return bytes <= count * std::min(most, static_cast<double>(options_.usual_bytes));
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
      for (ReportPicture& picture : some) {
        if (byte_count_ + picture.jpeg.size() > options_.most_bytes) {
          ++left_out_;
          continue;
        }
        byte_count_ += picture.jpeg.size();
        made_.pictures.push_back(std::move(picture));
      }
    }
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
    if (left_out_ > 0) {
      made_.limits.push_back(fmt::format("{} pictures did not fit into the page.", left_out_));
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
  std::size_t byte_count_ = 0, left_out_ = 0;
};

}  // namespace

ReportPictures make_report_pictures(Take& take, const Result& result, const HandModel& hand,
                                    const SegmentFrame& segment,
                                    const ReportPictureOptions& options, const Observer& observer) {
  return PictureMaker(take, result, hand, options, observer).make(segment);
}

}  // namespace tegata

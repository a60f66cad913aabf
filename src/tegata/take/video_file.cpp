// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/video_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <opencv2/videoio.hpp>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/take/avi_index.h"
#include "tegata/take/opencv_picture.h"
#include "tegata/take/silent_opencv.h"

namespace tegata {
namespace {

// Eight bytes at a position, or nothing past the end.
std::optional<std::array<unsigned char, 8>> eight_bytes(std::ifstream& stream,
                                                        std::uint64_t position) {
  std::array<char, 8> bytes = {};
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(position));
  if (!stream.read(bytes.data(), bytes.size())) return std::nullopt;
  std::array<unsigned char, 8> result = {};
  for (std::size_t i = 0; i < bytes.size(); ++i) result[i] = static_cast<unsigned char>(bytes[i]);
  return result;
}

std::uint64_t big_endian(const unsigned char* bytes, int count) {
  std::uint64_t number = 0;
  for (int i = 0; i < count; ++i) number = number << 8 | bytes[i];
  return number;
}

// An MP4 that a camera did not finish has no index ("moov" box); FFmpeg would say so on the
// terminal. Boxes as in ISO/IEC 14496-12, 4.2.
void check_mp4(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  for (std::uint64_t position = 0;;) {
    const auto header = eight_bytes(stream, position);
    if (!header) break;
    const std::string_view type(reinterpret_cast<const char*>(header->data()) + 4, 4);
    if (position == 0 && type != "ftyp") return;  // no MP4
    if (type == "moov") return;
    std::uint64_t size = big_endian(header->data(), 4);
    if (size == 1) {
      const auto large = eight_bytes(stream, position + 8);
      if (!large) break;
      size = big_endian(large->data(), 8);
    }
    // 0 stands for "to the end of the file".
    if (size < 8 || size > std::numeric_limits<std::uint32_t>::max() * std::uint64_t{65536}) break;
    position += size;
  }
  throw Error(file.string(), ": the video is cut short: it has no index, expected a whole MP4");
}

void open_capture(cv::VideoCapture& capture, const std::filesystem::path& file) {
  const SilentOpenCv silent;
  if (!capture.open(file.string(), cv::CAP_FFMPEG)) {
    throw Error(file.string(), ": cannot be decoded, expected a video that FFmpeg reads");
  }
}

std::size_t counted_frames(cv::VideoCapture& capture) {
  std::size_t count = 0;
  while (capture.grab()) ++count;
  return count;
}

}  // namespace

struct VideoFile::State {
  std::filesystem::path file;
  cv::VideoCapture capture;
  /// Of an AVI that has lost pictures without a trace in what FFmpeg gives: those that are left.
  /// All that follows but `numbered` counts these alone.
  std::optional<AviIndex> left;
  std::size_t frame_count = 0;
  std::size_t next = 0;             // the first picture that was not grabbed yet
  double time_ms = 0.0;             // of picture next - 1
  std::set<std::size_t> broken;     // that cannot be decoded although later ones can
  std::optional<std::size_t> end;   // where decoding ended
  std::optional<CameraImage> last;  // picture next - 1, once it was asked for

  bool grab(std::size_t wanted);
  void find_left();
  // Where FFmpeg has a picture; nothing for one of which nothing is left.
  std::optional<std::size_t> numbered(std::size_t index) const;
};

void VideoFile::State::find_left() {
  AviIndex avi = read_avi_index(file);
  if (avi.found.empty() || avi.found.size() == avi.count) return;
  // A file beyond 1 GB has several parts, and this index is of the first one alone.
  if (avi.count < frame_count) return;
  frame_count = avi.found.size();
  left = std::move(avi);
}

std::optional<std::size_t> VideoFile::State::numbered(std::size_t index) const {
  if (!left || index >= left->count) return index;
  const auto at = std::lower_bound(left->found.begin(), left->found.end(), index);
  if (at == left->found.end() || *at != index) return std::nullopt;
  return static_cast<std::size_t>(at - left->found.begin());
}

// Grabs the next picture that can be decoded; false where none comes up to `wanted` or to the end
// of the video. A picture that cannot be decoded fails to be grabbed once, and those after it come
// as ever; their times say how many were passed over.
bool VideoFile::State::grab(std::size_t wanted) {
  const std::size_t first = next;
  last.reset();
  for (std::size_t at = first; at < std::max(frame_count, wanted + 1); ++at) {
    if (!capture.grab()) continue;
    const double before = std::exchange(time_ms, capture.get(cv::CAP_PROP_POS_MSEC));
    next = at + 1;
    if (at > first) {
      const double passed = (time_ms - before) * 1e-3 * capture.get(cv::CAP_PROP_FPS);
      if (first > 0 && std::isfinite(passed) && passed >= 2.0 && passed < 1e9) {
        next = first + static_cast<std::size_t>(std::llround(passed));
      }
      for (std::size_t lost = first; lost + 1 < next; ++lost) broken.insert(lost);
    }
    return true;
  }
  end = first;
  next = std::numeric_limits<std::size_t>::max();  // nothing is held: any other starts anew
  return false;
}

VideoFile::VideoFile(std::filesystem::path file) : state_(std::make_unique<State>()) {
  state_->file = std::move(file);
  if (!std::filesystem::is_regular_file(state_->file)) {
    throw Error(state_->file.string(), ": there is no such file, expected a video");
  }
  check_mp4(state_->file);
  open_capture(state_->capture, state_->file);
  const double count = state_->capture.get(cv::CAP_PROP_FRAME_COUNT);
  // Streams without an index give a negative number, damaged headers any. A picture's entry in an
  // index alone takes more than four bytes.
  const double most = static_cast<double>(std::filesystem::file_size(state_->file)) / 4.0;
  if (count >= 1.0 && count <= most) {
    state_->frame_count = static_cast<std::size_t>(std::llround(count));
  } else {
    state_->frame_count = counted_frames(state_->capture);
    open_capture(state_->capture, state_->file);
  }
  state_->find_left();
}

VideoFile::~VideoFile() = default;
VideoFile::VideoFile(VideoFile&&) noexcept = default;
VideoFile& VideoFile::operator=(VideoFile&&) noexcept = default;

const std::filesystem::path& VideoFile::file() const { return state_->file; }
std::size_t VideoFile::frame_count() const {
  return state_->left ? state_->left->count : state_->frame_count;
}

const CameraImage& VideoFile::read(std::size_t number) {
  State& state = *state_;
  const std::optional<std::size_t> found = state.numbered(number);
  if (!found) throw Error(state.file.string(), ": picture ", number, " cannot be decoded");
  const std::size_t index = *found;
  if (state.last && index + 1 == state.next) return *state.last;
  if (!state.broken.contains(index) && (!state.end || index < *state.end)) {
    if (index + 1 < state.next) {
      open_capture(state.capture, state.file);
      state.next = 0;
    }
    cv::Mat picture;
    const SilentOpenCv silent;
    while (state.next <= index && state.grab(index)) {
    }
    if (index + 1 == state.next && state.capture.retrieve(picture) && !picture.empty()) {
      state.last = picture_from_opencv(picture);
      return *state.last;
    }
  }
  const bool past_end = !state.left && state.end && index >= *state.end;
  throw Error(state.file.string(), ": picture ", number, " cannot be decoded",
              past_end ? text(": the video ends after ", *state.end) : "");
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/video_file.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "tegata/base/error.h"
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
  std::size_t frame_count = 0;
  std::size_t next = 0;             // what the decoder gives next
  std::optional<std::size_t> end;   // where decoding ended
  std::optional<CameraImage> last;  // picture next - 1
};

VideoFile::VideoFile(std::filesystem::path file) : state_(std::make_unique<State>()) {
  state_->file = std::move(file);
  if (!std::filesystem::is_regular_file(state_->file)) {
    throw Error(state_->file.string(), ": there is no such file, expected a video");
  }
  check_mp4(state_->file);
  open_capture(state_->capture, state_->file);
  const double count = state_->capture.get(cv::CAP_PROP_FRAME_COUNT);
  // Streams without an index give a negative number.
  if (count >= 1.0 && count < 1e9) {
    state_->frame_count = static_cast<std::size_t>(std::llround(count));
  } else {
    state_->frame_count = counted_frames(state_->capture);
    open_capture(state_->capture, state_->file);
  }
}

VideoFile::~VideoFile() = default;
VideoFile::VideoFile(VideoFile&&) noexcept = default;
VideoFile& VideoFile::operator=(VideoFile&&) noexcept = default;

const std::filesystem::path& VideoFile::file() const { return state_->file; }
std::size_t VideoFile::frame_count() const { return state_->frame_count; }

const CameraImage& VideoFile::read(std::size_t index) {
  State& state = *state_;
  if (state.last && index + 1 == state.next) return *state.last;
  if (!state.end || index < *state.end) {
    if (index < state.next) {
      open_capture(state.capture, state.file);
      state.next = 0;
    }
    state.last.reset();
    cv::Mat picture;
    const SilentOpenCv silent;
    while (state.next <= index && state.capture.grab()) ++state.next;
    if (state.next > index && state.capture.retrieve(picture) && !picture.empty()) {
      state.last = picture_from_opencv(picture);
      return *state.last;
    }
    if (state.next <= index) state.end = state.next;
  }
  throw Error(state.file.string(), ": picture ", index, " cannot be decoded",
              state.end ? text(": the video ends after ", *state.end) : "");
}

}  // namespace tegata

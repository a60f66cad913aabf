// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/base/scratch_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "tegata/base/error.h"

namespace tegata {
namespace {

std::string system_reason() { return std::generic_category().message(errno); }

}  // namespace

ScratchFile::ScratchFile(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::string name = (folder_ / ".scratch-XXXXXX").string();
  file_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) {
    throw Error(folder_.string(), ": a temporary file cannot be made in it: ", system_reason());
  }
  ::unlink(name.c_str());
}

ScratchFile::~ScratchFile() {
  if (file_ >= 0) ::close(file_);
}

ScratchFile::ScratchFile(ScratchFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      file_(std::exchange(other.file_, -1)),
      size_(std::exchange(other.size_, 0)) {}

ScratchFile& ScratchFile::operator=(ScratchFile&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(file_, other.file_);
  std::swap(size_, other.size_);
  return *this;
}

ScratchFile::Place ScratchFile::append(std::span<const std::byte> bytes) {
  const Place place = {size_, bytes.size()};
  while (!bytes.empty()) {
    const ::ssize_t count =
        ::pwrite(file_, bytes.data(), bytes.size(), static_cast<::off_t>(size_));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      throw Error(folder_.string(),
                  ": a temporary file in it cannot be written whole: ", system_reason());
    }
    size_ += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return place;
}

std::vector<std::byte> ScratchFile::read(const Place& place) const {
  std::vector<std::byte> bytes(place.size);
  for (std::size_t done = 0; done < bytes.size();) {
    const ::ssize_t count = ::pread(file_, bytes.data() + done, bytes.size() - done,
                                    static_cast<::off_t>(place.offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      throw Error(folder_.string(), ": a temporary file in it cannot be read: ",
                  count == 0 ? "it ends too early" : system_reason());
    }
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

}  // namespace tegata

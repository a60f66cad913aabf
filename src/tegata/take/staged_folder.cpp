// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/staged_folder.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "tegata/base/error.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

std::string system_reason(int error_number) {
  return std::generic_category().message(error_number);
}

// The name is taken by no other process and by no other folder of this one.
fs::path hidden_sibling(const fs::path& target, std::string_view kind) {
  static std::atomic<unsigned> counter = 0;
  return target.parent_path() / text(".", target.filename().string(), ".", kind, "-", ::getpid(),
                                     "-", counter.fetch_add(1));
}

void rename_or_throw(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    throw Error(to.string(), ": cannot be put in its place (renamed from ", from.string(),
                "): ", error.message());
  }
}

void check_replaceable(const fs::path& target, bool replace, std::string_view marker) {
  if (!replace) {
    throw Error(target.string(), ": exists already; use --force to replace it, or another name");
  }
  if (!fs::is_directory(target)) {
    throw Error(target.string(), ": is a file, expected a folder to replace or a new name");
  }
  if (!marker.empty() && !fs::is_empty(target) && !fs::exists(target / marker)) {
    throw Error(target.string(), ": holds no ", marker,
                ", so it is nothing that may be replaced; use another name, or remove it first");
  }
}

}  // namespace

StagedFolder::StagedFolder(fs::path target, bool replace, std::string_view marker)
    : replace_(replace) {
  try {
    if (target.empty()) throw Error("got an empty name, expected that of a folder to write");
    target_ = fs::weakly_canonical(fs::absolute(target));
    if (!target_.has_filename()) target_ = target_.parent_path();
    if (fs::exists(target_)) check_replaceable(target_, replace, marker);
    fs::create_directories(target_.parent_path());
    staging_ = hidden_sibling(target_, "partial");
    // Left behind by a process of the same id that crashed.
    fs::remove_all(staging_);
    fs::create_directory(staging_);
  } catch (const fs::filesystem_error& error) {
    throw Error(target.string(), ": cannot be written: ", error.code().message());
  }
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(staging_, ignored);
}

void StagedFolder::commit() {
  std::error_code ignored;
  if (!fs::exists(target_, ignored)) {
    rename_or_throw(staging_, target_);
  } else if (!replace_) {
    throw Error(target_.string(), ": was made by somebody else meanwhile; use another name");
  } else {
    const fs::path old = hidden_sibling(target_, "replaced");
    rename_or_throw(target_, old);
    try {
      rename_or_throw(staging_, target_);
    } catch (const Error&) {
      fs::rename(old, target_, ignored);
      throw;
    }
    fs::remove_all(old, ignored);
  }
  committed_ = true;
}

void write_file(const fs::path& file, std::string_view content) {
  OpenFile stream(std::fopen(file.c_str(), "wb"));
  if (!stream) throw Error(file.string(), ": cannot be written: ", system_reason(errno));
  errno = 0;
  bool whole = std::fwrite(content.data(), 1, content.size(), stream.get()) == content.size();
  whole = whole && std::fflush(stream.get()) == 0;
  int reason = errno;
  // Some file systems say only on closing that nothing was stored.
  if (std::fclose(stream.release()) != 0 && whole) {
    whole = false;
    reason = errno;
  }
  if (whole) return;
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);
  throw Error(file.string(), ": cannot be written whole: ", system_reason(reason));
}

std::string read_file(const fs::path& file) {
  OpenFile stream(std::fopen(file.c_str(), "rb"));
  if (!stream) throw Error(file.string(), ": cannot be read: ", system_reason(errno));
  std::string content;
  std::array<char, 65536> block;
  for (;;) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), stream.get());
    content.append(block.data(), count);
    if (count < block.size()) break;
  }
  if (std::ferror(stream.get()) != 0) {
    throw Error(file.string(), ": cannot be read: ", system_reason(errno));
  }
  return content;
}

}  // namespace tegata

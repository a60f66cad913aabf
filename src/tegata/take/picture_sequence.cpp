// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/picture_sequence.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/video_file.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kPictureEndings = {".png", ".jpg", ".jpeg", ".tif",
                                                             ".tiff"};
constexpr std::array<std::string_view, 3> kVideoEndings = {".mp4", ".avi", ".mkv"};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool has_ending(const fs::path& file, std::span<const std::string_view> endings) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

// The files of a folder with one of the endings, by their names without it. Two files of one name
// are an Error: nothing says which of the two is meant.
std::map<std::string, fs::path> files_by_stem(const fs::path& folder,
                                              std::span<const std::string_view> endings) {
  std::map<std::string, fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (!entry.is_regular_file() || is_hidden(path) || !has_ending(path, endings)) continue;
    const auto [at, is_new] = files.emplace(path.stem().string(), path);
    if (!is_new) {
      throw Error(folder.string(), ": got both ", at->second.filename().string(), " and ",
                  path.filename().string(), ", expected one file of a name");
    }
  }
  return files;
}

std::optional<std::size_t> camera_of(const CameraRig& rig, const std::string& name) {
  for (std::size_t camera = 0; camera < rig.size(); ++camera) {
    if (rig[camera].name == name) return camera;
  }
  return std::nullopt;
}

std::string camera_list(const CameraRig& rig) {
  std::string list;
  for (const Camera& camera : rig) list += (list.empty() ? "" : ", ") + camera.name;
  return list;
}

std::string foreign_note(const fs::path& path, const CameraRig& rig) {
  return text(path.string(), ": belongs to no camera of the calibration (", camera_list(rig),
              ") and is not used");
}

class PictureFolders : public PictureSequence {
 public:
  PictureFolders(const fs::path& folder, const CameraRig& rig, Completeness completeness) {
    std::vector<std::map<std::string, fs::path>> files(rig.size());
    for (std::size_t camera = 0; camera < rig.size(); ++camera) {
      const fs::path own = folder / rig[camera].name;
      if (fs::is_directory(own)) files[camera] = files_by_stem(own, kPictureEndings);
      if (files[camera].empty() && completeness == Completeness::every_camera) {
        throw Error(own.string(), ": camera '", rig[camera].name, "' has no pictures, expected ",
                    folder.filename().string(), "/", rig[camera].name,
                    "/<frame>.png, .jpg or .tif");
      }
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (entry.is_directory() && !is_hidden(entry.path()) &&
          !camera_of(rig, entry.path().filename().string())) {
        notes_.push_back(foreign_note(entry.path(), rig));
      }
    }
    std::sort(notes_.begin(), notes_.end());
    pair_by_name(files);
  }

  bool has(std::size_t camera, std::size_t frame) const override {
    return !files_[camera][frame].empty();
  }
  CameraImage read(std::size_t camera, std::size_t frame) override {
    return read_picture(files_[camera][frame]);
  }

 private:
  void pair_by_name(const std::vector<std::map<std::string, fs::path>>& files) {
    std::set<std::string> names;
    for (const auto& of_camera : files) {
      for (const auto& [name, file] : of_camera) names.insert(name);
    }
    names_.assign(names.begin(), names.end());
    std::stable_sort(names_.begin(), names_.end(), natural_less);
    for (const auto& of_camera : files) {
      auto& in_order = files_.emplace_back();
      for (const std::string& name : names_) {
        const auto found = of_camera.find(name);
        in_order.push_back(found == of_camera.end() ? fs::path() : found->second);
      }
    }
  }

  std::vector<std::vector<fs::path>> files_;  // by camera and frame, empty where there is none
};

class Videos : public PictureSequence {
 public:
  Videos(const fs::path& folder, const CameraRig& rig, Completeness completeness)
      : videos_(rig.size()) {
    for (const auto& [name, file] : files_by_stem(folder, kVideoEndings)) {
      if (const auto camera = camera_of(rig, name)) {
        videos_[*camera].emplace(file);
      } else {
        notes_.push_back(foreign_note(file, rig));
      }
    }
    std::size_t frame_count = 0;
    for (std::size_t camera = 0; camera < rig.size(); ++camera) {
      if (videos_[camera]) {
        frame_count = std::max(frame_count, videos_[camera]->frame_count());
      } else if (completeness == Completeness::every_camera) {
        throw Error(folder.string(), ": camera '", rig[camera].name, "' has no video, expected ",
                    folder.filename().string(), "/", rig[camera].name, ".mp4, .avi or .mkv");
      }
    }
    for (std::size_t frame = 0; frame < frame_count; ++frame) {
      std::string name = std::to_string(frame);
      name.insert(0, name.size() < 6 ? 6 - name.size() : 0, '0');
      names_.push_back(std::move(name));
    }
  }

  bool has(std::size_t camera, std::size_t frame) const override {
    return videos_[camera] && frame < videos_[camera]->frame_count();
  }
  CameraImage read(std::size_t camera, std::size_t frame) override {
    return videos_[camera]->read(frame);
  }

 private:
  std::vector<std::optional<VideoFile>> videos_;
};

// The run of digits at a position, without leading zeros, and where it ends.
std::pair<std::string_view, std::size_t> digits_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  while (at + 1 < end && text[at] == '0') ++at;
  return {text.substr(at, end - at), end};
}

}  // namespace

std::unique_ptr<PictureSequence> open_picture_folders(const fs::path& folder, const CameraRig& rig,
                                                      Completeness completeness) {
  return std::make_unique<PictureFolders>(folder, rig, completeness);
}

std::unique_ptr<PictureSequence> open_videos(const fs::path& folder, const CameraRig& rig,
                                             Completeness completeness) {
  return std::make_unique<Videos>(folder, rig, completeness);
}

fs::path find_picture(const fs::path& folder, const std::string& stem) {
  if (!fs::is_directory(folder)) return {};
  const auto files = files_by_stem(folder, kPictureEndings);
  const auto found = files.find(stem);
  return found == files.end() ? fs::path() : found->second;
}

bool natural_less(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const auto [number_a, end_a] = digits_at(a, i);
      const auto [number_b, end_b] = digits_at(b, j);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
      if (number_a != number_b) return number_a < number_b;
      i = end_a;
      j = end_b;
    } else {
      if (a[i] != b[j]) return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
      ++i;
      ++j;
    }
  }
  const bool a_ended = i == a.size(), b_ended = j == b.size();
  if (a_ended != b_ended) return a_ended;
  return a < b;  // equal but for leading zeros
}

}  // namespace tegata

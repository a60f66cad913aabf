// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/offset_pictures.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tegata/base/error.h"

namespace tegata {
namespace {

class OffsetPictures : public PictureSequence {
 public:
  OffsetPictures(std::unique_ptr<PictureSequence> pictures, const std::vector<int>& offsets)
      : pictures_(std::move(pictures)), offsets_(offsets) {
    names_ = pictures_->names();
    notes_ = pictures_->notes();
    while (!names_.empty() && !anyone_has(names_.size() - 1)) names_.pop_back();
  }

  bool has(std::size_t camera, std::size_t frame) const override {
    const auto own = own_frame(camera, frame);
    return own && pictures_->has(camera, *own);
  }
  CameraImage read(std::size_t camera, std::size_t frame) override {
    return pictures_->read(camera, own_frame(camera, frame).value());
  }

 private:
  // Where a frame of the take stands in a camera's own recording.
  std::optional<std::size_t> own_frame(std::size_t camera, std::size_t frame) const {
    const auto own = static_cast<std::ptrdiff_t>(frame) + offsets_[camera];
    if (own < 0 || own >= static_cast<std::ptrdiff_t>(pictures_->names().size())) {
      return std::nullopt;
    }
    return static_cast<std::size_t>(own);
  }
  bool anyone_has(std::size_t frame) const {
    for (std::size_t camera = 0; camera < offsets_.size(); ++camera) {
      if (has(camera, frame)) return true;
    }
    return false;
  }

  std::unique_ptr<PictureSequence> pictures_;
  std::vector<int> offsets_;
};

}  // namespace

std::vector<int> camera_offsets(const TakeInfo& info, const CameraRig& rig,
                                const std::filesystem::path& file) {
  std::vector<int> offsets(rig.size(), 0);
  std::string names;
  for (const Camera& camera : rig) names += text(names.empty() ? "'" : ", '", camera.name, "'");
  for (const auto& [name, offset] : info.offsets) {
    const auto camera = std::find_if(
        rig.begin(), rig.end(), [&wanted = name](const Camera& c) { return c.name == wanted; });
    if (camera == rig.end()) {
      throw Error(file.string(), ": [offset] key '", name, "': there is no such camera, expected ",
                  names);
    }
    offsets[static_cast<std::size_t>(camera - rig.begin())] = offset;
  }
  return offsets;
}

std::unique_ptr<PictureSequence> with_offsets(std::unique_ptr<PictureSequence> pictures,
                                              const std::vector<int>& offsets) {
  if (std::all_of(offsets.begin(), offsets.end(), [](int offset) { return offset == 0; })) {
    return pictures;
  }
  return std::make_unique<OffsetPictures>(std::move(pictures), offsets);
}

}  // namespace tegata

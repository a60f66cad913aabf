// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/take.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/offset_pictures.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/picture_sequence.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

void check_size(const CameraImage& picture, const Camera& camera) {
  const int width = picture.values.width(), height = picture.values.height();
  if (width == camera.width && height == camera.height) return;
  throw Error("got a picture of ", width, " x ", height, " pixels, expected the ", camera.width,
              " x ", camera.height, " of the calibration");
}

// The first picture of each camera that can be decoded must have the size of the calibration.
void check_first_pictures(PictureSequence& pictures, const CameraRig& rig, const fs::path& folder) {
  for (std::size_t camera = 0; camera < rig.size(); ++camera) {
    for (std::size_t frame = 0; frame < pictures.names().size(); ++frame) {
      if (!pictures.has(camera, frame)) continue;
      CameraImage picture;
      try {
        picture = pictures.read(camera, frame);
      } catch (const Error&) {
        break;  // said when the frame is read
      }
      try {
        check_size(picture, rig[camera]);
      } catch (const Error& error) {
        throw Error(folder.string(), ": camera '", rig[camera].name, "', frame ",
                    pictures.names()[frame], ": ", error.what());
      }
      break;
    }
  }
}

// Some frame must be seen by two cameras.
void check_pairs(const PictureSequence& pictures, const CameraRig& rig, const fs::path& folder) {
  for (std::size_t frame = 0; frame < pictures.names().size(); ++frame) {
    std::size_t count = 0;
    for (std::size_t camera = 0; camera < rig.size(); ++camera)
      count += pictures.has(camera, frame);
    if (count >= 2) return;
  }
  if (pictures.names().empty()) throw Error(folder.string(), ": got no frames, expected some");
  throw Error(folder.string(), ": no frame has pictures of two cameras (the first is ",
              pictures.names().front(), ", the last ", pictures.names().back(),
              "), expected the same file names for each camera");
}

fs::path existing(const fs::path& path) { return fs::is_directory(path) ? path : fs::path(); }

std::unique_ptr<PictureSequence> open_pictures(const fs::path& images, const fs::path& videos,
                                               const CameraRig& rig, Completeness completeness) {
  if (!images.empty()) return open_picture_folders(images, rig, completeness);
  if (!videos.empty()) return open_videos(videos, rig, completeness);
  return nullptr;
}

void check_calibration_exists(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw Error(folder.string(), ": there is no such folder, expected a take: a folder with ",
                "calibration.toml and images/, videos/ or masks/");
  }
  if (!fs::exists(folder / "calibration.toml")) {
    throw Error((folder / "calibration.toml").string(), ": there is no such file, expected the ",
                "cameras of the take: a table [cam_0] with name, size, matrix, distortions, ",
                "rotation and translation for each");
  }
}

}  // namespace

struct Take::State {
  fs::path folder;
  TakeInfo info;
  CameraRig rig;
  PictureSource source = PictureSource::images;
  std::unique_ptr<PictureSequence> masks;            // where there are
  std::unique_ptr<PictureSequence> pictures;         // may be absent beside masks
  std::map<std::string, std::size_t> picture_frame;  // of a frame's name
  std::vector<std::string> notes;
  bool notes_said = false;
  std::set<std::string> said;  // warnings, each once

  PictureSequence& frames() const { return masks ? *masks : *pictures; }
  void open_sources();
  void check_method() const;
  std::optional<CameraImage> read(PictureSequence& sequence, std::size_t camera, std::size_t frame,
                                  const Observer& observer);
};

void Take::State::open_sources() {
  const fs::path images = existing(folder / "images"), videos = existing(folder / "videos");
  const fs::path mask_folder = existing(folder / "masks");
  const std::vector<int> offsets = camera_offsets(info, rig, folder / "take.toml");
  if (!images.empty() && !videos.empty()) {
    throw Error(folder.string(), ": got both images/ and videos/, expected one of the two");
  }
  if (images.empty() && videos.empty() && mask_folder.empty()) {
    throw Error(folder.string(), ": got no pictures, expected a folder images/, videos/ or masks/");
  }
  if (!mask_folder.empty()) {
    source = PictureSource::masks;
    masks =
        with_offsets(open_picture_folders(mask_folder, rig, Completeness::every_camera), offsets);
    notes = masks->notes();
    check_pairs(*masks, rig, mask_folder);
    check_first_pictures(*masks, rig, mask_folder);
  } else {
    source = videos.empty() ? PictureSource::images : PictureSource::videos;
  }
  const auto completeness = masks ? Completeness::some_cameras : Completeness::every_camera;
  pictures = open_pictures(images, videos, rig, completeness);
  if (!pictures) return;
  pictures = with_offsets(std::move(pictures), offsets);
  notes.insert(notes.end(), pictures->notes().begin(), pictures->notes().end());
  const fs::path& picture_folder = images.empty() ? videos : images;
  if (!masks) check_pairs(*pictures, rig, picture_folder);
  check_first_pictures(*pictures, rig, picture_folder);
  for (std::size_t i = 0; i < pictures->names().size(); ++i) {
    picture_frame.emplace(pictures->names()[i], i);
  }
}

void Take::State::check_method() const {
  const std::string where =
      (folder / "take.toml").string() + ": [segmentation] key 'method': got '";
  if (info.hand_label && !masks) {
    throw Error((folder / "take.toml").string(),
                ": [segmentation] key 'hand_label': expected label images in masks/");
  }
  if (info.segmentation == SegmentationMethod::mask && !masks) {
    throw Error(where, "mask', expected a folder masks/ beside it, or another method");
  }
  if (info.segmentation != SegmentationMethod::background || masks) return;
  for (const Camera& camera : rig) {
    if (find_picture(folder / "background", camera.name).empty()) {
      throw Error(where, "background', expected the empty scene in background/", camera.name,
                  ".png");
    }
  }
}

// A picture of a frame, or nothing, which is said, where it is of no use.
std::optional<CameraImage> Take::State::read(PictureSequence& sequence, std::size_t camera,
                                             std::size_t frame, const Observer& observer) {
  if (!sequence.has(camera, frame)) return std::nullopt;
  try {
    CameraImage picture = sequence.read(camera, frame);
    check_size(picture, rig[camera]);
    if (&sequence != masks.get()) return picture;
    return mask_from_silhouette(info.hand_label ? silhouette_from_labels(picture, *info.hand_label)
                                                : silhouette_from_mask(picture));
  } catch (const Error& error) {
    const std::string warning = text("frame ", sequence.names()[frame], ", camera '",
                                     rig[camera].name, "' is left out: ", error.what());
    if (said.insert(warning).second) observer.warn(warning);
    return std::nullopt;
  }
}

std::size_t TakeFrame::view_count() const {
  return static_cast<std::size_t>(std::count_if(
      pictures.begin(), pictures.end(), [](const auto& picture) { return picture.has_value(); }));
}

std::string TakeFrame::why_missing(const std::string& camera) const {
  const bool is_broken = std::find(broken.begin(), broken.end(), camera) != broken.end();
  return is_broken ? "its picture cannot be read" : "there is no picture";
}

Take::Take(std::unique_ptr<State> state) : state_(std::move(state)) {}
Take::~Take() = default;
Take::Take(Take&&) noexcept = default;
Take& Take::operator=(Take&&) noexcept = default;

Take Take::open(const fs::path& folder) {
  try {
    check_calibration_exists(folder);
    auto state = std::make_unique<State>();
    state->folder = folder;
    if (fs::exists(folder / "take.toml")) state->info = read_take_info(folder / "take.toml");
    if (state->info.name.empty()) {
      const fs::path whole = fs::canonical(folder);
      state->info.name = whole.filename().string();
    }
    state->rig = read_calibration(folder / "calibration.toml", state->info.metres_per_unit);
    state->open_sources();
    state->check_method();
    return Take(std::move(state));
  } catch (const fs::filesystem_error& error) {
    throw Error(error.path1().string(), ": cannot be read: ", error.code().message());
  }
}

const fs::path& Take::folder() const { return state_->folder; }
const TakeInfo& Take::info() const { return state_->info; }
const CameraRig& Take::rig() const { return state_->rig; }
PictureSource Take::source() const { return state_->source; }
bool Take::has_pictures() const { return state_->pictures != nullptr; }
const std::vector<std::string>& Take::frame_names() const { return state_->frames().names(); }
const std::vector<std::string>& Take::notes() const { return state_->notes; }

std::optional<CameraImage> Take::background(std::size_t camera) const {
  const Camera& of_rig = state_->rig.at(camera);
  const fs::path file = find_picture(state_->folder / "background", of_rig.name);
  if (file.empty()) return std::nullopt;
  CameraImage picture = read_picture(file);
  try {
    check_size(picture, of_rig);
  } catch (const Error& error) {
    throw Error(file.string(), ": ", error.what());
  }
  return picture;
}

TakeFrame Take::read_frame(std::size_t index, const Observer& observer) {
  State& state = *state_;
  if (index >= frame_names().size()) {
    throw Error(state.folder.string(), ": got frame index ", index, ", expected one below ",
                frame_names().size());
  }
  if (!std::exchange(state.notes_said, true)) {
    for (const std::string& note : state.notes) observer.warn(note);
  }
  TakeFrame frame{frame_names()[index], static_cast<double>(index) / state.info.fps, {}, {}};
  for (std::size_t camera = 0; camera < state.rig.size(); ++camera) {
    frame.pictures.push_back(state.read(state.frames(), camera, index, observer));
    if (!frame.pictures.back() && state.frames().has(camera, index)) {
      frame.broken.push_back(state.rig[camera].name);
    }
  }
  return frame;
}

TakeFrame Take::read_display_frame(std::size_t index, const Observer& observer) {
  TakeFrame frame = read_frame(index, observer);
  State& state = *state_;
  if (!state.masks || !state.pictures) return frame;
  const auto found = state.picture_frame.find(frame.name);
  if (found == state.picture_frame.end()) return frame;
  for (std::size_t camera = 0; camera < state.rig.size(); ++camera) {
    auto picture = state.read(*state.pictures, camera, found->second, observer);
    if (picture) frame.pictures[camera] = std::move(picture);
  }
  return frame;
}

}  // namespace tegata

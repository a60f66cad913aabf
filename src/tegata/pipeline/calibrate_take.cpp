// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/calibrate_take.h"

#include <algorithm>
#include <array>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/calibrate/board_detection.h"
#include "tegata/take/calibration_import.h"
#include "tegata/take/offset_pictures.h"
#include "tegata/take/picture_sequence.h"
#include "tegata/take/take_info.h"
#include "tegata/take/toml_table.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kVideoEndings = {".mp4", ".avi", ".mkv"};

int count_of(const TomlTable& table, std::string_view key) {
  constexpr int kMost = 1000;
  return table.whole_number(key, 1, kMost);
}

// Caliscope's charuco.toml: the size of a square in centimetres, or the board's in its unit.
Board read_caliscope_board(const TomlTable& table) {
  constexpr double kCentimetre = 0.01, kInch = 0.0254;
  Board board;
  board.columns = count_of(table, "columns");
  board.rows = count_of(table, "rows");
  board.dictionary = table.string("dictionary");
  board.inverted = table.has("inverted") && table.flag("inverted");
  if (table.has("square_size_override_cm")) {
    board.spacing = kCentimetre * table.positive_number("square_size_override_cm");
  } else {
    const double unit = table.string("units") == "inch" ? kInch : kCentimetre;
    board.spacing = unit * std::min(table.positive_number("board_width") / board.columns,
                                    table.positive_number("board_height") / board.rows);
  }
  board.marker = table.positive_number("aruco_scale") * board.spacing;
  return board;
}

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::sort(names.begin(), names.end(),
            [](const std::string& a, const std::string& b) { return natural_less(a, b); });
  return names;
}

struct Source {
  fs::path folder;
  bool videos = false;
  std::vector<std::string> cameras;
};

std::vector<std::string> videos_in(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension();
    if (std::find(kVideoEndings.begin(), kVideoEndings.end(), ending) != kVideoEndings.end()) {
      names.push_back(entry.path().stem());
    }
  }
  return sorted(names);
}

Source find_source(const fs::path& folder) {
  if (fs::is_directory(folder / "images")) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "images")) {
      if (entry.is_directory()) names.push_back(entry.path().filename());
    }
    return {folder / "images", false, sorted(names)};
  }
  for (const fs::path& place : {folder / "videos", folder}) {
    if (const std::vector<std::string> names = videos_in(place); !names.empty()) {
      return {place, true, names};
    }
  }
  throw Error(folder.string(), ": got no pictures of a board, expected images/<camera>/, ",
              "videos/<camera>.mp4 or <camera>.mp4");
}

fs::path find_board_file(const fs::path& folder, const fs::path& asked) {
  if (!asked.empty()) return asked;
  for (const std::string_view name : {"board.toml", "charuco.toml"}) {
    if (fs::exists(folder / name)) return folder / name;
  }
  throw Error(folder.string(), ": got no board.toml, expected the board's kind and size there or ",
              "with --board");
}

void set_known_intrinsics(std::vector<Camera>& cameras, const fs::path& file) {
  const CameraRig known = import_calibration(file).rig;
  for (Camera& camera : cameras) {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const Camera& c) { return c.name == camera.name; });
    if (found == known.end()) {
      throw Error(file.string(), ": there is no camera '", camera.name, "'");
    }
    if (found->lens_model != LensModel::perspective) {
      throw Error(file.string(), ": camera '", camera.name,
                  "' has a fisheye lens, expected perspective ones");
    }
    if (camera.width != found->width || camera.height != found->height) {
      throw Error(file.string(), ": camera '", camera.name, "': got a size of ", found->width,
                  " x ", found->height, ", its pictures are ", camera.width, " x ", camera.height);
    }
    camera = *found;
  }
}

}  // namespace

Board read_board(const fs::path& file) {
  const TomlTable table = TomlTable::read(file);
  Board board;
  if (table.has("aruco_scale")) {
    board = read_caliscope_board(table);
  } else {
    constexpr std::array<std::string_view, 7> kKeys = {"kind",   "columns",    "rows",    "spacing",
                                                       "marker", "dictionary", "inverted"};
    table.expect_keys(kKeys);
    board.kind = board_kind_from_name(table.string("kind"));
    board.columns = count_of(table, "columns");
    board.rows = count_of(table, "rows");
    board.spacing = table.positive_number("spacing");
    if (table.has("inverted")) board.inverted = table.flag("inverted");
    if (board.kind == BoardKind::charuco) {
      board.marker = table.positive_number("marker");
      board.dictionary = table.string("dictionary");
    }
  }
  try {
    check_board(board);
  } catch (const Error& error) {
    throw Error(file.string(), ": ", error.what());
  }
  return board;
}

fs::path find_intrinsics(const fs::path& folder, const std::string& asked) {
  if (asked == "find") return {};
  if (!asked.empty()) return asked;
  for (const std::string_view name : {"intrinsics.toml", "camera_array.toml"}) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return {};
}

BoardRecording read_board_recording(const fs::path& folder, const CalibrateTakeOptions& options,
                                    const Observer& observer) {
  if (!fs::is_directory(folder)) throw Error(folder.string(), ": there is no such folder");
  const Source source = find_source(folder);
  BoardRecording recording;
  recording.board = read_board(find_board_file(folder, options.board_file));
  const BoardDetector detector(recording.board);
  for (const std::string& name : source.cameras) {
    Camera camera;
    camera.name = name;
    recording.cameras.push_back(camera);
  }
  const fs::path info_file = folder / "take.toml";
  const TakeInfo info = fs::exists(info_file) ? read_take_info(info_file) : TakeInfo();
  const auto pictures = with_offsets(
      source.videos
          ? open_videos(source.folder, recording.cameras, Completeness::every_camera)
          : open_picture_folders(source.folder, recording.cameras, Completeness::every_camera),
      camera_offsets(info, recording.cameras, info_file));
  const std::size_t total = pictures->names().size();
  const std::size_t count = std::min(total, options.most_frames);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t frame = i * total / count;
    std::vector<std::optional<CameraImage>> images(source.cameras.size());
    for (std::size_t c = 0; c < images.size(); ++c) {
      if (!pictures->has(c, frame)) continue;
      try {
        images[c] = pictures->read(c, frame);
      } catch (const Error& error) {
        observer.warn(text("frame ", pictures->names()[frame], ", camera '", source.cameras[c],
                           "' is left out: ", error.what()));
        continue;
      }
      Camera& camera = recording.cameras[c];
      const int width = images[c]->values.width(), height = images[c]->values.height();
      if (camera.width == 0) {
        camera.width = width;
        camera.height = height;
      }
      if (camera.width != width || camera.height != height) {
        throw Error(source.folder.string(), ": camera '", camera.name, "': got pictures of ",
                    camera.width, " x ", camera.height, " and of ", width, " x ", height,
                    ", expected one size");
      }
    }
    std::vector<BoardView> views(images.size());
    parallel_for(images.size(), options.threads, [&](std::size_t c) {
      if (images[c]) views[c] = detector.detect(*images[c]);
    });
    recording.frame_names.push_back(pictures->names()[frame]);
    recording.views.push_back(std::move(views));
    observer.progress("board", i + 1, count);
  }
  if (!options.intrinsics_file.empty()) {
    set_known_intrinsics(recording.cameras, options.intrinsics_file);
  }
  return recording;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_colmap.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/take/calibration_fields.h"

namespace tegata {
namespace {

constexpr std::string_view kColmapBlanks = " \t\r";

// Which parameters a model has, in order: f for both focal lengths, x and y for one each, c and d
// for the principal point, digits and letters from 'A' for the index in Distortion.
struct Model {
  std::string_view name, parameters;
  LensModel lens;
};
constexpr std::array<Model, 9> kModels = {{
    {"SIMPLE_PINHOLE", "fcd", LensModel::perspective},
    {"PINHOLE", "xycd", LensModel::perspective},
    {"SIMPLE_RADIAL", "fcd0", LensModel::perspective},
    {"RADIAL", "fcd01", LensModel::perspective},
    {"OPENCV", "xycd0123", LensModel::perspective},
    {"FULL_OPENCV", "xycd01234567", LensModel::perspective},
    {"OPENCV_FISHEYE", "xycd0123", LensModel::fisheye},
    {"SIMPLE_RADIAL_FISHEYE", "fcd0", LensModel::fisheye},
    {"RADIAL_FISHEYE", "fcd01", LensModel::fisheye},
}};

struct Line {
  std::string_view text;
  std::string where;  ///< "cameras.txt: line 3"
  std::vector<std::string_view> words;

  double number(std::size_t word) const {
    double value = 0.0;
    const std::string_view& written = words[word];
    const auto [last, problem] =
        std::from_chars(written.data(), written.data() + written.size(), value);
    if (problem != std::errc() || last != written.data() + written.size() ||
        !std::isfinite(value)) {
      throw Error(where, ": got '", written, "', expected a finite number");
    }
    return value;
  }
};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kColmapBlanks); at != std::string_view::npos;
       at = line.find_first_not_of(kColmapBlanks, at)) {
    const std::size_t end = std::min(line.find_first_of(kColmapBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

// The lines that say something: neither blank nor remarks.
std::vector<Line> lines_of(std::string_view content, const std::string& file) {
  std::vector<Line> lines;
  std::size_t number = 0;
  while (!content.empty()) {
    const std::size_t end = std::min(content.find('\n'), content.size());
    Line line{content.substr(0, end), "", {}};
    content.remove_prefix(std::min(end + 1, content.size()));
    ++number;
    line.words = words_of(line.text);
    if (line.words.empty() || line.words.front().front() == '#') continue;
    line.where = text(file, ": line ", number);
    lines.push_back(std::move(line));
  }
  return lines;
}

Camera read_camera(const Line& line) {
  const auto model = std::find_if(kModels.begin(), kModels.end(), [&](const Model& m) {
    return line.words.size() > 1 && line.words[1] == m.name;
  });
  if (model == kModels.end()) {
    std::string names;
    for (const Model& m : kModels) names += text(names.empty() ? "" : ", ", m.name);
    throw Error(line.where, ": got the model '", line.words.size() > 1 ? line.words[1] : "",
                "', expected one of ", names);
  }
  constexpr std::size_t kFirst = 4;  // after id, model, width and height
  const std::size_t count = model->parameters.size();
  if (line.words.size() != kFirst + count) {
    throw Error(line.where, ": got ", line.words.size(), " words, expected ", kFirst + count,
                " for ", model->name);
  }
  Camera camera;
  camera.lens_model = model->lens;
  set_size(camera, line.number(2), line.number(3), line.where);
  for (std::size_t i = 0; i < count; ++i) {
    const double value = line.number(kFirst + i);
    const char parameter = model->parameters[i];
    constexpr double kHalf = 0.5;
    if (parameter == 'f') camera.fx = camera.fy = value;
    if (parameter == 'x') camera.fx = value;
    if (parameter == 'y') camera.fy = value;
    if (parameter == 'c') camera.cx = value - kHalf;
    if (parameter == 'd') camera.cy = value - kHalf;
    if (parameter >= '0' && parameter <= '9') {
      camera.distortion[static_cast<std::size_t>(parameter - '0')] = value;
    }
  }
  return camera;
}

struct Image {
  std::string name, where;
  Camera camera;
};

// The line of an image's points has three numbers each and no name.
bool is_point_line(const Line& line) {
  constexpr std::string_view kNumber = "0123456789+-.eE";
  return line.words.size() % 3 == 0 &&
         std::all_of(line.words.begin(), line.words.end(), [&](std::string_view word) {
           return word.find_first_not_of(kNumber) == std::string_view::npos;
         });
}

Image read_image(const Line& line, const std::map<std::string, Camera, std::less<>>& cameras,
                 double metres_per_unit) {
  constexpr std::size_t kName = 9;  // after id, quaternion, translation and camera
  if (line.words.size() <= kName) {
    throw Error(line.where, ": got ", line.words.size(),
                " words, expected IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME");
  }
  const auto camera = cameras.find(line.words[kName - 1]);
  if (camera == cameras.end()) {
    throw Error(line.where, ": got camera ", line.words[kName - 1],
                ", expected one of those in cameras.txt");
  }
  Image image;
  image.where = line.where;
  image.camera = camera->second;
  const auto begin = static_cast<std::size_t>(line.words[kName].data() - line.text.data());
  image.name = line.text.substr(begin);
  image.name.erase(image.name.find_last_not_of(kColmapBlanks) + 1);
  const Eigen::Quaterniond rotation(line.number(1), line.number(2), line.number(3), line.number(4));
  if (std::abs(rotation.norm() - 1.0) > 1e-3) {
    throw Error(line.where, ": got a quaternion of length ", rotation.norm(), ", expected 1");
  }
  image.camera.camera_from_world = {
      rotation.normalized(),
      metres_per_unit * Eigen::Vector3d(line.number(5), line.number(6), line.number(7))};
  return image;
}

// The folder of each image, where each has one of its own; else the name without ending.
void name_cameras(std::vector<Image>& images) {
  std::set<std::string> folders;
  for (const Image& image : images) {
    const std::string folder = std::filesystem::path(image.name).parent_path().filename();
    if (!folder.empty()) folders.insert(folder);
  }
  const bool by_folder = folders.size() == images.size();
  for (Image& image : images) {
    const std::filesystem::path path(image.name);
    image.camera.name = by_folder ? path.parent_path().filename() : path.stem();
    check_camera_name(image.camera.name, image.where);
  }
}

}  // namespace

CameraRig read_colmap(const ColmapText& content, double metres_per_unit) {
  std::map<std::string, Camera, std::less<>> cameras;
  for (const Line& line : lines_of(content.cameras, content.cameras_file)) {
    cameras[std::string(line.words.front())] = read_camera(line);
  }
  std::vector<Image> images;
  for (const Line& line : lines_of(content.images, content.images_file)) {
    if (!images.empty() && is_point_line(line)) continue;
    images.push_back(read_image(line, cameras, metres_per_unit));
  }
  name_cameras(images);
  CameraRig rig;
  for (const Image& image : images) rig.push_back(image.camera);
  return rig;
}

}  // namespace tegata

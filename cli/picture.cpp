// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "progress.h"
#include "tegata/image/overlay.h"
#include "tegata/pipeline/overlays.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/take.h"

namespace tegata {
namespace {

constexpr Colour kPaper = {250, 250, 248};
constexpr Colour kSkin = {214, 160, 126};

struct Arguments {
  std::string result, take, picture, hand_file;
  std::size_t frames = 4;
  int width = 320;
  CommonOptions common;
};

CameraImage blank(int width, int height) {
  CameraImage picture;
  picture.values = Image<std::uint16_t>(width, height, 0, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        picture.values(x, y, c) = kPaper[static_cast<std::size_t>(c)];
      }
    }
  }
  return picture;
}

/// A camera that sees the hand from between the rig's cameras, filling most of a square picture.
Camera viewpoint(const CameraRig& rig, const ResultFrame& frame, int width) {
  Eigen::Vector3d hand = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& keypoint : frame.keypoints) hand += keypoint / kKeypointCount;
  double radius = 0.0;
  for (const Eigen::Vector3d& keypoint : frame.keypoints) {
    radius = std::max(radius, (keypoint - hand).norm());
  }
  Eigen::Vector3d towards = Eigen::Vector3d::Zero(), down = Eigen::Vector3d::Zero();
  for (const Camera& camera : rig) {
    towards += (camera.center_in_world() - hand).normalized();
    down += camera.camera_from_world.rotation.conjugate() * Eigen::Vector3d::UnitY();
  }
  // Cameras all around cancel out: then any of their directions is as good.
  if (towards.norm() < 0.1) towards = rig.front().center_in_world() - hand;
  const Eigen::Vector3d z = -towards.normalized();
  if (down.cross(z).norm() < 0.1) down = z.unitOrthogonal();
  const Eigen::Vector3d x = down.cross(z).normalized();
  Eigen::Matrix3d rotation;
  rotation << x.transpose(), z.cross(x).transpose(), z.transpose();

  constexpr double kDistanceInRadii = 6.0;
  Camera camera;
  camera.name = "viewpoint";
  camera.width = camera.height = width;
  camera.fx = camera.fy = 0.4 * width * kDistanceInRadii;
  camera.cx = camera.cy = 0.5 * (width - 1);
  camera.camera_from_world.rotation = Eigen::Quaterniond(rotation);
  camera.camera_from_world.translation = -(rotation * (hand - kDistanceInRadii * radius * z));
  return camera;
}

/// One row a frame: a picture of each camera, then the fitted hand alone.
std::vector<CameraImage> draw_rows(const std::vector<Overlay>& overlays, const CameraRig& rig,
                                   const Result& result, const HandModel& hand) {
  std::map<std::string, std::map<std::string, const Overlay*>> by_frame;
  int height = 1;
  for (const Overlay& overlay : overlays) {
    by_frame[overlay.frame][overlay.camera] = &overlay;
    height = std::max(height, overlay.picture.values.height());
  }
  std::vector<CameraImage> pictures;
  for (const ResultFrame& frame : result.frames) {
    if (!by_frame.contains(frame.name)) continue;
    const auto& row = by_frame.at(frame.name);
    for (const Camera& camera : rig) {
      const auto overlay = row.find(camera.name);
      pictures.push_back(overlay == row.end() ? blank(1, 1) : overlay->second->picture);
    }
    pictures.push_back(blank(height, height));
    if (frame.pose) {
      draw_shaded(pictures.back(), PosedHand(hand, *frame.pose).surface(),
                  viewpoint(rig, frame, height), kSkin);
    }
  }
  return pictures;
}

void run(const Arguments& arguments) {
  const Result result = read_result_json(std::filesystem::path(arguments.result) / "result.json");
  Take take = Take::open(arguments.take);
  const HandModel hand = load_hand(arguments.hand_file, result.side);
  if (hand.name != result.model_name) {
    throw Error(arguments.result, ": was fitted with the hand '", result.model_name, "', got '",
                hand.name, "'; give that hand's file with --hand");
  }
  std::vector<Overlay> overlays;
  {
    Progress progress(arguments.common.quiet);
    overlays =
        draw_overlays(take, result, hand, arguments.frames, arguments.width, progress.observer());
  }
  const std::vector<CameraImage> pictures = draw_rows(overlays, take.rig(), result, hand);
  if (pictures.empty()) throw Error(arguments.result, ": no frame of the result has a picture");
  const int columns = static_cast<int>(take.rig().size()) + 1;
  write_picture(contact_sheet(pictures, columns, kPaper), arguments.picture);
  if (arguments.common.json) {
    std::cout << nlohmann::ordered_json{{"picture", arguments.picture},
                                        {"rows",
                                         pictures.size() / static_cast<std::size_t>(columns)},
                                        {"columns", columns}}
                     .dump()
              << "\n";
  } else {
    std::cout << "drew " << arguments.picture << "\n";
  }
}

}  // namespace

void add_picture_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "picture", "Draw a result over the cameras' pictures: a row a frame, a column a camera");
  command->add_option("RESULT", arguments->result, "Folder that fit made")->required();
  command->add_option("--take", arguments->take, "The take that was fitted")->required();
  command->add_option("-o,--output", arguments->picture, "PNG, JPEG or TIFF to write")->required();
  command->add_option("--hand", arguments->hand_file, "The hand that was fitted, as for fit");
  command->add_option("--frames", arguments->frames, "Rows, spread evenly over the frames")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--width", arguments->width, "Most pixels of a camera's picture in width")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata picture demo/result --take demo/take -o demo/picture.png");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata

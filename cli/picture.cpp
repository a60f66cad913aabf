// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.h"
#include "hand_view.h"
#include "progress.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/image/overlay.h"
#include "tegata/pipeline/overlays.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/take.h"
#include "turning_hand.h"

namespace tegata {
namespace picture_command {

constexpr int kGutter = 6;          // between pictures [px]
constexpr int kAnyWidth = 1 << 30;  // of overlays that are cut out afterwards

struct Arguments {
  std::string result, take, picture, hand_file;
  std::size_t frames = 4;
  int width = 320;
  bool whole = false;
  CommonOptions common;
};

/// A square part of a picture: its top left corner and its side [px], which may reach beyond the
/// picture.
struct Window {
  double left = 0.0, top = 0.0, side = 0.0;
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
Camera viewpoint(const CameraRig& rig, const TriangleMesh& hand, int width) {
  const Ball ball = ball_around(hand);
  Eigen::Vector3d towards = Eigen::Vector3d::Zero(), down = Eigen::Vector3d::Zero();
  for (const Camera& camera : rig) {
    towards += (camera.center_in_world() - ball.middle).normalized();
    down += camera.camera_from_world.rotation.conjugate() * Eigen::Vector3d::UnitY();
  }
  // Cameras all around cancel out: then any of their directions is as good.
  if (towards.norm() < 0.1) towards = rig.front().center_in_world() - ball.middle;
  const Eigen::Vector3d z = -towards.normalized();
  if (down.cross(z).norm() < 0.1) down = z.unitOrthogonal();
  const Eigen::Vector3d x = down.cross(z).normalized();
  return camera_around(ball, {-z, -z.cross(x)}, width, 6.0, 0.45);
}

/// What a camera's picture shows of the hand's surroundings.
Window around_hand(const Camera& camera, const TriangleMesh& hand) {
  constexpr double kMargin = 1.35;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& vertex : hand.vertices) {
    const std::optional<Eigen::Vector2d> pixel = project(camera, vertex);
    if (pixel) box.extend(*pixel);
  }
  if (box.isEmpty()) return {0.0, 0.0, static_cast<double>(camera.width)};
  const double side = kMargin * box.sizes().maxCoeff();
  return {box.center().x() - 0.5 * side, box.center().y() - 0.5 * side, side};
}

/// Bilinear between the centres of pixels; the position must lie between them.
std::uint16_t sampled(const Image<std::uint16_t>& image, double x, double y, int channel) {
  const int left = std::min(static_cast<int>(x), std::max(0, image.width() - 2));
  const int top = std::min(static_cast<int>(y), std::max(0, image.height() - 2));
  const int right = std::min(left + 1, image.width() - 1);
  const int bottom = std::min(top + 1, image.height() - 1);
  const double u = x - left, v = y - top;
  const double upper = (1.0 - u) * image(left, top, channel) + u * image(right, top, channel);
  const double lower = (1.0 - u) * image(left, bottom, channel) + u * image(right, bottom, channel);
  return static_cast<std::uint16_t>(std::lround((1.0 - v) * upper + v * lower));
}

/// The part of a picture in a window, `width` pixels wide and high, and a gutter right and below.
CameraImage cut_out(const CameraImage& picture, const Window& window, int width) {
  CameraImage cut = blank(width + kGutter, width + kGutter);
  const auto last_x = static_cast<double>(picture.values.width() - 1);
  const auto last_y = static_cast<double>(picture.values.height() - 1);
  const double scale = window.side / width;
  for (int y = 0; y < width; ++y) {
    const double from_y = std::clamp(window.top + (y + 0.5) * scale, 0.0, last_y);
    for (int x = 0; x < width; ++x) {
      const double from_x = std::clamp(window.left + (x + 0.5) * scale, 0.0, last_x);
      for (int c = 0; c < 3; ++c) cut.values(x, y, c) = sampled(picture.values, from_x, from_y, c);
    }
  }
  return cut;
}

/// One row a frame: a picture of each camera, then the fitted hand alone.
std::vector<CameraImage> draw_rows(const std::vector<Overlay>& overlays, const CameraRig& rig,
                                   const Result& result, const HandModel& hand,
                                   const Arguments& arguments) {
  std::map<std::string, std::map<std::string, const Overlay*>> by_frame;
  for (const Overlay& overlay : overlays) by_frame[overlay.frame][overlay.camera] = &overlay;
  std::vector<CameraImage> pictures;
  for (const ResultFrame& frame : result.frames) {
    if (!frame.pose || !by_frame.contains(frame.name)) continue;
    const auto& row = by_frame.at(frame.name);
    const TriangleMesh surface = PosedHand(hand, *frame.pose).surface();
    int height = arguments.width;
    for (const Camera& camera : rig) {
      const auto overlay = row.find(camera.name);
      if (overlay == row.end()) {
        pictures.push_back(blank(1, 1));
      } else if (arguments.whole) {
        pictures.push_back(overlay->second->picture);
        height = std::min(height, pictures.back().values.height());
      } else {
        pictures.push_back(
            cut_out(overlay->second->picture, around_hand(camera, surface), arguments.width));
      }
    }
    pictures.push_back(blank(height, height));
    draw_shaded(pictures.back(), surface, viewpoint(rig, surface, height), kSkin);
  }
  return pictures;
}

void draw_video(const Result& result, const HandModel& hand, const Arguments& arguments) {
  std::size_t count = 0;
  write_whole(arguments.picture, [&](const std::filesystem::path& file) {
    Progress progress(arguments.common.quiet);
    count = write_turning_hand(result, hand, arguments.width, file, progress.observer());
  });
  if (arguments.common.json) {
    std::cout << nlohmann::ordered_json{{"video", arguments.picture}, {"pictures", count}}.dump()
              << "\n";
  } else {
    std::cout << "drew " << arguments.picture << "\n";
  }
}

void draw_sheet(const Result& result, const HandModel& hand, const Arguments& arguments) {
  Take take = Take::open(arguments.take);
  std::vector<Overlay> overlays;
  {
    Progress progress(arguments.common.quiet);
    overlays = draw_overlays(
        take, result, hand,
        {.most_frames = arguments.frames, .widest = arguments.whole ? arguments.width : kAnyWidth},
        progress.observer());
  }
  const std::vector<CameraImage> pictures =
      draw_rows(overlays, take.rig(), result, hand, arguments);
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

void run(const Arguments& arguments) {
  const Result result = read_result_json(std::filesystem::path(arguments.result) / "result.json");
  const HandModel hand = scaled(load_hand(arguments.hand_file, result.side), result.model_scale);
  if (hand.name != result.model_name) {
    throw Error(arguments.result, ": was fitted with the hand '", result.model_name, "', got '",
                hand.name, "'; give that hand's file with --hand");
  }
  if (std::filesystem::path(arguments.picture).extension() == ".mp4") {
    draw_video(result, hand, arguments);
  } else if (arguments.take.empty()) {
    throw Error(arguments.picture,
                ": is drawn over the pictures of the take: give it with --take, "
                "or ask for a video of the hand alone (.mp4)");
  } else {
    draw_sheet(result, hand, arguments);
  }
}

}  // namespace picture_command

void add_picture_command(CLI::App& program) {
  using namespace picture_command;
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "picture",
      "Draw a result over the cameras' pictures, a row a frame and a column a camera; or the "
      "hand alone as a video");
  command->add_option("RESULT", arguments->result, "Folder that fit made")->required();
  command->add_option("--take", arguments->take, "The take that was fitted; not for a video");
  command
      ->add_option("-o,--output", arguments->picture,
                   "PNG, JPEG or TIFF to write, or MP4: the hand turns once and goes through its "
                   "frames")
      ->required();
  command->add_option("--hand", arguments->hand_file, "The hand that was fitted, as for fit");
  command->add_option("--frames", arguments->frames, "Rows, spread evenly over the frames")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--width", arguments->width,
                   "Pixels of a camera's picture or a video in width, with --whole at most")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  command->add_flag("--whole", arguments->whole,
                    "Whole pictures instead of what is around the hand");
  add_common_options(*command, arguments->common);
  command->footer(
      "Example: tegata picture demo/result --take demo/take -o demo/picture.png\n"
      "         tegata picture demo/result -o demo/hand.mp4\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata

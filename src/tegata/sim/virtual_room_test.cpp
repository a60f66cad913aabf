// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/virtual_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <string>

#include "tegata/base/error.h"
#include "tegata/image/silhouette.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/sim/sim_test_hand.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/take.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/truth.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

SimulationOptions small_options() {
  SimulationOptions options;
  options.width = 160;
  options.height = 120;
  options.frame_count = 3;
  options.threads = 1;
  return options;
}

// Every file's bytes by its name within the folder.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    files[fs::relative(entry.path(), folder).string()] = {std::istreambuf_iterator<char>(stream),
                                                          {}};
  }
  return files;
}

Silhouette mask_of(const Take& take, std::size_t camera, const std::string& frame) {
  return silhouette_from_mask(
      read_picture(take.folder() / "masks" / take.rig()[camera].name / (frame + ".png")));
}

// Whether a hand pixel lies within a pixel and a half: fingertips are keypoints on the very edge.
bool is_hand_beside(const Silhouette& mask, const Eigen::Vector2d& pixel) {
  const int x = static_cast<int>(pixel.x() + 0.5), y = static_cast<int>(pixel.y() + 0.5);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (mask.contains(x + dx, y + dy) && mask(x + dx, y + dy) == PixelLabel::hand) return true;
    }
  }
  return false;
}

TEST(VirtualRoom, SameSeedGivesSameBytesOnOneThreadAndOnTwo) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  simulate_take(sim_test_hand(), options, folder / "one", false, {});
  options.threads = 2;
  simulate_take(sim_test_hand(), options, folder / "two", false, {});
  options.seed = 2;
  simulate_take(sim_test_hand(), options, folder / "other", false, {});
  const auto one = contents(folder / "one");
  EXPECT_EQ(one.size(), 4u + 3u * (3u + 1u));
  EXPECT_TRUE(one == contents(folder / "two"));
  for (const auto& [name, bytes] : contents(folder / "other")) {
    ASSERT_TRUE(one.contains(name)) << name;
    EXPECT_NE(one.at(name), bytes) << name;
  }
}

TEST(VirtualRoom, TakeOpensAndSaysWhatWasAskedFor) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  options.bits = 16;
  options.camera_count = 4;
  options.grasp = SimulatedGrasp::sphere;
  simulate_take(sim_test_hand(), options, folder / "take", false, {});
  Take take = Take::open(folder / "take");
  EXPECT_EQ(take.source(), PictureSource::images);
  EXPECT_EQ(take.info().name, "sphere-infrared-right-1");
  EXPECT_EQ(take.info().side, Side::right);
  EXPECT_EQ(take.rig().size(), 4u);
  EXPECT_TRUE(take.rig()[0].is_distorted());
  EXPECT_EQ(take.frame_names(), (std::vector<std::string>{"000000", "000001", "000002"}));
  const TakeFrame frame = take.read_frame(1, {});
  EXPECT_EQ(frame.view_count(), 4u);
  EXPECT_EQ(frame.pictures[0]->bits, 16);
}

TEST(VirtualRoom, TruthLiesInsideTheCleanSilhouettesOfEveryView) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  options.mode = SimulatedMode::clean;
  for (const SimulatedGrasp grasp : {SimulatedGrasp::cylinder, SimulatedGrasp::pinch}) {
    options.grasp = grasp;
    simulate_take(sim_test_hand(), options, folder / "take", true, {});
    const Take take = Take::open(folder / "take");
    const Truth truth = read_truth_json(folder / "take" / "truth.json");
    ASSERT_EQ(truth.frames.size(), 3u);
    for (const TruthFrame& frame : truth.frames) {
      for (std::size_t c = 0; c < take.rig().size(); ++c) {
        const Silhouette mask = mask_of(take, c, frame.name);
        EXPECT_EQ(count_pixels(mask, PixelLabel::unknown), 0u);
        for (const Eigen::Vector3d& keypoint : frame.keypoints) {
          const Eigen::Vector2d pixel = *project(take.rig()[c], keypoint);
          ASSERT_TRUE(take.rig()[c].contains(pixel));
          EXPECT_TRUE(is_hand_beside(mask, pixel))
              << frame.name << " camera " << c << " at " << pixel.transpose();
        }
      }
    }
  }
}

TEST(VirtualRoom, GraspStaysWhileTheHandTurnsAndTheSurfaceIsTheTrueOne) {
  const TestFolder folder;
  simulate_take(sim_test_hand(), small_options(), folder / "take", false, {});
  const Truth truth = read_truth_json(folder / "take" / "truth.json");
  ASSERT_EQ(truth.frames.size(), 3u);
  EXPECT_EQ(*truth.frames[0].angles, *truth.frames[2].angles);
  EXPECT_GT((truth.frames[0].keypoints[8] - truth.frames[2].keypoints[8]).norm(), 0.005);
  for (const TruthFrame& frame : truth.frames) {
    const TriangleMesh surface = read_ply(folder / "take" / "truth" / (frame.name + ".ply"));
    EXPECT_EQ(surface.vertices.size(), sim_test_hand().rest_surface.vertices.size());
    EXPECT_TRUE(bounding_box(surface).contains(frame.keypoints[0]));
    EXPECT_TRUE(bounding_box(surface).contains(frame.keypoints[9]));
  }
}

TEST(VirtualRoom, MaskIsUnknownWhereTheObjectIsAndElseAsTheCleanOne) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  options.mode = SimulatedMode::mask;
  simulate_take(sim_test_hand(), options, folder / "mask", false, {});
  options.mode = SimulatedMode::clean;
  simulate_take(sim_test_hand(), options, folder / "clean", false, {});
  const Take with = Take::open(folder / "mask"), without = Take::open(folder / "clean");
  std::size_t hidden = 0;
  for (std::size_t c = 0; c < with.rig().size(); ++c) {
    const Silhouette mask = mask_of(with, c, "000001"), clean = mask_of(without, c, "000001");
    EXPECT_GT(count_pixels(mask, PixelLabel::unknown), 20u);
    for (std::size_t i = 0; i < mask.values().size(); ++i) {
      if (mask.values()[i] == PixelLabel::unknown) {
        hidden += clean.values()[i] == PixelLabel::hand ? 1 : 0;
      } else {
        EXPECT_EQ(mask.values()[i], clean.values()[i]);
      }
    }
  }
  EXPECT_GT(hidden, 20u);
}

TEST(VirtualRoom, TheObjectLiesInTheHandAndIsWrittenWhereItHidesSomething) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  simulate_take(sim_test_hand(), options, folder / "infrared", false, {});
  const TriangleMesh object = read_ply(folder / "infrared/object.ply");
  EXPECT_LT(bounding_box(object).exteriorDistance(Eigen::Vector3d(0.0, 0.0, 0.0)), 0.1);
  EXPECT_GT(enclosed_volume(object), 1e-6);
  options.mode = SimulatedMode::clean;
  simulate_take(sim_test_hand(), options, folder / "clean", false, {});
  EXPECT_FALSE(fs::exists(folder / "clean/object.ply"));
}

TEST(VirtualRoom, ForearmIsSeenButIsNotInTheTruth) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  options.mode = SimulatedMode::clean;
  options.frame_count = 1;
  simulate_take(sim_test_hand(), options, folder / "with", false, {});
  options.forearm = false;
  simulate_take(sim_test_hand(), options, folder / "without", false, {});
  const Take with = Take::open(folder / "with"), without = Take::open(folder / "without");
  std::size_t more = 0;
  for (std::size_t c = 0; c < with.rig().size(); ++c) {
    more += count_pixels(mask_of(with, c, "000000"), PixelLabel::hand) -
            count_pixels(mask_of(without, c, "000000"), PixelLabel::hand);
  }
  EXPECT_GT(more, 500u);
  EXPECT_EQ(contents(folder / "with" / "truth"), contents(folder / "without" / "truth"));
}

TEST(VirtualRoom, LeftHandIsTakenWithTheSameAngles) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  options.frame_count = 1;
  simulate_take(sim_test_hand(), options, folder / "right", false, {});
  options.side = Side::left;
  simulate_take(sim_test_hand(Side::left), options, folder / "left", false, {});
  const Truth right = read_truth_json(folder / "right" / "truth.json");
  const Truth left = read_truth_json(folder / "left" / "truth.json");
  EXPECT_EQ(left.side, Side::left);
  EXPECT_EQ(Take::open(folder / "left").info().side, Side::left);
  EXPECT_LT((*right.frames[0].angles - *left.frames[0].angles).norm(), 1e-6);
  EXPECT_THROW(simulate_take(sim_test_hand(Side::right), options, folder / "odd", false, {}),
               Error);
}

TEST(VirtualRoom, InitialLandmarksAreRoughByAboutACentimetre) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  options.frame_count = 1;
  for (options.seed = 1; options.seed <= 3; ++options.seed) {
    simulate_take(sim_test_hand(), options, folder / "take", true, {});
    const auto landmarks = Take::open(folder / "take").info().initial_landmarks;
    ASSERT_TRUE(landmarks.has_value());
    const auto keypoints = read_truth_json(folder / "take" / "truth.json").frames[0].keypoints;
    for (const double off :
         {(landmarks->wrist - keypoints[0]).norm(), (landmarks->index_mcp - keypoints[5]).norm(),
          (landmarks->little_mcp - keypoints[17]).norm()}) {
      EXPECT_GT(off, 0.004);
      EXPECT_LT(off, 0.016);
    }
  }
  options.initial_pose = false;
  simulate_take(sim_test_hand(), options, folder / "take", true, {});
  EXPECT_FALSE(Take::open(folder / "take").info().initial_landmarks.has_value());
}

TEST(VirtualRoom, ProgressIsSaidOnceAFrame) {
  const TestFolder folder;
  SimulationOptions options = small_options();
  options.threads = 2;
  std::vector<std::size_t> done;
  Observer observer;
  observer.on_progress = [&](std::string_view, std::size_t so_far, std::size_t total) {
    EXPECT_EQ(total, 3u);
    done.push_back(so_far);
  };
  simulate_take(sim_test_hand(), options, folder / "take", false, observer);
  EXPECT_EQ(done, (std::vector<std::size_t>{1, 2, 3}));
}

TEST(VirtualRoom, WhatCannotBeDoneIsAnErrorAndLeavesNothingBehind) {
  const TestFolder folder;
  const auto message_of = [&](const SimulationOptions& options) {
    return error_of([&] { simulate_take(sim_test_hand(), options, folder / "take", false, {}); });
  };
  SimulationOptions options = small_options();
  options.camera_count = 1;
  EXPECT_TRUE(says(message_of(options), "1 camera"));
  options = small_options();
  options.frame_count = 0;
  EXPECT_TRUE(says(message_of(options), "0 frames"));
  options = small_options();
  options.bits = 10;
  EXPECT_TRUE(says(message_of(options), "10 bits"));
  options = small_options();
  options.turn_deg = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(message_of(options), "turn of nan"));
  options = small_options();
  options.width = -3;
  EXPECT_TRUE(says(message_of(options), "-3 x 120"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
  EXPECT_THROW(simulated_mode_from_name("colour"), Error);

  options = small_options();
  options.frame_count = 1;
  simulate_take(sim_test_hand(), options, folder / "take", false, {});
  EXPECT_TRUE(says(message_of(options), "take", "exists"));
}

}  // namespace
}  // namespace tegata

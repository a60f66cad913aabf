// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/fit_take.h"

#include <gtest/gtest.h>

#include "tegata/pipeline/overlays.h"
#include "tegata/pipeline/test_take.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

double keypoint_error(const ResultFrame& frame, std::size_t index) {
  const auto truth = posed_keypoints(test::small_hand().skeleton, test::small_pose(index));
  double sum = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k) sum += (truth[k] - frame.keypoints[k]).norm();
  return sum / static_cast<double>(truth.size());
}

void write_landmarks(const std::filesystem::path& folder) {
  TakeInfo info;
  info.name = "masks";
  info.side = Side::right;
  const auto truth = posed_keypoints(test::small_hand().skeleton, test::small_pose(0));
  info.initial_landmarks = InitialLandmarks{truth[0] + Eigen::Vector3d(0.0, 0.01, 0.0), truth[5],
                                            truth[17] - Eigen::Vector3d(0.008, 0.0, 0.0)};
  write_take_info(info, folder / "take.toml");
}

TEST(FitTake, MasksOfAKnownHandGiveItsPose) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 3);
  write_landmarks(folder.path());
  Take take = Take::open(folder.path());
  std::vector<std::string> hulls;
  FitTakeOptions options;
  options.on_hull = [&](const std::string& frame, const TriangleMesh& hull) {
    hulls.push_back(frame);
    EXPECT_GT(hull.triangles.size(), 500U);
  };
  const Result result = fit_take(take, test::small_hand(), options, {});
  ASSERT_EQ(result.frames.size(), 3U);
  ASSERT_TRUE(result.start);
  EXPECT_EQ(result.start->frame, "000000");
  EXPECT_EQ(hulls, (std::vector<std::string>{"000000", "000001", "000002"}));
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_EQ(result.frames[f].status, "ok");
    EXPECT_LT(keypoint_error(result.frames[f], f), 0.006) << "frame " << f;
  }
  EXPECT_EQ(result.frames[2].views.size(), 2U) << "the last camera lacks the last frame";
}

TEST(FitTake, FramesThatWaitOnDiskGiveTheSameResultAndLeaveNothingThere) {
  const TestFolder folder, scratch;
  test::write_mask_take(folder.path(), 3);
  write_landmarks(folder.path());
  Take take = Take::open(folder.path());
  FitTakeOptions options;
  const Result in_memory = fit_take(take, test::small_hand(), options, {});
  options.scratch_folder = scratch.path();
  const Result on_disk = fit_take(take, test::small_hand(), options, {});
  EXPECT_EQ(on_disk.grasp_angles, in_memory.grasp_angles);
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_EQ(on_disk.frames[f].keypoints, in_memory.frames[f].keypoints) << "frame " << f;
    EXPECT_EQ(on_disk.frames[f].silhouette_iou, in_memory.frames[f].silhouette_iou);
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

TEST(FitTake, AFrameOfOneCameraKeepsItsEntryWithoutAPose) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 2);
  write_landmarks(folder.path());
  std::filesystem::remove(folder / "masks/camera_0/000001.png");
  Take take = Take::open(folder.path());
  const Result result = fit_take(take, test::small_hand(), {}, {});
  ASSERT_EQ(result.frames.size(), 2U);
  EXPECT_TRUE(result.frames[0].pose.has_value());
  EXPECT_FALSE(result.frames[1].pose.has_value());
  EXPECT_TRUE(says(result.frames[1].status, "1 camera", "2 or more"));
}

TEST(FitTake, EmptySilhouettesEverywhereAreAnErrorThatSaysSo) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 2);
  const CameraImage nothing{Image<std::uint16_t>(200, 160, 0), 8};
  for (const char* camera : {"camera_0", "camera_1"}) {
    write_picture(nothing, folder / "masks" / camera / "000000.png");
    write_picture(nothing, folder / "masks" / camera / "000001.png");
  }
  Take take = Take::open(folder.path());
  EXPECT_TRUE(says(error_of([&] { fit_take(take, test::small_hand(), {}, {}); }),
                   "none of 2 frames", "hand found in 1 view"));
}

TEST(FitTake, RefusesFramesThatTheTakeDoesNotHave) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 2);
  Take take = Take::open(folder.path());
  FitTakeOptions options;
  options.frames.first = 7;
  EXPECT_TRUE(
      says(error_of([&] { fit_take(take, test::small_hand(), options, {}); }), "7", "2 frames"));
}

TEST(Overlays, ShowEveryViewOfTheChosenFrames) {
  const TestFolder folder;
  test::write_mask_take(folder.path(), 3);
  Take take = Take::open(folder.path());
  Result result;
  for (std::size_t f = 0; f < 3; ++f) {
    ResultFrame frame;
    frame.name = text("00000", f);
    frame.pose = test::small_pose(f);
    result.frames.push_back(frame);
  }
  const auto overlays =
      draw_overlays(take, result, test::small_hand(), {.most_frames = 2, .widest = 100}, {});
  ASSERT_EQ(overlays.size(), 5U) << "frames 0 and 2; the last camera lacks the last frame";
  EXPECT_EQ(overlays.front().frame, "000000");
  EXPECT_EQ(overlays.back().frame, "000002");
  EXPECT_LE(overlays.front().picture.values.width(), 100);
  EXPECT_EQ(overlays.front().picture.values.channels(), 3);
}

}  // namespace
}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/grasp_fit.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"
#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

struct GraspScene {
  std::vector<HandPose> truth;
  std::vector<FitFrame> frames;
  std::vector<const FitFrame*> pointers;
};

GraspScene turning_grasp(int count) {
  GraspScene scene;
  for (int f = 0; f < count; ++f) {
    scene.truth.push_back(test::grasping_pose(0.25 * f));
    scene.frames.push_back(
        test::perfect_frame(test::coarse_hand(), scene.truth.back(), test::orthogonal_rig(0.8)));
  }
  for (const FitFrame& frame : scene.frames) scene.pointers.push_back(&frame);
  return scene;
}

StartLandmarks rough_landmarks(const HandPose& truth) {
  const auto keypoints = posed_keypoints(test::coarse_hand().skeleton, truth);
  return {keypoints[0] + Eigen::Vector3d(0.008, 0.0, -0.004),
          keypoints[5] + Eigen::Vector3d(-0.005, 0.006, 0.0),
          keypoints[17] + Eigen::Vector3d(0.0, -0.008, 0.005)};
}

TEST(GraspFit, FollowsATurningHandFromRoughLandmarks) {
  GraspScene scene = turning_grasp(3);
  const HandModel& hand = test::coarse_hand();
  scene.frames[0].landmarks = rough_landmarks(scene.truth[0]);
  GraspFitOptions options;
  options.joint.object_rounds = 0;
  const GraspFit fit = fit_grasp(FitHand(hand), GivenFrames(scene.pointers), options, {});
  ASSERT_EQ(fit.poses.size(), 3U);
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_LT(test::mean_keypoint_distance(hand, fit.poses[f], scene.truth[f]), 0.002) << f;
    EXPECT_EQ(fit.poses[f].angles, fit.angles);
  }
  EXPECT_TRUE((fit.standard_deviations.array() > 0.0).all());
}

TEST(GraspFit, FramesThatDoNotMakeTheGraspHaveTheirPosesByIt) {
  GraspScene scene = turning_grasp(3);
  const HandModel& hand = test::coarse_hand();
  scene.frames[0].landmarks = rough_landmarks(scene.truth[0]);
  GraspFitOptions options;
  options.most_joint_frames = 2;
  options.joint.object_rounds = 0;
  const GraspFit fit = fit_grasp(FitHand(hand), GivenFrames(scene.pointers), options, {});
  ASSERT_EQ(fit.poses.size(), 3U);
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_LT(test::mean_keypoint_distance(hand, fit.poses[f], scene.truth[f]), 0.003) << f;
    EXPECT_EQ(fit.poses[f].angles, fit.angles);
  }
}

TEST(GraspFit, FreeFramesKeepAnglesOfTheirOwn) {
  GraspScene scene = turning_grasp(2);
  const HandModel& hand = test::coarse_hand();
  scene.truth[1].angles[5] += 0.3;
  scene.frames[1] = test::perfect_frame(hand, scene.truth[1], test::orthogonal_rig(0.8));
  scene.frames[0].landmarks = rough_landmarks(scene.truth[0]);
  GraspFitOptions options;
  options.grasp = GraspConstraint::free;
  const GraspFit fit = fit_grasp(FitHand(hand), GivenFrames(scene.pointers), options, {});
  EXPECT_GT(fit.poses[1].angles[5] - fit.poses[0].angles[5], 0.1);
}

// Counts the frames that somebody keeps.
class CountedFrames final : public FrameSource {
 public:
  explicit CountedFrames(const std::vector<FitFrame>& frames) : frames_(frames) {}
  std::size_t size() const override { return frames_.size(); }
  std::shared_ptr<const FitFrame> frame(std::size_t i) const override {
    most_ = std::max(most_, ++count_);
    return {&frames_[i], [this](const FitFrame*) { --count_; }};
  }
  int most() const { return most_; }

 private:
  const std::vector<FitFrame>& frames_;
  mutable int count_ = 0, most_ = 0;
};

TEST(GraspFit, KeepsNoMoreFramesAtATimeThanMakeTheGrasp) {
  GraspScene scene = turning_grasp(5);
  scene.frames[0].landmarks = rough_landmarks(scene.truth[0]);
  GraspFitOptions options;
  options.most_joint_frames = 2;
  options.joint.object_rounds = 0;
  options.threads = 1;
  for (const GraspConstraint constraint : {GraspConstraint::soft, GraspConstraint::free}) {
    options.grasp = constraint;
    const CountedFrames frames(scene.frames);
    const GraspFit fit = fit_grasp(FitHand(test::coarse_hand()), frames, options, {});
    EXPECT_EQ(frames.most(), 2);
    for (std::size_t f = 0; f < 5; ++f) {
      EXPECT_LT(test::mean_keypoint_distance(test::coarse_hand(), fit.poses[f], scene.truth[f]),
                0.004)
          << f;
    }
  }
}

TEST(GraspFit, StartsWithoutLandmarks) {
  // Hundreds of starts: a hand of few triangles keeps the test short under the sanitizers.
  const HandModel hand = built_in_hand(HandShape{}, Side::right, {.triangle_count = 600});
  const HandPose truth = test::grasping_pose(0.0);
  const FitFrame frame = test::perfect_frame(hand, truth, test::orthogonal_rig(0.8));
  const FitFrame* const frames[] = {&frame};
  GraspFitOptions options;
  options.joint.object_rounds = 0;
  const GraspFit fit = fit_grasp(FitHand(hand), GivenFrames(frames), options, {});
  EXPECT_LT(test::mean_keypoint_distance(hand, fit.poses[0], truth), 0.004);
  ASSERT_TRUE(fit.start);
  EXPECT_EQ(fit.start->frame, 0U);
  EXPECT_GT(fit.start->lead, 1.0);
}

TEST(GraspFit, AFirstFrameThatShowsSomethingElseMisleadsNoOther) {
  const HandModel hand = built_in_hand(HandShape{}, Side::right, {.triangle_count = 600});
  const HandModel other = built_in_hand(HandShape{}, Side::left, {.triangle_count = 600});
  const CameraRig rig = test::orthogonal_rig(0.8);
  std::vector<HandPose> truth;
  std::vector<FitFrame> frames;
  for (int f = 0; f < 4; ++f) {
    truth.push_back(test::grasping_pose(0.15 * f));
    frames.push_back(test::perfect_frame(f == 0 ? other : hand, truth.back(), rig));
  }
  std::vector<const FitFrame*> pointers;
  for (const FitFrame& frame : frames) pointers.push_back(&frame);
  GraspFitOptions options;
  options.grasp = GraspConstraint::free;
  options.seeks_again = false;
  const GraspFit fit = fit_grasp(FitHand(hand), GivenFrames(pointers), options, {});
  for (std::size_t f = 1; f < truth.size(); ++f) {
    EXPECT_LT(test::mean_keypoint_distance(hand, fit.poses[f], truth[f]), 0.005) << f;
  }
}

TEST(GraspFit, RefusesNoFramesAndFramesWithoutAHull) {
  const FitHand hand(test::coarse_hand());
  EXPECT_THROW(fit_grasp(hand, GivenFrames({}), {}, {}), Error);
  const FitFrame without_hull;
  const FitFrame* const frames[] = {&without_hull};
  EXPECT_THROW(fit_grasp(hand, GivenFrames(frames), {}, {}), Error);
}

}  // namespace
}  // namespace tegata

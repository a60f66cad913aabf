// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/evaluate/evaluation.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tegata/base/angle.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/mesh/shapes_for_tests.h"
#include "tegata/take/result.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/truth.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

const HandModel& coarse_hand() {
  static const HandModel hand = built_in_hand({}, Side::right, {0.005, 1000});
  return hand;
}

HandPose some_pose() {
  return {{Eigen::Quaterniond::Identity(), {0.1, 0.2, 0.9}}, relaxed_angles()};
}

// A truth of three frames and the same as a result; tests then change what they need.
class EvaluationTest : public testing::Test {
 protected:
  EvaluationTest() {
    fs::create_directories(folder_ / "result/meshes");
    fs::create_directories(folder_ / "take/truth");
    result_.take = "take";
    for (const char* name : {"000000", "000001", "000002"}) {
      const PosedHand posed(coarse_hand(), some_pose());
      truth_.frames.push_back({name, posed.keypoints(), some_pose().angles});
      write_ply(posed.surface(), folder_ / "take/truth" / text(name, ".ply"));
      ResultFrame& frame = result_.frames.emplace_back();
      frame.name = name;
      put_pose(frame, some_pose());
    }
  }

  void put_pose(ResultFrame& frame, const HandPose& pose) {
    const PosedHand posed(coarse_hand(), pose);
    frame.pose = pose;
    frame.keypoints = posed.keypoints();
    write_ply(posed.surface(), folder_ / "result/meshes" / text(frame.name, ".ply"));
  }
  Evaluation evaluate(int threads = 1) {
    write_result_json(result_, folder_ / "result/result.json");
    write_truth_json(truth_, folder_ / "take/truth.json");
    return evaluate_result(folder_ / "result", folder_ / "take", threads);
  }
  std::string evaluation_error() {
    return error_of([&] { evaluate(); });
  }

  TestFolder folder_;
  Result result_;
  Truth truth_;
};

TEST_F(EvaluationTest, TheTruthItselfHasNoError) {
  const Evaluation evaluation = evaluate();
  EXPECT_EQ(evaluation.fitted_count, 3u);
  EXPECT_EQ(evaluation.ok_count, 3u);
  for (const EvaluationMeasure& measure : evaluation_measures()) {
    ASSERT_TRUE(measure.get(evaluation.worst).has_value()) << measure.key;
    EXPECT_NEAR(*measure.get(evaluation.worst), 0.0, 1e-5) << measure.key;
  }
}

TEST_F(EvaluationTest, AShiftOfOneFrameShowsInMeanMedianAndWorst) {
  HandPose shifted = some_pose();
  shifted.world_from_hand.translation += Eigen::Vector3d(0.0, 0.0, 0.006);
  put_pose(result_.frames[1], shifted);
  const Evaluation evaluation = evaluate();
  EXPECT_NEAR(evaluation.worst.keypoint_error_mm, 6.0, 1e-9);
  EXPECT_NEAR(evaluation.mean.keypoint_error_mm, 2.0, 1e-9);
  EXPECT_NEAR(evaluation.median.keypoint_error_mm, 0.0, 1e-9);
  EXPECT_NEAR(evaluation.worst.keypoint_root_relative_mm, 0.0, 1e-9);
  EXPECT_NEAR(*evaluation.worst.vertex_error_mm, 6.0, 1e-3);
  EXPECT_GT(evaluation.worst.surface_error_mm, 2.0);
  EXPECT_LT(evaluation.worst.surface_error_mm, 6.0);
  EXPECT_NEAR(*evaluation.worst.angle_error_deg, 0.0, 1e-9);
}

TEST_F(EvaluationTest, OneAngleOffByTwentyDegreesIsOneInTheMeanOfTwenty) {
  HandPose bent = some_pose();
  bent.angles[6] += 20.0 * kDegree;  // index PIP
  put_pose(result_.frames[0], bent);
  const Evaluation evaluation = evaluate();
  EXPECT_NEAR(*evaluation.frames[0].angle_error_deg, 1.0, 1e-9);
  EXPECT_NEAR(evaluation.frames[0].flexion_error_deg, 20.0 / 15.0, 0.05);
  EXPECT_GT(evaluation.frames[0].keypoint_error_mm, 0.1);
}

TEST_F(EvaluationTest, FramesWithoutAPoseAreCountedAndNotAveraged) {
  result_.frames[0].pose.reset();
  result_.frames[0].status = "only one view";
  result_.frames[1].status = "the views disagree";
  fs::remove(folder_ / "result/meshes/000000.ply");
  const Evaluation evaluation = evaluate();
  EXPECT_EQ(evaluation.fitted_count, 2u);
  EXPECT_EQ(evaluation.not_fitted_count, 1u);
  EXPECT_EQ(evaluation.ok_count, 1u);
  ASSERT_EQ(evaluation.frames.size(), 2u);
  EXPECT_EQ(evaluation.frames[0].status, "the views disagree");
  EXPECT_NE(evaluation_table(evaluation).find("2 of 3 frames fitted, 1 with status ok"),
            std::string::npos);
}

TEST_F(EvaluationTest, NothingFittedIsNoPerfectResult) {
  for (ResultFrame& frame : result_.frames) {
    frame.pose.reset();
    frame.status = "only one view";
  }
  const Evaluation evaluation = evaluate();
  EXPECT_TRUE(nlohmann::json::parse(evaluation_json(evaluation))["mean"].is_null());
  EXPECT_EQ(evaluation_table(evaluation), "0 of 3 frames fitted, 0 with status ok\n");
}

TEST_F(EvaluationTest, FramesThatOnlyOneSideHasAreCounted) {
  truth_.frames.erase(truth_.frames.begin());
  result_.frames.pop_back();
  const Evaluation evaluation = evaluate();
  EXPECT_EQ(evaluation.without_truth_count, 1u);
  EXPECT_EQ(evaluation.not_in_result_count, 1u);
  EXPECT_EQ(evaluation.frames.size(), 1u);
  result_.frames.pop_back();
  EXPECT_TRUE(says(evaluation_error(), "1 frame", "2 frames", "no frame in common"));
}

TEST_F(EvaluationTest, MeasuresThatDoNotApplyAreAbsentNotZero) {
  for (TruthFrame& frame : truth_.frames) {
    frame.angles.reset();
    TriangleMesh mesh = PosedHand(coarse_hand(), some_pose()).surface();
    mesh.triangles.pop_back();
    write_ply(mesh, folder_ / "take/truth" / (frame.name + ".ply"));
  }
  const Evaluation evaluation = evaluate();
  EXPECT_FALSE(evaluation.mean.vertex_error_mm.has_value());
  EXPECT_FALSE(evaluation.frames[0].angle_error_deg.has_value());
  const auto json = nlohmann::json::parse(evaluation_json(evaluation));
  EXPECT_TRUE(json["mean"]["angle_error_deg"].is_null());
  EXPECT_TRUE(json["mean"]["surface_error_mm"].is_number());
  EXPECT_NE(evaluation_table(evaluation).find("-"), std::string::npos);
}

TEST_F(EvaluationTest, AnObjectIsComparedInTheHandsFrame) {
  EXPECT_FALSE(evaluate().object_error_mm.has_value()) << "neither side has one";
  TriangleMesh plate = shapes::unit_cube();
  for (Eigen::Vector3d& vertex : plate.vertices) {
    vertex = 0.2 * (vertex - Eigen::Vector3d(0.5, 0.5, 0.0)) + Eigen::Vector3d(0.0, 0.0, 0.012);
  }
  write_ply(plate, folder_ / "take/object.ply");
  EXPECT_FALSE(evaluate().object_error_mm.has_value()) << "none was found";
  shapes::move(plate, {0.0, 0.0, 0.003});
  write_ply(plate, folder_ / "result/object.ply");
  const Evaluation evaluation = evaluate();
  ASSERT_TRUE(evaluation.object_error_mm.has_value());
  EXPECT_NEAR(*evaluation.object_error_mm, 3.0, 0.3);
  EXPECT_NE(evaluation_table(evaluation).find("held object"), std::string::npos);
}

TEST_F(EvaluationTest, MissingFilesAndOtherHandsAreSaid) {
  fs::remove(folder_ / "result/meshes/000001.ply");
  EXPECT_TRUE(says(evaluation_error(), "meshes/000001.ply", "fitted surface", "000001"));
  put_pose(result_.frames[1], some_pose());
  fs::remove(folder_ / "take/truth/000002.ply");
  EXPECT_TRUE(says(evaluation_error(), "truth/000002.ply", "true surface"));
  truth_.side = Side::left;
  EXPECT_TRUE(says(evaluation_error(), "right hand", "left", "truth.json"));
  fs::remove(folder_ / "take/truth.json");
  EXPECT_TRUE(says(error_of([&] { evaluate_result(folder_ / "result", folder_ / "take", 1); }),
                   "truth.json", "No such file"));
}

TEST_F(EvaluationTest, ATruthInMillimetresIsSaid) {
  for (TruthFrame& frame : truth_.frames) {
    for (auto& keypoint : frame.keypoints) keypoint *= 1000.0;
  }
  EXPECT_TRUE(says(evaluation_error(), "frame 00000", "metres"));
}

TEST_F(EvaluationTest, ThreadsDoNotChangeTheFigures) {
  HandPose shifted = some_pose();
  shifted.world_from_hand.translation.x() += 0.002;
  put_pose(result_.frames[2], shifted);
  EXPECT_EQ(evaluation_json(evaluate(1)), evaluation_json(evaluate(3)));
}

TEST_F(EvaluationTest, JsonHasEveryFigureOfEveryFrame) {
  const auto json = nlohmann::json::parse(evaluation_json(evaluate()));
  EXPECT_EQ(json["format"], "tegata-evaluation");
  EXPECT_EQ(json["version"], 1);
  ASSERT_EQ(json["frames"].size(), 3u);
  for (const EvaluationMeasure& measure : evaluation_measures()) {
    EXPECT_TRUE(json["frames"][1][measure.key].is_number()) << measure.key;
    EXPECT_TRUE(json["median"][measure.key].is_number()) << measure.key;
  }
}

}  // namespace
}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/calibration_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tegata/base/angle.h"
#include "tegata/base/random.h"
#include "tegata/base/text.h"
#include "tegata/calibrate/calibration_suspicion.h"
#include "tegata/calibrate/hull_coverage.h"
#include "tegata/image/rasterizer.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

// Cameras around the origin at about 0.8 m that look at it, none opposite another.
CameraRig ring(std::size_t count) {
  constexpr std::array<double, 6> kElevations = {0.2, 0.9, -0.2, 0.6, 0.0, 0.8};  // [rad]
  CameraRig rig;
  for (std::size_t i = 0; i < count; ++i) {
    const double around = 50.0 * kDegree * static_cast<double>(i);
    Camera camera;
    camera.name = text("cam_", i);
    camera.width = 320;
    camera.height = 240;
    camera.fx = camera.fy = 500.0;
    camera.cx = 160.0;
    camera.cy = 120.0;
    camera.camera_from_world = {so3_exp({kElevations[i], 0.0, 0.0}) * so3_exp({0.0, around, 0.0}),
                                {0.01, 0.0, 0.8 + 0.05 * static_cast<double>(i)}};
    rig.push_back(camera);
  }
  return rig;
}

// Something without symmetry, as a hand has none: a palm, a thumb and a finger made of boxes.
TriangleMesh shape(std::uint64_t seed) {
  Random random(seed);
  const Rigid3d pose = {
      so3_exp({random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-3.0, 3.0)}),
      {random.uniform(-0.04, 0.04), random.uniform(-0.03, 0.03), random.uniform(-0.04, 0.04)}};
  TriangleMesh mesh;
  const auto add_box = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d corner((i & 1 ? high : low).x(), (i & 2 ? high : low).y(),
                                   (i & 4 ? high : low).z());
      mesh.vertices.push_back(pose * corner);
    }
    for (const auto& [a, b, c] : {std::tuple(0u, 1u, 3u),
                                  {0u, 3u, 2u},
                                  {4u, 5u, 7u},
                                  {4u, 7u, 6u},
                                  {0u, 1u, 5u},
                                  {0u, 5u, 4u},
                                  {2u, 3u, 7u},
                                  {2u, 7u, 6u},
                                  {0u, 2u, 6u},
                                  {0u, 6u, 4u},
                                  {1u, 3u, 7u},
                                  {1u, 7u, 5u}}) {
      mesh.triangles.push_back({base + a, base + b, base + c});
    }
  };
  add_box({-0.04, -0.05, -0.012}, {0.04, 0.04, 0.012});
  add_box({0.02, 0.04, -0.008}, {0.035, 0.12, 0.008});
  add_box({-0.08, -0.04, -0.008}, {-0.03, -0.02, 0.03});
  return mesh;
}

Silhouette flipped(const Silhouette& silhouette) {
  Silhouette out = silhouette;
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) out(x, y) = silhouette(out.width() - 1 - x, y);
  }
  return out;
}

// What cameras that stand as `truth` says see, in frames of different poses.
RigOutlines seen(const CameraRig& truth, int mirrored_camera = -1) {
  constexpr std::uint64_t kFrames = 6;
  RigOutlines frames;
  for (std::uint64_t f = 0; f < kFrames; ++f) {
    frames.emplace_back();
    const TriangleMesh mesh = shape(f);
    for (std::size_t c = 0; c < truth.size(); ++c) {
      Silhouette silhouette = render_silhouette(mesh, truth[c]);
      if (static_cast<int>(c) == mirrored_camera) silhouette = flipped(silhouette);
      frames.back().push_back(outline_rays(silhouette, truth[c]));
    }
  }
  return frames;
}

CameraRig turned(CameraRig rig, std::size_t camera, const Eigen::Vector3d& by) {
  Rigid3d& pose = rig[camera].camera_from_world;
  const Eigen::Quaterniond turn = so3_exp(by);
  pose = {turn * pose.rotation, turn * pose.translation};
  return rig;
}

bool blames(const std::optional<Suspicion>& suspicion, const std::string& camera) {
  return suspicion && std::find(suspicion->cameras.begin(), suspicion->cameras.end(), camera) !=
                          suspicion->cameras.end();
}

TEST(CalibrationCheck, DoesNotCryWolf) {
  for (const std::size_t count : {2u, 3u, 4u, 6u}) {
    const CameraRig rig = ring(count);
    const CalibrationCheck check = check_calibration(rig, seen(rig));
    EXPECT_TRUE(check.agrees()) << check.problems.front().message;
    EXPECT_FALSE(check.pairs.empty());
    for (const PairTangency& pair : check.pairs) EXPECT_LT(pair.median, 0.25 * kDegree);
    EXPECT_NEAR(check.object_size, 0.17, 0.06);
  }
}

TEST(CalibrationCheck, NamesTheCamerasThatAreExchanged) {
  for (const std::size_t count : {3u, 4u}) {
    const CameraRig truth = ring(count);
    CameraRig rig = truth;
    std::swap(rig[0].camera_from_world, rig[2].camera_from_world);
    const auto suspicion = suspect(rig, seen(truth));
    ASSERT_TRUE(suspicion.has_value());
    EXPECT_EQ(suspicion->cameras, (std::vector<std::string>{"cam_0", "cam_2"}))
        << suspicion->message;
    EXPECT_NE(suspicion->message.find("exchanged"), std::string::npos) << suspicion->message;
  }
}

TEST(CalibrationCheck, NamesTheCameraWhosePicturesAreMirrored) {
  for (const int camera : {0, 1, 2}) {
    const CameraRig truth = ring(3);
    const auto suspicion = suspect(truth, seen(truth, camera));
    ASSERT_TRUE(suspicion.has_value());
    EXPECT_EQ(suspicion->cameras, (std::vector<std::string>{text("cam_", camera)}))
        << suspicion->message;
    EXPECT_NE(suspicion->message.find("left to right"), std::string::npos) << suspicion->message;
  }
}

TEST(CalibrationCheck, NamesTheCameraThatWasTurned) {
  for (const std::size_t count : {3u, 5u}) {
    const CameraRig truth = ring(count);
    const RigOutlines frames = seen(truth);
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0.6, -0.6, 0.5)}) {
      for (std::size_t c = 0; c < count; ++c) {
        const auto suspicion = suspect(turned(truth, c, 5.0 * kDegree * axis.normalized()), frames);
        ASSERT_TRUE(suspicion.has_value()) << count << " " << c << " " << axis.transpose();
        EXPECT_EQ(suspicion->cameras, (std::vector<std::string>{text("cam_", c)}))
            << axis.transpose() << ": " << suspicion->message;
      }
    }
  }
}

TEST(CalibrationCheck, NamesTheCameraWhosePoseIsMirrored) {
  const CameraRig truth = ring(3);
  for (std::size_t c = 0; c < 3; ++c) {
    CameraRig rig = truth;
    Rigid3d& pose = rig[c].camera_from_world;
    const Eigen::DiagonalMatrix<double, 3> mirror(1.0, -1.0, 1.0);
    const Eigen::Matrix3d rotation = mirror * pose.rotation.toRotationMatrix() * mirror;
    pose = {Eigen::Quaterniond(rotation), mirror * pose.translation};
    const auto suspicion = suspect(rig, seen(truth));
    ASSERT_TRUE(suspicion.has_value());
    EXPECT_EQ(suspicion->cameras, (std::vector<std::string>{text("cam_", c)}))
        << suspicion->message;
    EXPECT_NE(suspicion->message.find("mirrored in y"), std::string::npos) << suspicion->message;
  }
}

TEST(CalibrationCheck, OfTwoCamerasEitherMayBeToBlame) {
  const CameraRig truth = ring(2);
  const RigOutlines frames = seen(truth);
  for (std::size_t c = 0; c < 2; ++c) {
    for (const double sign : {-1.0, 1.0}) {
      const auto suspicion = suspect(turned(truth, c, {sign * 5.0 * kDegree, 0.0, 0.0}), frames);
      EXPECT_TRUE(blames(suspicion, text("cam_", c))) << (suspicion ? suspicion->message : "");
    }
  }
  const auto suspicion = suspect(turned(truth, 1, {5.0 * kDegree, 0.0, 0.0}), frames);
  EXPECT_TRUE(blames(suspicion, "cam_1"));
  CameraRig exchanged = truth;
  std::swap(exchanged[0].camera_from_world, exchanged[1].camera_from_world);
  const auto exchange = suspect(exchanged, frames);
  EXPECT_TRUE(blames(exchange, "cam_0"));
  EXPECT_TRUE(blames(exchange, "cam_1"));
  EXPECT_TRUE(blames(suspect(truth, seen(truth, 1)), "cam_1"));
}

TEST(CalibrationCheck, TwoTangentsProveNoTurn) {
  const CameraRig truth = ring(2);
  RigOutlines frames = seen(truth);
  const CameraRig rig = turned(truth, 1, {2.5 * kDegree, 0.0, 0.0});
  EXPECT_TRUE(blames(suspect(rig, frames), "cam_1"));
  frames.resize(1);
  ASSERT_EQ(pair_tangencies(rig, frames).front().count, 2u);
  const auto suspicion = suspect(rig, frames);
  EXPECT_FALSE(suspicion.has_value()) << (suspicion ? suspicion->message : "");
}

TEST(CalibrationCheck, TellsPosesThatAreInverse) {
  const CameraRig truth = ring(3);
  CameraRig inverse = truth;
  for (Camera& c : inverse) c.camera_from_world = c.camera_from_world.inverse();
  const auto suspicion = suspect(inverse, seen(truth));
  ASSERT_TRUE(suspicion.has_value());
  EXPECT_NE(suspicion->message.find("camera to world"), std::string::npos) << suspicion->message;
}

TEST(CalibrationCheck, MillimetresAreSaidNotFitted) {
  CameraRig rig = ring(3);
  for (Camera& c : rig) c.camera_from_world.translation *= 1000.0;
  std::vector<CalibrationProblem> problems = check_numbers(rig);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].severity, CalibrationProblem::Severity::error);
  EXPECT_NE(problems[0].message.find("metres_per_unit"), std::string::npos);
  // Squares of a chessboard, as the unit: the cameras could be in a hall, the hand could not.
  CameraRig squares = ring(3);
  for (Camera& c : squares) c.camera_from_world.translation /= 0.13;
  const CalibrationCheck check = check_calibration(squares, seen(ring(3)));
  ASSERT_EQ(check.problems.size(), 1u);
  EXPECT_NE(check.problems[0].message.find("size of a hand"), std::string::npos);
}

TEST(CalibrationCheck, IntrinsicsOfOtherPicturesAreDoubted) {
  CameraRig rig = ring(3);
  rig[1].cx = 640.0;
  rig[2].fx = rig[2].fy = 40.0;
  const std::vector<CalibrationProblem> problems = check_numbers(rig);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].cameras.front(), "cam_1");
  EXPECT_EQ(problems[1].cameras.front(), "cam_2");
}

TEST(HullCoverage, IsWholeWhereCamerasAgreeAndFallsWhereOneDoesNot) {
  const CameraRig truth = ring(3);
  const auto mean_coverage = [&](const CameraRig& rig) {
    double sum = 0.0;
    std::vector<HullView> views;
    for (std::size_t c = 0; c < rig.size(); ++c) {
      views.push_back({rig[c], render_silhouette(shape(3), truth[c])});
    }
    for (const double share : hull_coverage(views)) sum += share / 3.0;
    return sum;
  };
  EXPECT_GT(mean_coverage(truth), 0.95);
  EXPECT_LT(mean_coverage(turned(truth, 1, {5.0 * kDegree, 5.0 * kDegree, 0.0})), 0.8);
}

TEST(ConvexHull, LeavesOutWhatLiesOnItsSides) {
  const std::vector<Eigen::Vector2d> hull =
      convex_hull({{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 1}, {2, 2}});
  EXPECT_EQ(hull, (std::vector<Eigen::Vector2d>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

}  // namespace
}  // namespace tegata

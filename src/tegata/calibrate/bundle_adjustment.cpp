// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/bundle_adjustment.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr int kIntrinsics = 9;  // fx fy cx cy k1 k2 p1 p2 k3
constexpr int kPose = 6;        // rotation vector, translation
using Intrinsics = std::array<double, kIntrinsics>;
using Pose = std::array<double, kPose>;

struct Reprojection {
  Eigen::Vector3d point;
  Eigen::Vector2d pixel;

  template <typename T>
  static void transform(const T* pose, const T* in, T* out) {
    ceres::AngleAxisRotatePoint(pose, in, out);
    for (int i = 0; i < 3; ++i) out[i] += pose[3 + i];
  }

  template <typename T>
  bool operator()(const T* intrinsics, const T* camera_from_world, const T* world_from_board,
                  T* residual) const {
    const T in_board[3] = {T(point.x()), T(point.y()), T(point.z())};
    T in_world[3], in_camera[3];
    transform(world_from_board, in_board, in_world);
    transform(camera_from_world, in_world, in_camera);
    if (in_camera[2] <= T(1e-6)) return false;
    const T x = in_camera[0] / in_camera[2], y = in_camera[1] / in_camera[2];
    const T r2 = x * x + y * y;
    const T &k1 = intrinsics[4], &k2 = intrinsics[5], &p1 = intrinsics[6], &p2 = intrinsics[7],
            &k3 = intrinsics[8];
    const T radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const T u = x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x);
    const T v = y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y;
    residual[0] = intrinsics[0] * u + intrinsics[2] - pixel.x();
    residual[1] = intrinsics[1] * v + intrinsics[3] - pixel.y();
    return true;
  }
};

// What lenses are like, where the views say nothing: a board that only crosses the middle of the
// picture leaves the centre and the higher coefficients open. Residuals are in standard deviations,
// which count as one pixel each.
struct LensPrior {
  double width, height;

  template <typename T>
  bool operator()(const T* intrinsics, T* residual) const {
    constexpr double kCenter = 0.03;  // of the picture's width
    constexpr double kAspect = 0.005, kRadial = 0.3, kTangential = 0.003;
    residual[0] = (intrinsics[2] - 0.5 * (width - 1.0)) / (kCenter * width);
    residual[1] = (intrinsics[3] - 0.5 * (height - 1.0)) / (kCenter * width);
    residual[2] = (intrinsics[0] / intrinsics[1] - 1.0) / kAspect;
    residual[3] = intrinsics[4] / kRadial;
    residual[4] = intrinsics[5] / kRadial;
    residual[5] = intrinsics[6] / kTangential;
    residual[6] = intrinsics[7] / kTangential;
    residual[7] = intrinsics[8] / kRadial;
    return true;
  }
};

Pose pose_parameters(const Rigid3d& pose) {
  const Eigen::Vector3d turn = so3_log(pose.rotation.normalized());
  const Eigen::Vector3d& shift = pose.translation;
  return {turn.x(), turn.y(), turn.z(), shift.x(), shift.y(), shift.z()};
}

Rigid3d pose_of(const Pose& p) {
  return {so3_exp({p[0], p[1], p[2]}), Eigen::Vector3d(p[3], p[4], p[5])};
}

Intrinsics intrinsic_parameters(const Camera& c) {
  return {c.fx,
          c.fy,
          c.cx,
          c.cy,
          c.distortion[0],
          c.distortion[1],
          c.distortion[2],
          c.distortion[3],
          c.distortion[4]};
}

// The standard deviation of a lens's centre along its worse axis, by camera; 0 for other cameras
// than those.
std::vector<double> center_deviations(ceres::Problem& problem,
                                      const std::vector<Intrinsics>& intrinsics,
                                      const std::set<std::size_t>& cameras) {
  std::vector<std::pair<const double*, const double*>> blocks;
  for (const std::size_t c : cameras)
    blocks.emplace_back(intrinsics[c].data(), intrinsics[c].data());
  ceres::Covariance::Options settings;
  settings.num_threads = 1;
  ceres::Covariance covariance(settings);
  if (!covariance.Compute(blocks, &problem)) {
    throw Error("board calibration: the views leave the cameras undetermined");
  }
  std::vector<double> deviations(intrinsics.size(), 0.0);
  for (const std::size_t c : cameras) {
    Eigen::Matrix<double, kIntrinsics, kIntrinsics, Eigen::RowMajor> block;
    covariance.GetCovarianceBlock(intrinsics[c].data(), intrinsics[c].data(), block.data());
    const Eigen::Matrix2d center = block.block<2, 2>(2, 2);
    deviations[c] =
        std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(center, Eigen::EigenvaluesOnly)
                      .eigenvalues()
                      .maxCoeff());
  }
  return deviations;
}

}  // namespace

std::vector<double> adjust_bundle(CameraRig& rig, std::vector<Rigid3d>& world_from_board,
                                  const std::vector<BoardObservation>& observations,
                                  const BundleOptions& options) {
  std::vector<Intrinsics> intrinsics;
  std::vector<Pose> cameras, boards;
  for (const Camera& camera : rig) {
    intrinsics.push_back(intrinsic_parameters(camera));
    cameras.push_back(pose_parameters(camera.camera_from_world));
  }
  for (const Rigid3d& board : world_from_board) boards.push_back(pose_parameters(board));

  ceres::Problem problem;
  ceres::Solver::Options solver;
  solver.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  std::set<std::size_t> seen_cameras;
  for (const BoardObservation& o : observations) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<Reprojection, 2, kIntrinsics, kPose, kPose>(
            new Reprojection{o.point_in_board, o.pixel}),
        new ceres::CauchyLoss(options.loss_scale), intrinsics[o.camera].data(),
        cameras[o.camera].data(), boards[o.frame].data());
    solver.linear_solver_ordering->AddElementToGroup(boards[o.frame].data(), 0);
    seen_cameras.insert(o.camera);
  }
  for (const std::size_t c : seen_cameras) {
    solver.linear_solver_ordering->AddElementToGroup(intrinsics[c].data(), 1);
    solver.linear_solver_ordering->AddElementToGroup(cameras[c].data(), 1);
    if (c == 0) problem.SetParameterBlockConstant(cameras[c].data());
    if (!options.refine_intrinsics) {
      problem.SetParameterBlockConstant(intrinsics[c].data());
      continue;
    }
    const LensPrior prior{static_cast<double>(rig[c].width), static_cast<double>(rig[c].height)};
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<LensPrior, 8, kIntrinsics>(new LensPrior(prior)), nullptr,
        intrinsics[c].data());
  }
  solver.linear_solver_type = ceres::DENSE_SCHUR;
  solver.max_num_iterations = options.most_iterations;
  solver.num_threads = 1;
  solver.logging_type = ceres::SILENT;
  solver.function_tolerance = 1e-10;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  if (!summary.IsSolutionUsable()) {
    throw Error("board calibration: the bundle adjustment failed: ", summary.message);
  }
  for (std::size_t c = 0; c < rig.size(); ++c) {
    Camera& camera = rig[c];
    const Intrinsics& found = intrinsics[c];
    camera.fx = found[0];
    camera.fy = found[1];
    camera.cx = found[2];
    camera.cy = found[3];
    for (std::size_t k = 0; k < 5; ++k) camera.distortion[k] = found[4 + k];
    if (c != 0) camera.camera_from_world = pose_of(cameras[c]);
  }
  for (std::size_t f = 0; f < boards.size(); ++f) world_from_board[f] = pose_of(boards[f]);
  if (!options.refine_intrinsics) return std::vector<double>(rig.size(), 0.0);
  return center_deviations(problem, intrinsics, seen_cameras);
}

}  // namespace tegata

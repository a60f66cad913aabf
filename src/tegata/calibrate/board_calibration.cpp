// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/board_calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "tegata/base/error.h"
#include "tegata/calibrate/bundle_adjustment.h"
#include "tegata/calibrate/rig_start.h"

namespace tegata {
namespace {

// The cameras by name, so that the order in which they come does not matter.
struct Solution {
  CameraRig rig;
  std::vector<std::vector<BoardView>> views;  // by frame and camera; left out: empty
  std::vector<Rigid3d> world_from_board;
  std::vector<bool> frame_used;
};

double squared_error(const Camera& camera, const Rigid3d& camera_from_board,
                     const Eigen::Vector3d& point, const Eigen::Vector2d& pixel) {
  constexpr double kBehind = 1e6;
  const auto seen = project_camera_point(camera, camera_from_board * point);
  return seen ? (*seen - pixel).squaredNorm() : kBehind;
}

double view_rms(const Camera& camera, const Rigid3d& camera_from_board, const BoardView& view,
                const std::vector<Eigen::Vector3d>& board) {
  const std::vector<Eigen::Vector3d> points = points_of(view, board);
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += squared_error(camera, camera_from_board, points[i], view.pixels[i]);
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

std::vector<std::size_t> order_by_name(const std::vector<Camera>& cameras) {
  std::vector<std::size_t> order(cameras.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return cameras[a].name < cameras[b].name; });
  return order;
}

Solution sorted_by_name(const BoardRecording& recording, const std::vector<std::size_t>& order,
                        std::size_t fewest_points) {
  Solution solution;
  for (const std::size_t c : order) solution.rig.push_back(recording.cameras[c]);
  for (const auto& frame : recording.views) {
    solution.views.emplace_back();
    for (const std::size_t c : order) {
      const bool enough = frame[c].points.size() >= fewest_points;
      solution.views.back().push_back(enough ? frame[c] : BoardView{});
    }
  }
  return solution;
}

void start_cameras(Solution& solution, const std::vector<Eigen::Vector3d>& board,
                   const BoardCalibrationOptions& options) {
  for (std::size_t c = 0; c < solution.rig.size(); ++c) {
    std::vector<BoardView> views;
    for (const auto& frame : solution.views) {
      if (!frame[c].points.empty()) views.push_back(frame[c]);
    }
    if (views.size() < options.fewest_views) {
      throw Error("camera '", solution.rig[c].name, "': the board was found in ", views.size(),
                  " of ", solution.views.size(), " pictures, expected ", options.fewest_views,
                  " or more; is it the board that is described, and inverted or not?");
    }
    if (!options.known_intrinsics) start_intrinsics(solution.rig[c], views, board);
  }
}

// Poses of the cameras, and of the board by the camera whose view explains the others best.
void start_poses(Solution& solution, const std::vector<Eigen::Vector3d>& board) {
  CameraRig& rig = solution.rig;
  BoardPoses poses;
  for (auto& frame : solution.views) {
    poses.emplace_back(rig.size());
    for (std::size_t c = 0; c < rig.size(); ++c) {
      if (frame[c].points.empty()) continue;
      poses.back()[c] = start_pose(rig[c], frame[c], board);
      if (!poses.back()[c]) frame[c] = {};
    }
  }
  start_extrinsics(rig, poses);
  for (std::size_t f = 0; f < poses.size(); ++f) {
    double least = std::numeric_limits<double>::infinity();
    Rigid3d best;
    for (std::size_t c = 0; c < rig.size(); ++c) {
      if (!poses[f][c]) continue;
      const Rigid3d world_from_board = rig[c].camera_from_world.inverse() * *poses[f][c];
      double worst = 0.0;
      for (std::size_t other = 0; other < rig.size(); ++other) {
        if (!poses[f][other]) continue;
        worst += view_rms(rig[other], rig[other].camera_from_world * world_from_board,
                          solution.views[f][other], board);
      }
      if (worst < least) {
        least = worst;
        best = world_from_board;
      }
    }
    solution.world_from_board.push_back(best);
    solution.frame_used.push_back(std::isfinite(least));
  }
}

std::vector<double> adjust(Solution& solution, const std::vector<Eigen::Vector3d>& board,
                           const BoardCalibrationOptions& options, double loss_scale) {
  std::vector<BoardObservation> observations;
  for (std::size_t f = 0; f < solution.views.size(); ++f) {
    for (std::size_t c = 0; c < solution.rig.size(); ++c) {
      const BoardView& view = solution.views[f][c];
      const std::vector<Eigen::Vector3d> points = points_of(view, board);
      for (std::size_t i = 0; i < points.size(); ++i) {
        // A start behind the camera cannot be adjusted; such views are outliers.
        const Rigid3d pose = solution.rig[c].camera_from_world * solution.world_from_board[f];
        if ((pose * points[i]).z() <= 0.0) continue;
        observations.push_back({c, f, points[i], view.pixels[i]});
      }
    }
  }
  return adjust_bundle(solution.rig, solution.world_from_board, observations,
                       {loss_scale, !options.known_intrinsics});
}

// Leaves out views that are far worse than the usual one, and says which.
std::vector<OutlierView> leave_out(Solution& solution, const BoardRecording& recording,
                                   const std::vector<Eigen::Vector3d>& board) {
  constexpr double kTimes = 3.0, kLeast = 1.0;  // of the median; [px]
  struct Rms {
    std::size_t frame, camera;
    double rms;
  };
  std::vector<Rms> all;
  std::vector<double> sorted;
  for (std::size_t f = 0; f < solution.views.size(); ++f) {
    for (std::size_t c = 0; c < solution.rig.size(); ++c) {
      if (solution.views[f][c].points.empty()) continue;
      const Rigid3d pose = solution.rig[c].camera_from_world * solution.world_from_board[f];
      all.push_back({f, c, view_rms(solution.rig[c], pose, solution.views[f][c], board)});
      sorted.push_back(all.back().rms);
    }
  }
  if (all.empty()) return {};
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  std::vector<OutlierView> outliers;
  for (const Rms& one : all) {
    if (one.rms <= std::max(kLeast, kTimes * *middle)) continue;
    outliers.push_back({solution.rig[one.camera].name, recording.frame_names[one.frame], one.rms});
    solution.views[one.frame][one.camera] = {};
  }
  return outliers;
}

CameraResiduals residuals_of(const Solution& solution, std::size_t c,
                             const std::vector<Eigen::Vector3d>& board) {
  constexpr int kColumns = 8, kRows = 6;
  const Camera& camera = solution.rig[c];
  CameraResiduals residuals;
  std::set<int> cells;
  double sum = 0.0;
  for (std::size_t f = 0; f < solution.views.size(); ++f) {
    const BoardView& view = solution.views[f][c];
    if (view.points.empty()) continue;
    const Rigid3d pose = camera.camera_from_world * solution.world_from_board[f];
    const double rms = view_rms(camera, pose, view, board);
    sum += rms * rms * static_cast<double>(view.points.size());
    residuals.points += view.points.size();
    ++residuals.views;
    for (const Eigen::Vector2d& pixel : view.pixels) {
      const int x =
          std::clamp(static_cast<int>(pixel.x() * kColumns / camera.width), 0, kColumns - 1);
      const int y = std::clamp(static_cast<int>(pixel.y() * kRows / camera.height), 0, kRows - 1);
      cells.insert(y * kColumns + x);
    }
  }
  residuals.coverage = static_cast<double>(cells.size()) / (kColumns * kRows);
  residuals.rms =
      residuals.points == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(residuals.points));
  return residuals;
}

// The error of one point that would say as much as the real ones do: errors within a view go
// together, as its blur, its moment and the bend of its board are one [px].
double view_error(const CameraResiduals& residuals) {
  if (residuals.views == 0) return 0.0;
  const double along_an_axis = residuals.rms / std::sqrt(2.0);
  return along_an_axis *
         std::sqrt(static_cast<double>(residuals.points) / static_cast<double>(residuals.views));
}

void describe(const Solution& solution, const std::vector<Eigen::Vector3d>& board,
              const std::vector<double>& center_deviations, BoardCalibration& calibration) {
  double sum = 0.0, count = 0.0;
  for (std::size_t c = 0; c < solution.rig.size(); ++c) {
    CameraResiduals residuals = residuals_of(solution, c, board);
    const Camera& camera = solution.rig[c];
    residuals.direction_deviation =
        std::atan(view_error(residuals) * center_deviations[c] / std::min(camera.fx, camera.fy));
    calibration.cameras[solution.rig[c].name] = residuals;
    sum += residuals.rms * residuals.rms * static_cast<double>(residuals.points);
    count += static_cast<double>(residuals.points);
  }
  calibration.rms = std::sqrt(sum / count);
}

}  // namespace

BoardCalibration calibrate_rig(const BoardRecording& recording,
                               const BoardCalibrationOptions& options) {
  check_board(recording.board);
  if (recording.cameras.size() < 2) {
    throw Error("board calibration: got ", recording.cameras.size(),
                " cameras, expected 2 or more");
  }
  const std::vector<Eigen::Vector3d> board = board_points(recording.board);
  const std::vector<std::size_t> order = order_by_name(recording.cameras);
  Solution solution = sorted_by_name(recording, order, options.fewest_points);
  start_cameras(solution, board, options);
  start_poses(solution, board);
  constexpr double kFirstLoss = 3.0, kLoss = 1.0;  // [px]
  constexpr int kRounds = 3;  // of leaving out: bad views hide others while they pull
  adjust(solution, board, options, kFirstLoss);
  BoardCalibration calibration;
  std::vector<double> center_deviations;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<OutlierView> outliers = leave_out(solution, recording, board);
    if (round > 0 && outliers.empty()) break;
    calibration.outliers.insert(calibration.outliers.end(), outliers.begin(), outliers.end());
    center_deviations = adjust(solution, board, options, kLoss);
  }
  describe(solution, board, center_deviations, calibration);
  calibration.rig.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) calibration.rig[order[i]] = solution.rig[i];
  calibration.world_from_board = solution.world_from_board;
  calibration.frame_used = solution.frame_used;
  check_rig(calibration.rig);
  return calibration;
}

}  // namespace tegata

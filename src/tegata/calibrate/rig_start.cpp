// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/rig_start.h"

#include <algorithm>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "tegata/base/error.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

std::vector<cv::Point3f> to_cv(const std::vector<Eigen::Vector3d>& points) {
  std::vector<cv::Point3f> out;
  for (const Eigen::Vector3d& p : points) {
    out.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                     static_cast<float>(p.z()));
  }
  return out;
}

std::vector<cv::Point2f> to_cv(const std::vector<Eigen::Vector2d>& pixels) {
  std::vector<cv::Point2f> out;
  for (const Eigen::Vector2d& p : pixels) {
    out.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  }
  return out;
}

cv::Matx33d matrix_of(const Camera& c) { return {c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}; }

// How far two relative poses are apart: turn [rad] and shift, as a share of the distance.
double apart(const Rigid3d& a, const Rigid3d& b) {
  return a.rotation.angularDistance(b.rotation) +
         (a.translation - b.translation).norm() /
             std::max(1e-9, std::max(a.translation.norm(), b.translation.norm()));
}

// The one of some poses that has the least median distance to all.
Rigid3d middle_pose(const std::vector<Rigid3d>& poses) {
  double least = std::numeric_limits<double>::infinity();
  Rigid3d best = poses.front();
  for (const Rigid3d& pose : poses) {
    std::vector<double> distances;
    for (const Rigid3d& other : poses) distances.push_back(apart(pose, other));
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    if (*middle < least) {
      least = *middle;
      best = pose;
    }
  }
  return best;
}

// b_from_a, one for each frame that both see.
std::vector<Rigid3d> links(const BoardPoses& poses, std::size_t a, std::size_t b) {
  std::vector<Rigid3d> found;
  for (const auto& frame : poses) {
    if (frame[a] && frame[b]) found.push_back(*frame[b] * frame[a]->inverse());
  }
  return found;
}

}  // namespace

std::vector<Eigen::Vector3d> points_of(const BoardView& view,
                                       const std::vector<Eigen::Vector3d>& board) {
  std::vector<Eigen::Vector3d> points;
  for (const int i : view.points) points.push_back(board.at(static_cast<std::size_t>(i)));
  return points;
}

void start_intrinsics(Camera& camera, const std::vector<BoardView>& views,
                      const std::vector<Eigen::Vector3d>& board) {
  constexpr std::size_t kMostViews = 40;
  std::vector<std::vector<cv::Point3f>> points;
  std::vector<std::vector<cv::Point2f>> pixels;
  const std::size_t count = std::min(views.size(), kMostViews);
  for (std::size_t i = 0; i < count; ++i) {
    const BoardView& view = views[i * views.size() / count];
    points.push_back(to_cv(points_of(view, board)));
    pixels.push_back(to_cv(view.pixels));
  }
  const double guess = 1.0 * std::max(camera.width, camera.height);
  cv::Mat matrix = (cv::Mat_<double>(3, 3) << guess, 0, 0.5 * (camera.width - 1), 0, guess,
                    0.5 * (camera.height - 1), 0, 0, 1);
  cv::Mat distortion = cv::Mat::zeros(1, 5, CV_64F), turns, shifts;
  try {
    cv::calibrateCamera(
        points, pixels, {camera.width, camera.height}, matrix, distortion, turns, shifts,
        cv::CALIB_USE_INTRINSIC_GUESS | cv::CALIB_FIX_ASPECT_RATIO | cv::CALIB_ZERO_TANGENT_DIST |
            cv::CALIB_FIX_PRINCIPAL_POINT | cv::CALIB_FIX_K2 | cv::CALIB_FIX_K3);
  } catch (const cv::Exception& error) {
    throw Error("camera '", camera.name,
                "': its views of the board give no calibration: ", error.err);
  }
  camera.fx = matrix.at<double>(0, 0);
  camera.fy = matrix.at<double>(1, 1);
  camera.cx = matrix.at<double>(0, 2);
  camera.cy = matrix.at<double>(1, 2);
  camera.distortion = {distortion.at<double>(0), distortion.at<double>(1)};
}

std::optional<Rigid3d> start_pose(const Camera& camera, const BoardView& view,
                                  const std::vector<Eigen::Vector3d>& board) {
  const std::vector<cv::Point3f> points = to_cv(points_of(view, board));
  std::vector<Eigen::Vector2d> ideal;
  for (const Eigen::Vector2d& pixel : view.pixels) ideal.push_back(undistort_pixel(camera, pixel));
  cv::Mat turn, shift;
  try {
    if (!cv::solvePnP(points, to_cv(ideal), matrix_of(camera), cv::noArray(), turn, shift, false,
                      cv::SOLVEPNP_IPPE)) {
      return std::nullopt;
    }
    cv::solvePnPRefineLM(points, to_cv(ideal), matrix_of(camera), cv::noArray(), turn, shift);
  } catch (const cv::Exception&) {
    return std::nullopt;  // points on one line
  }
  const Rigid3d pose = {
      so3_exp({turn.at<double>(0), turn.at<double>(1), turn.at<double>(2)}),
      Eigen::Vector3d(shift.at<double>(0), shift.at<double>(1), shift.at<double>(2))};
  const bool finite = pose.translation.allFinite() && pose.rotation.coeffs().allFinite();
  return finite && pose.translation.z() > 0.0 ? std::optional(pose) : std::nullopt;
}

void start_extrinsics(CameraRig& rig, const BoardPoses& poses) {
  std::vector<bool> placed(rig.size(), false);
  placed[0] = true;
  rig[0].camera_from_world = {};
  for (std::size_t round = 1; round < rig.size(); ++round) {
    std::size_t from = 0, to = 0, most = 0;
    for (std::size_t a = 0; a < rig.size(); ++a) {
      for (std::size_t b = 0; b < rig.size(); ++b) {
        if (!placed[a] || placed[b]) continue;
        const std::size_t count = links(poses, a, b).size();
        if (count <= most) continue;
        from = a;
        to = b;
        most = count;
      }
    }
    if (most == 0) {
      std::string names;
      for (std::size_t c = 0; c < rig.size(); ++c) {
        if (!placed[c]) names += text(names.empty() ? "'" : ", '", rig[c].name, "'");
      }
      throw Error("board calibration: no moment shows the board to ", names,
                  " and to one of the other cameras: show it to neighbouring cameras at once");
    }
    rig[to].camera_from_world = middle_pose(links(poses, from, to)) * rig[from].camera_from_world;
    placed[to] = true;
  }
}

}  // namespace tegata

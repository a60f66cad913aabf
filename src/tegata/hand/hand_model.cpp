// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/hand_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/hand/posed_rows.h"
#include "tegata/hand/skin_rows.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

template <typename Count>
std::size_t index(Count i) {
  return static_cast<std::size_t>(i);
}

void check_links(const HandModel& model) {
  for (std::size_t vertex = 0; vertex < model.links.size(); ++vertex) {
    const SkinLinks& links = model.links[vertex];
    double sum = 0.0;
    for (std::size_t i = 0; i < links.bones.size(); ++i) {
      if (links.bones[i] < 0 || links.bones[i] >= kBoneCount) {
        throw Error("hand model '", model.name, "': vertex ", vertex, " is linked to bone ",
                    links.bones[i], ", expected 0 to ", kBoneCount - 1);
      }
      if (!(links.weights[i] >= 0.0)) {
        throw Error("hand model '", model.name, "': vertex ", vertex, " has link weight ",
                    links.weights[i], ", expected 0 or more");
      }
      sum += links.weights[i];
    }
    if (!(std::abs(sum - 1.0) < 1e-6)) {
      throw Error("hand model '", model.name, "': link weights of vertex ", vertex, " sum to ", sum,
                  ", expected 1");
    }
  }
}

void check_skeleton(const HandModel& model) {
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    if (!model.skeleton.keypoints[k].allFinite()) {
      throw Error("hand model '", model.name, "': keypoint ", keypoint_names()[k],
                  " is not finite");
    }
  }
  for (std::size_t a = 0; a < kAngleCount; ++a) {
    const double length = model.skeleton.axes[a].norm();
    if (!(std::abs(length - 1.0) < 1e-6)) {
      throw Error("hand model '", model.name, "': axis of ", angle_names()[a], " has length ",
                  length, ", expected 1");
    }
  }
  if (!model.rest_angles.allFinite()) {
    throw Error("hand model '", model.name, "': rest angles are not finite");
  }
}

}  // namespace

HandModel mirrored(const HandModel& model) {
  HandModel other = model;
  other.skeleton = mirrored(model.skeleton);
  for (Eigen::Vector3d& vertex : other.rest_surface.vertices) vertex.x() = -vertex.x();
  for (Eigen::Vector3d& normal : other.rest_surface.normals) normal.x() = -normal.x();
  for (Triangle& triangle : other.rest_surface.triangles) std::swap(triangle[1], triangle[2]);
  return other;
}

void check_hand(const HandModel& model) {
  const TriangleMesh& surface = model.rest_surface;
  if (surface.triangles.empty()) {
    throw Error("hand model '", model.name, "': the surface has no triangles");
  }
  check_mesh(surface);
  if (model.links.size() != surface.vertices.size()) {
    throw Error("hand model '", model.name, "': got links of ", model.links.size(),
                " vertices, expected ", surface.vertices.size());
  }
  if (surface.normals.size() != surface.vertices.size()) {
    throw Error("hand model '", model.name, "': got ", surface.normals.size(),
                " normals, expected ", surface.vertices.size());
  }
  for (std::size_t i = 0; i < surface.normals.size(); ++i) {
    if (!surface.normals[i].allFinite()) {
      throw Error("hand model '", model.name, "': normal of vertex ", i, " is not finite");
    }
  }
  check_links(model);
  check_skeleton(model);
}

int main_bone(const SkinLinks& links) {
  const auto most = std::max_element(links.weights.begin(), links.weights.end());
  return links.bones[index(most - links.weights.begin())];
}

std::array<Eigen::Vector3d, kKeypointCount> posed_keypoints(const Skeleton& skeleton,
                                                            const HandPose& pose) {
  const auto transforms = bone_transforms(skeleton, pose.angles);
  std::array<Eigen::Vector3d, kKeypointCount> points;
  for (int k = 0; k < kKeypointCount; ++k) {
    points[index(k)] = pose.world_from_hand *
                       (transforms[index(bone_of_keypoint(k))] * skeleton.keypoints[index(k)]);
  }
  return points;
}

HandPose advanced(const HandPose& pose, const Eigen::Matrix<double, kHandParameterCount, 1>& step) {
  HandPose next = pose;
  next.world_from_hand.rotation =
      (so3_exp(step.head<3>()) * pose.world_from_hand.rotation).normalized();
  next.world_from_hand.translation += step.segment<3>(3);
  next.angles += step.tail<kAngleCount>();
  return next;
}

namespace {

Eigen::Vector3d point_of_row(const RowPoints& points, std::size_t lane) {
  return {points[0][lane], points[1][lane], points[2][lane]};
}

std::shared_ptr<const PosedRows> posed_rows(const HandModel& model, const HandPose& pose,
                                            std::shared_ptr<const SkinRows> rows) {
  if (!rows) rows = std::make_shared<SkinRows>(model);
  auto posed = std::make_shared<PosedRows>(std::move(rows), model);
  posed->move_to(pose);
  return posed;
}

// The angles' columns of a vertex or its normal: each of its rows has those of one digit.
template <typename ColumnsOfBlock>
void add_angle_columns(const SkinRows& rows, std::size_t vertex, ColumnsOfBlock&& columns_of_block,
                       PointJacobian& jacobian) {
  const auto add_row = [&](std::size_t row) {
    const std::size_t part = rows.part_of_row(row);
    if (part == SkinRows::kPalmPart) return;
    const AngleColumns& columns = columns_of_block(row / kRowLanes);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      jacobian.col(kPoseParameterCount + static_cast<Eigen::Index>(4 * part + i)) =
          point_of_row(columns[i], row % kRowLanes);
    }
  };
  const SkinRows::SharedVertex* const shared = rows.shared(vertex);
  if (shared == nullptr) return add_row(rows.first_row(vertex));
  for (const std::uint32_t row : shared->rows) add_row(row);
}

}  // namespace

PosedHand::PosedHand(const HandModel& model, const HandPose& pose,
                     std::shared_ptr<const SkinRows> rows)
    : model_(&model),
      pose_(pose),
      rows_(posed_rows(model, pose, std::move(rows))),
      vertices_(model.rest_surface.vertices.size()),
      normals_(model.rest_surface.normals.size()),
      keypoints_(posed_keypoints(model.skeleton, pose)) {
  for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex) {
    const std::size_t row = rows_->rows().first_row(vertex);
    const PosedPoints& points = rows_->points(row / kRowLanes);
    vertices_[vertex] =
        point_of_row(points.position, row % kRowLanes) + pose.world_from_hand.translation;
    if (vertex < normals_.size()) {
      normals_[vertex] = point_of_row(points.normal, row % kRowLanes);
    }
  }
}

TriangleMesh PosedHand::surface() const {
  TriangleMesh mesh;
  mesh.vertices = vertices_;
  mesh.triangles = model_->rest_surface.triangles;
  mesh.normals = normals_;
  return mesh;
}

PointJacobian PosedHand::vertex_jacobian(std::size_t vertex) const {
  PointJacobian jacobian = PointJacobian::Zero();
  jacobian.leftCols<3>() = -cross_matrix(vertices_[vertex] - pose_.world_from_hand.translation);
  jacobian.middleCols<3>(3).setIdentity();
  add_angle_columns(
      rows_->rows(), vertex,
      [&](std::size_t block) -> const AngleColumns& { return rows_->columns(block); }, jacobian);
  return jacobian;
}

PointJacobian PosedHand::normal_jacobian(std::size_t vertex) const {
  PointJacobian jacobian = PointJacobian::Zero();
  jacobian.leftCols<3>() = -cross_matrix(normals_[vertex]);
  add_angle_columns(
      rows_->rows(), vertex, [&](std::size_t block) { return rows_->normal_columns(block); },
      jacobian);
  return jacobian;
}

PointJacobian PosedHand::keypoint_jacobian(int keypoint) const {
  const Eigen::Vector3d point = keypoints_[index(keypoint)] - pose_.world_from_hand.translation;
  PointJacobian jacobian = PointJacobian::Zero();
  jacobian.leftCols<3>() = -cross_matrix(point);
  jacobian.middleCols<3>(3).setIdentity();
  for (int angle = 0; angle < kAngleCount; ++angle) {
    if (!angle_moves_bone(angle, bone_of_keypoint(keypoint))) continue;
    const SkinMotion::Axis& axis = rows_->motion().digit(index(angle / 4)).axes[index(angle % 4)];
    const Eigen::Map<const Eigen::Vector3d> center(axis.center.data());
    const Eigen::Map<const Eigen::Vector3d> direction(axis.direction.data());
    jacobian.col(kPoseParameterCount + angle) = direction.cross(point - center);
  }
  return jacobian;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/hand_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tegata/base/error.h"
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

PosedHand::PosedHand(const HandModel& model, const HandPose& pose)
    : model_(&model), pose_(pose), keypoints_(posed_keypoints(model.skeleton, pose)) {
  const auto from_zero = bone_transforms(model.skeleton, pose.angles);
  const auto from_rest = bone_transforms(model.skeleton, model.rest_angles);
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const Rigid3d moved = pose.world_from_hand * from_zero[bone] * from_rest[bone].inverse();
    world_from_rest_[bone] << moved.rotation.toRotationMatrix(), moved.translation;
  }
  axes_in_world_ = joint_axes(model.skeleton, pose.angles);
  for (JointAxis& axis : axes_in_world_) {
    axis.center = pose.world_from_hand * axis.center;
    axis.direction = pose.world_from_hand.rotation * axis.direction;
  }
  const TriangleMesh& rest = model.rest_surface;
  vertices_.resize(rest.vertices.size());
  normals_.resize(rest.normals.size());
  for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex) {
    const SkinLinks& links = model.links[vertex];
    BoneMatrix blended = links.weights[0] * world_from_rest_[index(links.bones[0])];
    for (std::size_t i = 1; i < links.bones.size(); ++i) {
      if (links.weights[i] > 0.0) {
        blended += links.weights[i] * world_from_rest_[index(links.bones[i])];
      }
    }
    vertices_[vertex] = blended.leftCols<3>() * rest.vertices[vertex] + blended.col(3);
    if (vertex < normals_.size()) {
      normals_[vertex] = (blended.leftCols<3>() * rest.normals[vertex]).normalized();
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

PointJacobian PosedHand::rigid_jacobian(const Eigen::Vector3d& point_in_world) const {
  PointJacobian jacobian = PointJacobian::Zero();
  jacobian.leftCols<3>() = -cross_matrix(point_in_world - pose_.world_from_hand.translation);
  jacobian.middleCols<3>(3).setIdentity();
  return jacobian;
}

void PosedHand::add_angle_columns(int bone, double weight, const Eigen::Vector3d& point_in_world,
                                  PointJacobian& jacobian) const {
  if (bone == 0) return;
  // The angles that move a bone follow each other: from its digit's abduction to its own flexion.
  const int first = 4 * ((bone - 1) / 3), last = first + 1 + (bone - 1) % 3;
  for (int angle = first; angle <= last; ++angle) {
    const JointAxis& axis = axes_in_world_[index(angle)];
    jacobian.col(kPoseParameterCount + angle) +=
        weight * axis.direction.cross(point_in_world - axis.center);
  }
}

PointJacobian PosedHand::vertex_jacobian(std::size_t vertex) const {
  PointJacobian jacobian = rigid_jacobian(vertices_[vertex]);
  const SkinLinks& links = model_->links[vertex];
  const Eigen::Vector3d& rest = model_->rest_surface.vertices[vertex];
  for (std::size_t i = 0; i < links.bones.size(); ++i) {
    if (links.weights[i] <= 0.0) continue;
    const BoneMatrix& matrix = world_from_rest_[index(links.bones[i])];
    add_angle_columns(links.bones[i], links.weights[i], matrix.leftCols<3>() * rest + matrix.col(3),
                      jacobian);
  }
  return jacobian;
}

PointJacobian PosedHand::keypoint_jacobian(int keypoint) const {
  const Eigen::Vector3d& point = keypoints_[index(keypoint)];
  PointJacobian jacobian = rigid_jacobian(point);
  add_angle_columns(bone_of_keypoint(keypoint), 1.0, point, jacobian);
  return jacobian;
}

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/shaped_hand.h"

#include "tegata/base/error.h"
#include "tegata/hand/hand_solid.h"
#include "tegata/hand/skin_links.h"
#include "tegata/hull/marching_cubes.h"
#include "tegata/hull/octree.h"
#include "tegata/mesh/simplify.h"

namespace tegata {
namespace {

using DriverJacobian = Eigen::Matrix<double, 3, kShapeDriverCount>;

constexpr int kSmoothingRounds = 2;  // of links

std::size_t index(int i) { return static_cast<std::size_t>(i); }

TriangleMesh meshed(const HandSolid& solid, const BuiltInHandOptions& options) {
  FieldSource source;
  // The field is not steeper than 1, so half a cube's diagonal bounds it over the cube.
  source.classify = [&](const Eigen::AlignedBox3d& cube) {
    const double field = solid.field(cube.center());
    const double reach = 0.5 * cube.diagonal().norm() * (1.0 + 1e-6);
    if (field > reach) return Occupancy::inside;
    return field < -reach ? Occupancy::outside : Occupancy::mixed;
  };
  source.sample = [&](const Eigen::Vector3d& point, bool&) {
    return static_cast<float>(solid.field(point));
  };
  const TriangleMesh fine =
      extract_isosurface(build_octree(solid.box(), options.cell_size, source));
  return simplify(fine, options.triangle_count);
}

HandModel mean_hand(const BuiltInHandOptions& options) {
  const HandShape shape;
  HandModel model;
  model.name = "built-in";
  model.skeleton = right_skeleton(shape);
  model.rest_angles = meshing_angles();
  model.rest_surface = meshed(HandSolid(model.skeleton, model.rest_angles), options);
  const BoneSegments segments = bone_segments(model.skeleton, model.rest_angles,
                                              shape.forearm_length, 0.35 * shape.palm_breadth);
  model.links.reserve(model.rest_surface.vertices.size());
  for (const Eigen::Vector3d& vertex : model.rest_surface.vertices) {
    model.links.push_back(link_to_bones(segments, vertex));
  }
  smooth_palm_links(model.rest_surface, kSmoothingRounds, model.links);
  return model;
}

/// A joint in the palm: with the palm, but for the arch, which goes with the breadth.
DriverJacobian palm_joint_jacobian(int digit, const Eigen::Vector3d& joint) {
  DriverJacobian jacobian = DriverJacobian::Zero();
  jacobian(0, kPalmDrivers) = joint.x();
  jacobian(1, digit == 0 ? kPalmDrivers + 1 : kKnuckleDrivers + digit - 1) = joint.y();
  jacobian(2, kPalmDrivers) = joint.z();
  return jacobian;
}

DriverJacobian palm_jacobian(const Eigen::Vector3d& point) {
  DriverJacobian jacobian = DriverJacobian::Zero();
  jacobian(0, kPalmDrivers) = point.x();
  jacobian(1, point.y() > 0.0 ? kPalmDrivers + 1 : kForearmDriver) = point.y();
  jacobian(2, kPalmDrivers + 2) = point.z();
  return jacobian;
}

/// The mean right hand's joints at given angles and which way its bones lie there.
class DrivenSkeleton {
 public:
  DrivenSkeleton(const Skeleton& skeleton, const JointAngles& angles)
      : points_(posed_keypoints(skeleton, HandPose{{}, angles})) {
    keypoints_[0].setZero();
    for (int digit = 0; digit < kDigitCount; ++digit) {
      keypoints_[index(1 + 4 * digit)] = palm_joint_jacobian(digit, points_[index(1 + 4 * digit)]);
    }
    for (int bone = 1; bone < kBoneCount; ++bone) {
      const auto near = index(proximal_keypoint(bone)), far = near + 1;
      along_[index(bone)] = (points_[far] - points_[near]).normalized();
      lengths_[index(bone)] = (points_[far] - points_[near]).norm();
      keypoints_[far] = keypoints_[near];
      keypoints_[far].col(bone - 1) += along_[index(bone)];
    }
  }

  const std::array<DriverJacobian, kKeypointCount>& keypoints() const { return keypoints_; }

  /// Of a point that is fixed to a bone.
  DriverJacobian point_jacobian(int bone, const Eigen::Vector3d& point) const {
    if (bone == 0) return palm_jacobian(point);
    const auto near = index(proximal_keypoint(bone));
    const Eigen::Vector3d& along = along_[index(bone)];
    const Eigen::Vector3d offset = point - points_[near];
    const double axial = offset.dot(along);
    DriverJacobian jacobian = keypoints_[near];
    jacobian.col(bone - 1) += along * (axial / lengths_[index(bone)]);
    jacobian.col(kDigitDrivers + (bone - 1) / 3) += offset - axial * along;
    return jacobian;
  }

 private:
  std::array<Eigen::Vector3d, kKeypointCount> points_;
  std::array<DriverJacobian, kKeypointCount> keypoints_;
  std::array<Eigen::Vector3d, kBoneCount> along_;
  std::array<double, kBoneCount> lengths_ = {};
};

}  // namespace

ShapedHand::ShapedHand(Side side, const BuiltInHandOptions& options) : side_(side) {
  if (!(options.cell_size >= 0.0005 && options.cell_size <= 0.005)) {
    throw Error("built-in hand: cell_size is ", options.cell_size, " m, expected 0.0005 to 0.005");
  }
  mean_ = mean_hand(options);
  keypoints_ = DrivenSkeleton(mean_.skeleton, JointAngles::Zero()).keypoints();
  const DrivenSkeleton at_rest(mean_.skeleton, mean_.rest_angles);
  vertices_.reserve(mean_.links.size());
  for (std::size_t vertex = 0; vertex < mean_.links.size(); ++vertex) {
    const SkinLinks& links = mean_.links[vertex];
    DriverJacobian jacobian = DriverJacobian::Zero();
    for (std::size_t i = 0; i < links.bones.size(); ++i) {
      if (links.weights[i] <= 0.0) continue;
      jacobian += links.weights[i] *
                  at_rest.point_jacobian(links.bones[i], mean_.rest_surface.vertices[vertex]);
    }
    vertices_.push_back(jacobian);
  }
}

HandModel ShapedHand::model(const HandShape& shape) const {
  const ShapeDrivers change = drivers_of_shape(shape) - drivers_of_shape(HandShape());
  HandModel model = mean_;
  model.skeleton = right_skeleton(shape);
  for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex) {
    model.rest_surface.vertices[vertex] += vertices_[vertex] * change;
  }
  model.rest_surface.normals = vertex_normals(model.rest_surface);
  check_hand(model);
  return side_ == Side::right ? model : mirrored(model);
}

ShapeBasis ShapedHand::basis(const ShapeParameters& parameters) const {
  auto by_parameters = driver_jacobian(parameters);
  const auto of_point = [&](const DriverJacobian& by_drivers) {
    ShapeJacobian jacobian = by_drivers * by_parameters;
    if (side_ == Side::left) jacobian.row(0) *= -1.0;
    return jacobian;
  };
  ShapeBasis basis;
  basis.vertices.reserve(vertices_.size());
  for (const DriverJacobian& vertex : vertices_) basis.vertices.push_back(of_point(vertex));
  for (std::size_t k = 0; k < kKeypointCount; ++k) basis.keypoints[k] = of_point(keypoints_[k]);
  return basis;
}

namespace {

/// d keypoint / d shape at angles, in the hand's frame.
std::array<ShapeJacobian, kKeypointCount> keypoint_jacobians(
    const std::array<ShapeJacobian, kKeypointCount>& at_zero,
    const std::array<Rigid3d, kBoneCount>& transforms) {
  std::array<ShapeJacobian, kKeypointCount> jacobians = at_zero;
  for (int bone = 1; bone < kBoneCount; ++bone) {
    const auto near = index(proximal_keypoint(bone)), far = near + 1;
    jacobians[far] = jacobians[near] + transforms[index(bone)].rotation.toRotationMatrix() *
                                           (at_zero[far] - at_zero[near]);
  }
  return jacobians;
}

}  // namespace

// A bone takes a point of the rest surface to turn * (point - joint at rest) + joint in world, and
// turns do not depend on the shape.
PosedShape::PosedShape(const HandModel& model, const ShapeBasis& basis, const HandPose& pose)
    : model_(&model), basis_(&basis) {
  const auto from_zero = bone_transforms(model.skeleton, pose.angles);
  const auto rest_from_zero = bone_transforms(model.skeleton, model.rest_angles);
  const auto at_rest = keypoint_jacobians(basis.keypoints, rest_from_zero);
  keypoints_ = keypoint_jacobians(basis.keypoints, from_zero);
  const Eigen::Matrix3d world_from_hand = pose.world_from_hand.rotation.toRotationMatrix();
  for (ShapeJacobian& keypoint : keypoints_) keypoint = world_from_hand * keypoint;
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const auto joint = index(proximal_keypoint(bone));
    turns_[index(bone)] = world_from_hand * from_zero[index(bone)].rotation.toRotationMatrix() *
                          rest_from_zero[index(bone)].rotation.toRotationMatrix().transpose();
    shifts_[index(bone)] = keypoints_[joint] - turns_[index(bone)] * at_rest[joint];
  }
}

ShapeJacobian PosedShape::vertex_jacobian(std::size_t vertex) const {
  const SkinLinks& links = model_->links[vertex];
  ShapeJacobian jacobian = ShapeJacobian::Zero();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < links.bones.size(); ++i) {
    if (links.weights[i] <= 0.0) continue;
    turn += links.weights[i] * turns_[index(links.bones[i])];
    jacobian += links.weights[i] * shifts_[index(links.bones[i])];
  }
  jacobian += turn * basis_->vertices[vertex];
  return jacobian;
}

}  // namespace tegata

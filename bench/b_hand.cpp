// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "benchmarks.h"
#include "report.h"
#include "tegata/base/error.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/hand/posed_rows.h"
#include "tegata/math/so3.h"

namespace tegata::bench {
namespace {

constexpr double kMostMicroseconds = 60.0;  // for 1,500 vertices on a core with AVX2
constexpr double kMostDifference = 1e-12;   // [m], [m/rad]

// The hand vertex by vertex, as one writes it down with Eigen, with all 26 columns.
class PlainHand {
 public:
  explicit PlainHand(const HandModel& model)
      : model_(&model),
        vertices_(model.links.size()),
        normals_(model.links.size()),
        jacobians_(model.links.size()) {
    for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
      zero_from_rest_[bone] = bone_transforms(model.skeleton, model.rest_angles)[bone].inverse();
    }
  }

  void move_to(const HandPose& pose) {
    const auto from_zero = bone_transforms(model_->skeleton, pose.angles);
    for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
      const Rigid3d moved = pose.world_from_hand * from_zero[bone] * zero_from_rest_[bone];
      world_from_rest_[bone] << moved.rotation.toRotationMatrix(), moved.translation;
    }
    axes_ = joint_axes(model_->skeleton, pose.angles);
    for (JointAxis& axis : axes_) {
      axis.center = pose.world_from_hand * axis.center;
      axis.direction = pose.world_from_hand.rotation * axis.direction;
    }
    for (std::size_t v = 0; v < vertices_.size(); ++v) move_vertex(v, pose);
  }

  const std::vector<Eigen::Vector3d>& vertices() const { return vertices_; }
  const std::vector<Eigen::Vector3d>& normals() const { return normals_; }
  const std::vector<PointJacobian>& jacobians() const { return jacobians_; }

 private:
  using BoneMatrix = Eigen::Matrix<double, 3, 4>;

  void move_vertex(std::size_t v, const HandPose& pose) {
    const SkinLinks& links = model_->links[v];
    const Eigen::Vector3d& rest = model_->rest_surface.vertices[v];
    BoneMatrix blended = BoneMatrix::Zero();
    PointJacobian& jacobian = jacobians_[v];
    jacobian.setZero();
    for (std::size_t i = 0; i < links.bones.size(); ++i) {
      if (links.weights[i] <= 0.0) continue;
      const BoneMatrix& matrix = world_from_rest_[static_cast<std::size_t>(links.bones[i])];
      blended += links.weights[i] * matrix;
      if (links.bones[i] == 0) continue;
      const Eigen::Vector3d point = matrix.leftCols<3>() * rest + matrix.col(3);
      const int first = 4 * ((links.bones[i] - 1) / 3);
      for (int angle = first; angle < first + 4; ++angle) {
        if (!angle_moves_bone(angle, links.bones[i])) break;
        const JointAxis& axis = axes_[static_cast<std::size_t>(angle)];
        jacobian.col(kPoseParameterCount + angle) +=
            links.weights[i] * axis.direction.cross(point - axis.center);
      }
    }
    vertices_[v] = blended.leftCols<3>() * rest + blended.col(3);
    normals_[v] = (blended.leftCols<3>() * model_->rest_surface.normals[v]).normalized();
    jacobian.leftCols<3>() = -cross_matrix(vertices_[v] - pose.world_from_hand.translation);
    jacobian.middleCols<3>(3).setIdentity();
  }

  const HandModel* model_;
  std::array<Rigid3d, kBoneCount> zero_from_rest_;
  std::array<BoneMatrix, kBoneCount> world_from_rest_;
  std::array<JointAxis, kAngleCount> axes_;
  std::vector<Eigen::Vector3d> vertices_, normals_;
  std::vector<PointJacobian> jacobians_;
};

HandPose some_pose() {
  HandPose pose;
  pose.world_from_hand = {so3_exp({0.5, -0.3, 0.8}), {0.1, -0.2, 0.7}};
  pose.angles = (relaxed_angles().array() + 0.2).matrix();
  return pose;
}

double largest_difference(const PosedHand& ours, const PlainHand& plain) {
  double largest = 0.0;
  for (std::size_t v = 0; v < plain.vertices().size(); ++v) {
    largest = std::max({largest, (ours.vertices()[v] - plain.vertices()[v]).norm(),
                        (ours.normals()[v] - plain.normals()[v]).norm(),
                        (ours.vertex_jacobian(v) - plain.jacobians()[v]).cwiseAbs().maxCoeff()});
  }
  return largest;
}

std::size_t as_number(double value) { return std::bit_cast<std::size_t>(value); }

}  // namespace

bool benchmark_hand() {
  const HandModel model = built_in_hand({}, Side::right);
  const HandPose pose = some_pose();
  const auto rows = std::make_shared<const SkinRows>(model);
  const std::size_t digit_blocks = rows->parts()[kDigitCount - 1].last;
  PosedRows posed(rows, model);
  PlainHand plain(model);
  std::vector<PointJacobian> dense(model.links.size());

  const auto by = [&](InstructionSet set) {
    return Contestant{fmt::format("tegata PosedRows, {}", instruction_set_name(set)), [&, set] {
                        posed.move_to(pose, set);
                        return as_number(posed.columns(digit_blocks - 1)[3][0][0]);
                      }};
  };
  std::vector<Contestant> contestants;
  const bool has_avx2 = is_supported(InstructionSet::avx2);
  contestants.push_back(by(has_avx2 ? InstructionSet::avx2 : InstructionSet::baseline));
  if (has_avx2) contestants.push_back(by(InstructionSet::baseline));
  if (is_supported(InstructionSet::avx512)) contestants.push_back(by(InstructionSet::avx512));
  contestants.push_back({"tegata, with the normals' derivatives", [&] {
                           posed.move_to(pose);
                           double sum = 0.0;
                           for (std::size_t b = 0; b < digit_blocks; ++b) {
                             sum += posed.normal_columns(b)[0][0][0];
                           }
                           return as_number(sum);
                         }});
  contestants.push_back({"tegata PosedHand, 3 x 26 for each vertex", [&] {
                           const PosedHand hand(model, pose, rows);
                           for (std::size_t v = 0; v < dense.size(); ++v) {
                             dense[v] = hand.vertex_jacobian(v);
                           }
                           return as_number(dense.back()(0, 0));
                         }});
  contestants.push_back({"plain Eigen, 3 x 26 for each vertex", [&] {
                           plain.move_to(pose);
                           return as_number(plain.jacobians().back()(0, 0));
                         }});

  Report report(fmt::format("Hand: {} vertices and normals, derivatives by 26 parameters",
                            model.links.size()));
  const std::vector<Timing> timings = run_rounds(contestants);
  report.add("one pose", contestants, timings);
  const double difference = largest_difference(PosedHand(model, pose, rows), plain);
  report.check("as plain Eigen has it, to 1e-12", fmt::format("{:.1e}", difference),
               difference <= kMostDifference);
  const double microseconds =
      1e3 * timings.front().milliseconds * (1500.0 / static_cast<double>(model.links.size()));
  report.note(fmt::format("1,500 vertices on one core, {}: {:.1f} microseconds ({:g} to hold: {})",
                          has_avx2 ? "AVX2" : "without AVX2", microseconds, kMostMicroseconds,
                          microseconds <= kMostMicroseconds ? "held" : "not held"));
  return report.print();
}

}  // namespace tegata::bench

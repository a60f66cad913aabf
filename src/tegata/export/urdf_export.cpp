// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/urdf_export.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "tegata/base/error.h"
#include "tegata/export/bone_pieces.h"

namespace tegata {
namespace {

// What URDF asks for and pictures do not tell: high enough to stop no simulation.
constexpr double kEffort = 10.0;    // [N m]
constexpr double kVelocity = 20.0;  // [rad/s]

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::string xyz(const Eigen::Vector3d& vector) {
  return fmt::format("{} {} {}", decimal(vector.x(), 9), decimal(vector.y(), 9),
                     decimal(vector.z(), 9));
}

std::string inertial(const MassProperties& solid) {
  const Eigen::Matrix3d& inertia = solid.inertia;
  return fmt::format(
      "    <inertial>\n"
      "      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n"
      "      <mass value=\"{:.6e}\"/>\n"
      "      <inertia ixx=\"{:.6e}\" ixy=\"{:.6e}\" ixz=\"{:.6e}\" iyy=\"{:.6e}\" iyz=\"{:.6e}\" "
      "izz=\"{:.6e}\"/>\n"
      "    </inertial>\n",
      xyz(solid.center), solid.mass, inertia(0, 0), inertia(0, 1), inertia(0, 2), inertia(1, 1),
      inertia(1, 2), inertia(2, 2));
}

std::string shapes(std::string_view bone) {
  const std::string geometry =
      fmt::format("<geometry><mesh filename=\"meshes/{}.stl\"/></geometry>", bone);
  return fmt::format(
      "    <visual>{}<material name=\"skin\"/></visual>\n    <collision>{}</collision>\n", geometry,
      geometry);
}

std::string link(std::string_view name, const std::string& content) {
  return fmt::format("  <link name=\"{}\">\n{}  </link>\n", name, content);
}

std::string fixed_joint(std::string_view parent, std::string_view child,
                        const Eigen::Vector3d& place) {
  return fmt::format(
      "  <link name=\"{1}\"/>\n"
      "  <joint name=\"{1}_fixed\" type=\"fixed\">\n"
      "    <parent link=\"{0}\"/>\n    <child link=\"{1}\"/>\n"
      "    <origin xyz=\"{2}\" rpy=\"0 0 0\"/>\n  </joint>\n",
      parent, child, xyz(place));
}

/// A joint of one angle; `place` is that of the child's frame in the parent's.
std::string joint(const Skeleton& skeleton, int angle, std::string_view parent,
                  std::string_view child, const Eigen::Vector3d& place) {
  return fmt::format(
      "  <joint name=\"{}\" type=\"revolute\">\n"
      "    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n"
      "    <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n    <axis xyz=\"{}\"/>\n"
      "    <limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"{}\"/>\n  </joint>\n",
      angle_names()[index(angle)], parent, child, xyz(place), xyz(skeleton.axes[index(angle)]),
      decimal(angle_limits().lower[angle], 9), decimal(angle_limits().upper[angle], 9), kEffort,
      kVelocity);
}

/// The links and joints of a bone other than the palm.
std::string bone_block(const Skeleton& skeleton, int bone, const MassProperties& solid,
                       const std::string& shape, double density) {
  // A joint of two angles has a link between them, to which simulators want a mass: this share of
  // the bone's, as a ball about the joint.
  constexpr double kShareBetween = 0.01;
  const int near = proximal_keypoint(bone);
  const int above = parent_bone(bone);
  const std::string_view name = bone_names()[index(bone)];
  const std::string_view parent = bone_names()[index(above)];
  const Eigen::Vector3d place =
      skeleton.keypoints[index(near)] - skeleton.keypoints[index(proximal_keypoint(above))];
  const int digit = (bone - 1) / 3, within = (bone - 1) % 3;
  if (within > 0) {
    return link(name, inertial(solid) + shape) +
           joint(skeleton, 4 * digit + within + 1, parent, name, place);
  }
  MassProperties rest = solid;
  rest.mass *= 1.0 - kShareBetween;
  rest.inertia *= 1.0 - kShareBetween;
  const std::string_view between = keypoint_names()[index(near)];
  const MassProperties ball =
      ball_mass(Eigen::Vector3d::Zero(), kShareBetween * solid.mass, density);
  return link(between, inertial(ball)) + joint(skeleton, 4 * digit, parent, between, place) +
         link(name, inertial(rest) + shape) +
         joint(skeleton, 4 * digit + 1, between, name, Eigen::Vector3d::Zero());
}

/// A binary STL of a mesh whose vertices are moved by `shift`.
std::string stl(const TriangleMesh& mesh, const Eigen::Vector3d& shift) {
  std::string bytes = "tegata, metres";
  bytes.resize(80, ' ');
  const auto append = [&bytes](auto number) {
    static_assert(std::endian::native == std::endian::little);
    const auto raw = std::bit_cast<std::array<char, sizeof(number)>>(number);
    bytes.append(raw.data(), raw.size());
  };
  append(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.vertices[triangle[i]] + shift;
    const Eigen::Vector3d normal =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
    for (const Eigen::Vector3d& vector : {normal, corners[0], corners[1], corners[2]}) {
      for (int i = 0; i < 3; ++i) append(static_cast<float>(vector[i]));
    }
    append(std::uint16_t{0});
  }
  return bytes;
}

/// The piece's mass in the bone's frame; where the surface has hardly anything of a bone, that of a
/// small ball halfway along it.
MassProperties mass_of_bone(const Skeleton& skeleton, int bone, const TriangleMesh& piece,
                            double density) {
  constexpr double kLeastVolume = 1e-8;  // [m^3]
  const Eigen::Vector3d& near = skeleton.keypoints[index(proximal_keypoint(bone))];
  MassProperties solid = solid_mass(piece, density);
  if (!(solid.mass > kLeastVolume * density)) {
    const int end = bone == 0 ? 9 : distal_keypoint(bone);
    return ball_mass(0.5 * (skeleton.keypoints[index(end)] - near), kLeastVolume * density,
                     density);
  }
  solid.center -= near;
  return solid;
}

std::string joint_states(const Result& result) {
  constexpr std::size_t kPoseCells = 7;
  std::string table =
      "frame,time_s,wrist_x_m,wrist_y_m,wrist_z_m,wrist_qx,wrist_qy,wrist_qz,wrist_qw";
  for (const std::string_view name : angle_names()) table += fmt::format(",{}", name);
  table += "\n";
  for (const ResultFrame& frame : result.frames) {
    table += csv_cell(frame.name) + "," + decimal(frame.time, 6);
    if (frame.pose) {
      const Rigid3d& place = frame.pose->world_from_hand;
      for (int i = 0; i < 3; ++i) table += fmt::format(",{}", decimal(place.translation[i], 8));
      for (int i = 0; i < 4; ++i)
        table += fmt::format(",{}", decimal(place.rotation.coeffs()[i], 9));
      for (int i = 0; i < kAngleCount; ++i)
        table += fmt::format(",{}", decimal(frame.pose->angles[i], 8));
    } else {
      table += std::string(kPoseCells + kAngleCount, ',');
    }
    table += "\n";
  }
  return table;
}

}  // namespace

std::vector<ExportedFile> urdf_files(const Result& result, const HandModel& hand, double density) {
  if (!(density > 0.0)) {
    throw Error("density: got ", density, ", expected kilograms a cubic metre above 0");
  }
  const Skeleton& skeleton = hand.skeleton;
  std::vector<ExportedFile> files(1);
  std::string urdf = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<!-- Written by tegata: metres, radians, kilograms; {} kg/m^3. -->\n"
      "<robot name=\"tegata_{}_hand\">\n"
      "  <material name=\"skin\"><color rgba=\"0.80 0.60 0.50 1\"/></material>\n"
      "  <link name=\"wrist\"/>\n"
      "  <joint name=\"palm_fixed\" type=\"fixed\">\n"
      "    <parent link=\"wrist\"/>\n    <child link=\"palm\"/>\n"
      "    <origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>\n  </joint>\n",
      density, side_name(skeleton.side));
  const auto pieces = bone_pieces(hand);
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const TriangleMesh& piece = pieces[index(bone)];
    const std::string_view name = bone_names()[index(bone)];
    const Eigen::Vector3d& near = skeleton.keypoints[index(proximal_keypoint(bone))];
    const MassProperties solid = mass_of_bone(skeleton, bone, piece, density);
    const std::string shape = piece.triangles.empty() ? std::string() : shapes(name);
    urdf += bone == 0 ? link(name, inertial(solid) + shape)
                      : bone_block(skeleton, bone, solid, shape, density);
    if (!piece.triangles.empty()) {
      files.push_back({fmt::format("meshes/{}.stl", name), stl(piece, -near)});
    }
    if (bone > 0 && bone % 3 == 0) {
      const int tip = distal_keypoint(bone);
      urdf +=
          fixed_joint(name, keypoint_names()[index(tip)], skeleton.keypoints[index(tip)] - near);
    }
  }
  files.front() = {"hand.urdf", urdf + "</robot>\n"};
  files.push_back({"joint_states.csv", joint_states(result)});
  return files;
}

}  // namespace tegata

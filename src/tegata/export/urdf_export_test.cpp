// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/urdf_export.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "tegata/export/export_readers_for_tests.h"
#include "tegata/export/moving_result_for_tests.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

constexpr double kDensity = 1160.0;

std::map<std::string, std::string> exported(const Result& result, const HandModel& hand) {
  std::map<std::string, std::string> files;
  for (const ExportedFile& file : urdf_files(result, hand, kDensity))
    files[file.name] = file.content;
  return files;
}

const HandModel& urdf_hand() {
  static const HandModel hand =
      built_in_hand({}, Side::left, {.cell_size = 0.004, .triangle_count = 1500});
  return hand;
}

/// All values of an attribute.
std::vector<double> values_of(const std::string& urdf, const std::string& attribute) {
  std::vector<double> values;
  const std::regex pattern(attribute + "=\"([^\"]*)\"");
  for (std::sregex_iterator at(urdf.begin(), urdf.end(), pattern), end; at != end; ++at) {
    values.push_back(std::stod((*at)[1]));
  }
  return values;
}

TEST(UrdfExport, JointsPutTheLinksWhereTheResultHasTheKeypoints) {
  for (const Side side : {Side::right, Side::left}) {
    const HandModel hand = moving_hand(side);
    const Result result = moving_result(hand);
    const auto files = exported(result, hand);
    expect_keypoints(urdf_keypoints(files.at("hand.urdf"), files.at("joint_states.csv")), result);
  }
}

TEST(UrdfExport, JointsHaveNamesAndLimitsOfTheAngles) {
  const auto files = exported(moving_result(urdf_hand()), urdf_hand());
  std::size_t angle = 0;
  for (const UrdfJoint& joint : urdf_joints(files.at("hand.urdf"))) {
    if (joint.type == "fixed") continue;
    ASSERT_LT(angle, kAngleCount);
    EXPECT_EQ(joint.name, angle_names()[angle]);
    EXPECT_NEAR(joint.lower, angle_limits().lower[static_cast<int>(angle)], 1e-8);
    EXPECT_NEAR(joint.upper, angle_limits().upper[static_cast<int>(angle)], 1e-8);
    ++angle;
  }
  EXPECT_EQ(angle, kAngleCount);
}

TEST(UrdfExport, MassIsThatOfTheHandsVolume) {
  const auto files = exported(moving_result(urdf_hand()), urdf_hand());
  double mass = 0.0;
  for (const double part : values_of(files.at("hand.urdf"), "mass value")) {
    EXPECT_GT(part, 0.0);
    mass += part;
  }
  const double volume = enclosed_volume(urdf_hand().rest_surface);
  EXPECT_NEAR(mass, kDensity * volume, 1e-6);
  // No solid has a moment greater than the sum of the other two.
  const auto xx = values_of(files.at("hand.urdf"), "ixx"),
             yy = values_of(files.at("hand.urdf"), "iyy"),
             zz = values_of(files.at("hand.urdf"), "izz");
  ASSERT_EQ(xx.size(), 16U + 5U);
  for (std::size_t i = 0; i < xx.size(); ++i) {
    EXPECT_GT(std::min({xx[i], yy[i], zz[i]}), 0.0);
    EXPECT_LE(2.0 * std::max({xx[i], yy[i], zz[i]}), xx[i] + yy[i] + zz[i]);
  }
}

TEST(UrdfExport, EveryMeshIsThereAndIsAnStl) {
  const auto files = exported(moving_result(urdf_hand()), urdf_hand());
  const std::string& urdf = files.at("hand.urdf");
  const std::regex pattern("mesh filename=\"([^\"]*)\"");
  std::set<std::string> names;
  for (std::sregex_iterator at(urdf.begin(), urdf.end(), pattern), end; at != end; ++at) {
    names.insert((*at)[1]);
  }
  EXPECT_EQ(names.size(), 16U);
  for (const std::string& name : names) {
    const std::string& stl = files.at(name);
    std::uint32_t count = 0;
    ASSERT_GT(stl.size(), 84U);
    std::memcpy(&count, stl.data() + 80, sizeof(count));
    EXPECT_EQ(stl.size(), 84U + 50U * count) << name;
    EXPECT_FALSE(stl.starts_with("solid"));  // what readers take for the text format
  }
}

TEST(UrdfExport, MeshesLieInTheirLinks) {
  const auto files = exported(moving_result(urdf_hand()), urdf_hand());
  // The first bone of the index finger begins at its link's origin and goes along the finger.
  const std::string& stl = files.at("meshes/index_proximal.stl");
  Eigen::AlignedBox3f box;
  for (std::size_t at = 84; at < stl.size(); at += 50) {
    for (std::size_t corner = 1; corner < 4; ++corner) {
      Eigen::Vector3f vertex;
      std::memcpy(vertex.data(), stl.data() + at + 12 * corner, 12);
      box.extend(vertex);
    }
  }
  const double length = bone_length({}, 4);
  EXPECT_NEAR(box.min().y(), 0.0, 0.015);
  EXPECT_NEAR(box.max().y(), length, 0.015);
  EXPECT_LT(box.sizes().x(), 0.03F);
}

TEST(UrdfExport, DensityThatIsNoneIsRefused) {
  EXPECT_TRUE(says(error_of([] { urdf_files(moving_result(moving_hand()), moving_hand(), 0.0); }),
                   "density", "above 0"));
}

}  // namespace
}  // namespace tegata

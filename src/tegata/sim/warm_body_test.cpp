// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/warm_body.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tegata/sim/sim_test_hand.h"

namespace tegata {
namespace {

TEST(WarmBody, SkinIsWarmEverywhereAndFingertipsAreCooler) {
  const HandModel& hand = sim_test_hand();
  const std::vector<float> radiance = skin_radiance(hand, 3);
  ASSERT_EQ(radiance.size(), hand.rest_surface.vertices.size());
  EXPECT_GT(*std::min_element(radiance.begin(), radiance.end()), 0.52f);
  EXPECT_LT(*std::max_element(radiance.begin(), radiance.end()), 0.80f);
  double palm = 0.0, tips = 0.0;
  int palm_count = 0, tip_count = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const int bone = main_bone(hand.links[i]);
    if (bone == 0) palm += radiance[i], ++palm_count;
    if (bone > 0 && bone % 3 == 0) tips += radiance[i], ++tip_count;
  }
  EXPECT_LT(tips / tip_count, palm / palm_count - 0.01);
}

TEST(WarmBody, ForearmIsClosedAndReachesFromTheStumpOutwards) {
  const HandModel& hand = sim_test_hand();
  const Eigen::AlignedBox3d hand_box = bounding_box(hand.rest_surface);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const WarmSurface forearm = forearm_surface(hand, seed);
    const MeshTopology topology = inspect_topology(forearm.mesh);
    EXPECT_TRUE(topology.closed && topology.oriented);
    EXPECT_GT(enclosed_volume(forearm.mesh), 0.0002);
    EXPECT_EQ(forearm.radiance.size(), forearm.mesh.vertices.size());
    const Eigen::AlignedBox3d box = bounding_box(forearm.mesh);
    EXPECT_GT(box.max().y(), hand_box.min().y());  // no gap between the two
    EXPECT_LT(box.min().y(), -0.22);
    EXPECT_LT(box.max().y(), 0.01);  // and nothing of it among the fingers
  }
}

TEST(WarmBody, JoinedKeepsBothSurfacesAndTheirRadiance) {
  const WarmSurface forearm = forearm_surface(sim_test_hand(), 1);
  const WarmSurface lifted = moved({Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.5}}, forearm);
  const WarmSurface both = joined(forearm, lifted);
  check_mesh(both.mesh);
  EXPECT_EQ(both.radiance.size(), both.mesh.vertices.size());
  EXPECT_NEAR(enclosed_volume(both.mesh), 2.0 * enclosed_volume(forearm.mesh), 1e-9);
}

}  // namespace
}  // namespace tegata

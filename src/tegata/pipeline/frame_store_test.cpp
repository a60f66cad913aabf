// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/frame_store.h"

#include <gtest/gtest.h>

#include "tegata/base/parallel.h"
#include "tegata/base/random.h"
#include "tegata/pipeline/test_take.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

Silhouette random_silhouette(const Camera& camera, Random& random) {
  Silhouette silhouette(camera.width, camera.height);
  constexpr PixelLabel kLabels[] = {PixelLabel::background, PixelLabel::unknown, PixelLabel::hand};
  for (std::size_t i = 0; i < silhouette.pixel_count();) {
    const PixelLabel label = kLabels[static_cast<std::size_t>(2.999 * random.uniform())];
    const auto end = i + static_cast<std::size_t>(1.0 + 900.0 * random.uniform());
    for (; i < std::min(end, silhouette.pixel_count()); ++i) silhouette.values()[i] = label;
  }
  return silhouette;
}

// A frame of some of the cameras, with a mesh that differs from frame to frame.
PreparedFrame some_frame(std::size_t f) {
  Random random(f);
  PreparedFrame frame;
  frame.name = text("frame_", f);
  frame.time = 0.1 * static_cast<double>(f);
  frame.notes = {"a note"};
  frame.left_out["camera_9"] = "no reason";
  for (std::size_t c = f % 2; c < 3; ++c) {
    const Camera camera = test::small_rig()[c].undistorted();
    frame.frame.views.push_back(make_fit_view(camera, random_silhouette(camera, random)));
  }
  frame.hull.vertices.resize(30 + f);
  for (Eigen::Vector3d& v : frame.hull.vertices) {
    v = {random.uniform(), random.uniform(), random.uniform()};
    frame.hull.normals.push_back(v.normalized());
    frame.hull.unproven.push_back(v.x() < 0.3 ? 1 : 0);
  }
  frame.hull.triangles = {{0, 1, 2}, {2, 1, static_cast<std::uint32_t>(29 + f)}};
  frame.frame.hull.emplace(frame.hull);
  frame.segment_seconds = 3.0;
  return frame;
}

void expect_same(const PreparedFrame& restored, const PreparedFrame& original) {
  EXPECT_EQ(restored.name, original.name);
  EXPECT_EQ(restored.time, original.time);
  EXPECT_EQ(restored.notes, original.notes);
  EXPECT_EQ(restored.left_out, original.left_out);
  EXPECT_EQ(restored.segment_seconds, original.segment_seconds);
  EXPECT_EQ(restored.hull.vertices, original.hull.vertices);
  EXPECT_EQ(restored.hull.triangles, original.hull.triangles);
  EXPECT_EQ(restored.hull.normals, original.hull.normals);
  EXPECT_EQ(restored.hull.unproven, original.hull.unproven);
  ASSERT_EQ(restored.frame.hull.has_value(), original.frame.hull.has_value());
  if (original.frame.hull) {
    EXPECT_EQ(restored.frame.hull->unproven, original.frame.hull->unproven);
    EXPECT_EQ(restored.frame.hull->nearest.points(), original.frame.hull->nearest.points());
  }
  ASSERT_EQ(restored.frame.views.size(), original.frame.views.size());
  for (std::size_t v = 0; v < original.frame.views.size(); ++v) {
    const FitView &a = restored.frame.views[v], &b = original.frame.views[v];
    EXPECT_EQ(a.camera.name, b.camera.name);
    EXPECT_EQ(a.camera.fx, b.camera.fx);
    EXPECT_EQ(a.camera.camera_from_world.translation, b.camera.camera_from_world.translation);
    EXPECT_EQ(a.silhouette, b.silhouette);
    EXPECT_EQ(*a.hand_distance, *b.hand_distance);
    EXPECT_EQ(*a.possible_distance, *b.possible_distance);
    ASSERT_EQ(a.contour.size(), b.contour.size());
    for (std::size_t i = 0; i < a.contour.size(); ++i) {
      EXPECT_EQ(a.contour[i].pixel, b.contour[i].pixel);
    }
  }
}

TEST(FrameStore, RestoresEachFrameToTheLastPixelForAllThreadsAtOnce) {
  const TestFolder folder;
  for (const bool on_disk : {true, false}) {
    SCOPED_TRACE(on_disk ? "on disk" : "in memory");
    FrameStore store(on_disk ? folder.path() : std::filesystem::path());
    constexpr std::size_t kCount = 7;
    for (std::size_t f = 0; f < kCount; ++f) store.add(some_frame(f));
    std::vector<PreparedFrame> restored(kCount);
    parallel_for(kCount, 4, [&](std::size_t f) { restored[f] = store.restored(f); });
    for (std::size_t f = 0; f < kCount; ++f) expect_same(restored[f], some_frame(f));
    EXPECT_EQ(store.hull(5).vertices, some_frame(5).hull.vertices);
    ASSERT_EQ(store.views(5).size(), 2U);
    EXPECT_EQ(store.views(5)[1].camera.name, "camera_2");
    EXPECT_EQ(store.views(5)[1].silhouette, some_frame(5).frame.views[1].silhouette);
  }
}

TEST(FrameStore, ARefusedFrameIsRestoredWithoutAHull) {
  PreparedFrame refused;
  refused.name = "dark";
  refused.refusal = "hand found in 1 view";
  FrameStore store({});
  store.add(refused);
  expect_same(store.restored(0), refused);
  EXPECT_TRUE(store.views(0).empty());
}

TEST(FrameStore, RunsLongerThanANumberHoldsStayWhole) {
  Camera camera = test::small_rig()[0].undistorted();
  camera.width = 4100;
  camera.height = 4100;  // 16.8 million pixels, of which nearly all are alike
  PreparedFrame frame;
  frame.refusal = "not to be fitted";
  Silhouette silhouette(camera.width, camera.height, PixelLabel::unknown);
  silhouette.values().back() = PixelLabel::hand;
  frame.frame.views.emplace_back();
  frame.frame.views[0].camera = camera;
  frame.frame.views[0].silhouette = silhouette;
  FrameStore store({});
  store.add(std::move(frame));
  EXPECT_EQ(store.views(0)[0].silhouette, silhouette);
}

TEST(FrameStore, LeavesNothingOfAFrameInMemory) {
  const TestFolder folder;
  FrameStore store(folder.path());
  store.add(some_frame(1));
  EXPECT_EQ(store.brief(0).name, "frame_1");
  EXPECT_EQ(store.brief(0).frame.views.capacity(), 0U);
  EXPECT_EQ(store.brief(0).hull.vertices.capacity(), 0U);
  EXPECT_EQ(store.brief(0).hull.normals.capacity(), 0U);
  EXPECT_EQ(store.brief(0).hull.triangles.capacity(), 0U);
  EXPECT_FALSE(store.brief(0).frame.hull.has_value());
}

}  // namespace
}  // namespace tegata

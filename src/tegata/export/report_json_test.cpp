// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_json.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "tegata/export/test_result.h"
#include "tegata/hand/built_in_hand.h"

namespace tegata {
namespace {

using nlohmann::json;

const HandModel& coarse_hand() {
  static const HandModel hand =
      built_in_hand(HandShape{}, Side::right, {.cell_size = 0.005, .triangle_count = 300});
  return hand;
}

Camera camera_named(const std::string& name) {
  Camera camera;
  camera.name = name;
  camera.width = 64;
  camera.height = 48;
  camera.fx = camera.fy = 50.0;
  return camera;
}

template <typename T>
std::vector<T> unpacked(const std::string& text) {
  const auto value = [](char c) -> unsigned {
    const std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    return c == '=' ? 0u : static_cast<unsigned>(letters.find(c));
  };
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < text.size(); i += 4) {
    const unsigned group = value(text[i]) << 18 | value(text[i + 1]) << 12 |
                           value(text[i + 2]) << 6 | value(text[i + 3]);
    for (const unsigned shift : {16u, 8u, 0u}) {
      bytes.push_back(static_cast<std::uint8_t>(group >> shift & 255u));
    }
  }
  if (text.ends_with("==")) bytes.pop_back();
  if (text.ends_with("=")) bytes.pop_back();
  std::vector<T> numbers(bytes.size() / sizeof(T));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(T));
  return numbers;
}

TEST(ReportJson, BonesTakeTheRestSurfaceToThePosedOne) {
  const Result result = test_result(3);
  const json report = json::parse(report_json({result, coarse_hand(), {}, {}, {}}));
  const auto rest = unpacked<float>(report["hand_surface"]["vertices"]);
  const auto bones = unpacked<std::uint8_t>(report["hand_surface"]["bones"]);
  const auto weights = unpacked<float>(report["hand_surface"]["weights"]);
  const auto moves = unpacked<float>(report["frames"][1]["bones"]);
  ASSERT_EQ(rest.size(), 3 * coarse_hand().rest_surface.vertices.size());
  ASSERT_EQ(moves.size(), 7u * kBoneCount);
  const PosedHand posed(coarse_hand(), *result.frames[1].pose);
  for (std::size_t v = 0; v < posed.vertices().size(); ++v) {
    const Eigen::Vector3d from(rest[3 * v], rest[3 * v + 1], rest[3 * v + 2]);
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
      const float* m = &moves[7u * bones[i]];
      to += weights[i] *
            (Eigen::Quaterniond(m[0], m[1], m[2], m[3]) * from + Eigen::Vector3d(m[4], m[5], m[6]));
    }
    EXPECT_LT((to - posed.vertices()[v]).norm(), 1e-6) << v;
  }
}

TEST(ReportJson, FrameWithoutAPoseHasNoneAndSaysWhy) {
  const Result result = test_result(4);
  const json report = json::parse(report_json({result, coarse_hand(), {}, {}, {}}));
  const json& last = report["frames"][3];
  EXPECT_FALSE(last.contains("bones") || last.contains("angles") || last.contains("support"));
  EXPECT_EQ(last["doubts"][0], "seen by 1 camera < 2");
  EXPECT_EQ(report["verdict"]["worst"], 3);
  EXPECT_EQ(report["limits"].back(), "Made without the take: no cameras and no pictures.");
}

TEST(ReportJson, NamesCannotEndTheScriptThatTheyStandIn) {
  Result result = test_result(2);
  result.take = "</script><script>alert(1)</script> \xff";
  const std::string text = report_json({result, coarse_hand(), {}, {}, {}});
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(json::parse(text)["take"].get<std::string>().find("</script>"), 0u);
}

TEST(ReportJson, OutlinesAreRelativeToTheWindow) {
  const Result result = test_result(1);
  ReportPictures pictures;
  pictures.windows = {{10, 20, 40, 20}};
  pictures.pictures = {{0, 0, {1, 2, 3}, {{{9.5, 19.5}, {49.5, 39.5}, {29.5, -20.5}}}, {}}};
  const json report =
      json::parse(report_json({result, coarse_hand(), {camera_named("left")}, pictures, {}}));
  const json& picture = report["frames"][0]["pictures"][0];
  EXPECT_EQ(picture["jpeg"], "AQID");
  EXPECT_EQ(picture["silhouette"], "");
  const auto numbers = unpacked<std::uint16_t>(picture["hand"]);
  ASSERT_EQ(numbers.size(), 7u);
  EXPECT_EQ(numbers[0], 3);
  const auto place = [&numbers](std::size_t i) { return numbers[i] / 65535.0 * 17.0 - 8.0; };
  const double expected[] = {0.0, 0.0, 1.0, 1.0, 0.5, -2.0};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(place(i + 1), expected[i], 2e-4) << i;
}

TEST(ReportJson, HullComesBackWithinItsSteps) {
  const Result result = test_result(2);
  TriangleMesh hull;
  hull.vertices = {{0.1, -0.2, 0.5}, {0.3, -0.2, 0.5}, {0.2, 0.1, 0.5}};
  hull.triangles = {{0, 1, 2}};
  const json report = json::parse(report_json({result, coarse_hand(), {}, {}, {{"frame0", hull}}}));
  EXPECT_FALSE(report["frames"][1].contains("hull"));
  const json& written = report["frames"][0]["hull"];
  const auto vertices = unpacked<std::uint16_t>(written["vertices"]);
  const auto triangles = unpacked<std::uint16_t>(written["triangles"]);
  EXPECT_EQ(triangles, (std::vector<std::uint16_t>{0, 1, 2}));
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double low = written["low"][i], high = written["high"][i];
      EXPECT_NEAR(low + vertices[3 * v + i] / 65535.0 * (high - low),
                  hull.vertices[v][static_cast<int>(i)], 1e-5);
    }
  }
}

TEST(ReportJson, FineHandsAndLongTakesAreMadeCoarserAndItIsSaid) {
  const Result result = test_result(700);
  HandModel fine =
      built_in_hand(HandShape{}, Side::right, {.cell_size = 0.002, .triangle_count = 14000});
  ASSERT_GT(fine.rest_surface.triangles.size(), 12'100u);
  std::map<std::string, TriangleMesh> hulls;
  std::vector<std::string> names;
  for (const ResultFrame& frame : result.frames) {
    names.push_back(frame.name);
    hulls[frame.name] = report_hull(coarse_hand().rest_surface, result.frames.size());
  }
  const json report = json::parse(report_json({result, fine, {}, {}, hulls}));
  EXPECT_LT(unpacked<std::uint32_t>(report["hand_surface"]["triangles"]).size(), 3u * 12'100u);
  EXPECT_TRUE(report["frames"][3].contains("hull"));
  EXPECT_FALSE(report["frames"][4].contains("hull"));
  EXPECT_EQ(report["limits"].size(), 3u) << report["limits"];
  const std::set<std::string> wanted = frames_with_hull(names);
  std::erase_if(hulls, [&](const auto& hull) { return !wanted.contains(hull.first); });
  EXPECT_LE(hulls.size(), 300u);
  EXPECT_EQ(json::parse(report_json({result, fine, {}, {}, hulls})), report)
      << "no other hull is needed";
}

}  // namespace
}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Hands of other sizes, from the outside: `tegata hand personalise` and `tegata fit --scale`.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "run_program.h"
#include "tegata/hand/shape_parameters.h"
#include "tegata/take/hand_shape_file.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

constexpr double kLength = 0.168;  // of the hand in the take; the mean adult's is 0.189 [m]

class SmallHand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  static ProgramRun run(const std::vector<std::string>& arguments) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run;
  }
  static nlohmann::json json_of(const ProgramRun& run) { return nlohmann::json::parse(run.out); }

  template <typename... Parts>
  void expect_refused(const std::vector<std::string>& arguments, const Parts&... parts) const {
    const std::vector<std::string> before = names_in(folder_.path());
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 1);
    ASSERT_EQ(run.error_lines().size(), 1U) << run.err;
    EXPECT_TRUE(says(run.error_lines().front(), "tegata: error: ", parts...));
    EXPECT_EQ(names_in(folder_.path()), before);
  }

  /// A take of masks of a hand of kLength, slender.
  void make_take(const std::string& name, const std::string& frames) const {
    write_text(folder_ / "small.toml",
               "format = \"tegata-hand-shape\"\nversion = 1\nhand = \"right\"\n[shape]\nlength = " +
                   std::to_string(kLength) + "\npalm_breadth = 0.96\nfinger_thickness = 0.95\n");
    run({"simulate", path(name), "--hand", path("small.toml"), "--mode", "clean", "--frames",
         frames, "--size", "320x240", "--quiet"});
  }

  double surface_error(const std::string& result) const {
    return json_of(run({"evaluate", path(result), "--truth", path("take"), "--json"}))
        .at("mean")
        .at("surface_error_mm")
        .get<double>();
  }

  TestFolder folder_;
};

TEST_F(SmallHand, IsPersonalisedFromATakeAndFitsBetter) {
  make_take("take", "3");
  const ProgramRun found =
      run({"hand", "personalise", path("take"), "-o", path("anna.toml"), "--quiet", "--json"});
  const nlohmann::json json = json_of(found);
  EXPECT_EQ(json.at("name"), "anna");
  EXPECT_EQ(json.at("frames"), 3);
  ASSERT_EQ(json.at("shape").size(), static_cast<std::size_t>(kShapeParameterCount));
  const nlohmann::json& length = json.at("shape").at("length");
  EXPECT_NEAR(length.at("value").get<double>(), kLength, 0.005);
  EXPECT_LT(length.at("standard_deviation").get<double>(), 0.006);
  const HandShapeFile file = read_hand_shape(folder_ / "anna.toml");
  EXPECT_EQ(file.parameters[0], length.at("value").get<double>());
  ASSERT_TRUE(file.standard_deviations.has_value());

  const std::vector<std::string> fit = {"fit", path("take"), "--quiet", "--no-report"};
  const auto fitted = [&](const std::string& result, std::vector<std::string> more) {
    std::vector<std::string> arguments = fit;
    arguments.insert(arguments.end(), {"-o", path(result)});
    arguments.insert(arguments.end(), more.begin(), more.end());
    run(arguments);
    return surface_error(result);
  };
  const double mean_hand = fitted("mean", {});
  const double own_hand = fitted("own", {"--hand", path("anna.toml")});
  const double right_size = fitted("scaled", {"--scale", "auto"});
  EXPECT_LT(own_hand, 1.0);
  EXPECT_LT(own_hand, 0.5 * mean_hand);
  EXPECT_LT(right_size, 0.8 * mean_hand);
  const Result scaled = read_result_json(folder_ / "scaled" / "result.json");
  EXPECT_NEAR(scaled.model_scale, kLength / 0.189, 0.03);
  EXPECT_TRUE(scaled.model_scale_standard_deviation.has_value());
  EXPECT_EQ(read_result_json(folder_ / "own" / "result.json").model_name, "anna");
  run({"picture", path("scaled"), "--take", path("take"), "-o", path("p.png"), "--quiet"});
}

TEST_F(SmallHand, IsWrittenAsASkinnedHandWithATableOfItsSizes) {
  make_take("take", "2");
  const ProgramRun found =
      run({"hand", "personalise", path("take"), "-o", path("anna.glb"), "--name", "Anna"});
  for (const char* part : {"parameter", "length [mm]", "little_distal_length", "anna.glb"}) {
    EXPECT_NE(found.out.find(part), std::string::npos) << part;
  }
  const nlohmann::json info = json_of(run({"hand", "info", path("anna.glb"), "--json"}));
  EXPECT_NEAR(info.at("length").get<double>(), kLength, 0.006);
}

TEST_F(SmallHand, AFactorScalesAnyHand) {
  make_take("take", "1");
  run({"fit", path("take"), "-o", path("result"), "--scale", "0.9", "--quiet", "--no-report"});
  const Result result = read_result_json(folder_ / "result" / "result.json");
  EXPECT_EQ(result.model_scale, 0.9);
  EXPECT_FALSE(result.model_scale_standard_deviation.has_value());
  const nlohmann::json info =
      json_of(run({"hand", "info", (folder_ / "result" / "hand.glb").string(), "--json"}));
  EXPECT_NEAR(info.at("length").get<double>(), 0.9 * 0.189, 1e-3);
}

TEST_F(SmallHand, InAWorldTenTimesAsLargeHasTheSameAngles) {
  make_take("take", "2");
  const auto angles = [&](const std::string& result, const std::string& scale) {
    run({"fit", path("take"), "-o", path(result), "--scale", scale, "--quiet", "--no-report"});
    return read_result_json(folder_ / result / "result.json").grasp_angles;
  };
  write_text(folder_ / "take/take.toml", "hand = \"right\"\n");  // no landmarks, which are metres
  const JointAngles here = angles("here", "0.9");
  write_text(folder_ / "take/take.toml", "hand = \"right\"\nmetres_per_unit = 10.0\n");
  EXPECT_LT((angles("there", "9") - here).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(SmallHand, BadInputIsOneError) {
  make_take("take", "1");
  const std::string take = path("take");
  expect_refused({"hand", "personalise", take, "-o", path("hand.ply")}, "hand.ply", ".toml");
  expect_refused({"hand", "personalise", path("absent"), "-o", path("x.toml")}, "absent");
  expect_refused({"hand", "personalise", take, "-o", path("absent/x.toml"), "--quiet"},
                 "absent/x.toml");
  expect_refused({"hand", "personalise", take, "--side", "left", "-o", path("x.toml")}, "left",
                 "right");
  write_text(
      folder_ / "giant.toml",
      "format = \"tegata-hand-shape\"\nversion = 1\nhand = \"right\"\n[shape]\nlength = 1\n");
  expect_refused({"hand", "info", path("giant.toml")}, "giant.toml", "length");
  expect_refused({"hand", "info", path("small.toml"), "--side", "left"}, "small.toml", "--mirror");
  EXPECT_EQ(run_program({"fit", take, "-o", path("x"), "--scale", "big"}).exit_code, 2);
  EXPECT_EQ(run_program({"fit", take, "-o", path("x"), "--scale", "0"}).exit_code, 2);
  EXPECT_EQ(run_program({"hand", "personalise", take}).exit_code, 2);
  EXPECT_EQ(run_program({"hand", "personalise", "-o", path("x.toml")}).exit_code, 2);
}

TEST_F(SmallHand, TakesOfBothHandsAreRefused) {
  run({"simulate", path("right"), "--mode", "clean", "--frames", "1", "--size", "160x120",
       "--quiet"});
  run({"simulate", path("left"), "--hand", "left", "--mode", "clean", "--frames", "1", "--size",
       "160x120", "--quiet"});
  expect_refused({"hand", "personalise", path("right"), path("left"), "-o", path("x.toml")},
                 path("left"), "right");
}

}  // namespace
}  // namespace tegata

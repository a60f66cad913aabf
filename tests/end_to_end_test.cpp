// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes of the virtual room through the whole program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "run_program.h"
#include "tegata/evaluate/evaluation.h"
#include "tegata/export/viewer_page.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/video_file.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class EndToEnd : public testing::Test {
 protected:
  fs::path take() const { return folder_ / "take"; }
  fs::path result() const { return folder_ / "result"; }

  void simulate(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"simulate", take().string(), "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = run_program(arguments);
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  ProgramRun fit(const fs::path& to, const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"fit", take().string(), "-o", to.string(), "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run;
  }

  Evaluation evaluate(const fs::path& fitted) const { return evaluate_result(fitted, take(), 0); }

  TestFolder folder_;
};

// A small take of masks, for what does not depend on how hard a take is.
const std::vector<std::string> kSmallTake = {"--mode", "mask",   "--frames",
                                             "3",      "--size", "320x240"};

TEST_F(EndToEnd, InfraredCylinderIsFoundWithinFiveMillimetres) {
  simulate({"--grasp", "cylinder", "--cameras", "3", "--frames", "10", "--seed", "1", "--mode",
            "infrared", "--hand", "right"});
  fit(result(), {"--no-report"});
  const Evaluation evaluation = evaluate(result());
  EXPECT_EQ(evaluation.fitted_count, 10u);
  EXPECT_LE(evaluation.mean.surface_error_mm, 5.0);
}

TEST_F(EndToEnd, HullsCoverTheirSilhouettesFromThreeAndFromEightSides) {
  for (const std::string cameras : {"3", "8"}) {
    const fs::path hulls = folder_ / ("hulls" + cameras);
    simulate({"--mode", "clean", "--cameras", cameras, "--frames", "2", "--force"});
    const ProgramRun run = run_program(
        {"hull", take().string(), "-o", hulls.string(), "--voxel-mm", "1", "--quiet", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const json printed = json::parse(run.out);
    EXPECT_EQ(printed, json::parse(read_text(hulls / "hulls.json")));
    ASSERT_EQ(printed["frames"].size(), 2u);
    for (const json& frame : printed["frames"]) {
      EXPECT_EQ(frame["silhouette_iou"].size(), std::stoul(cameras));
      for (const json& overlap : frame["silhouette_iou"]) EXPECT_GE(overlap, 0.99) << frame;
      const TriangleMesh mesh = read_ply(hulls / frame["file"]);
      EXPECT_EQ(mesh.triangles.size(), frame["triangles"]);
      EXPECT_NEAR(1e6 * enclosed_volume(mesh), frame["volume_cm3"], 0.1);
      const MeshTopology topology = inspect_topology(mesh);
      EXPECT_TRUE(topology.closed && topology.oriented && topology.manifold);
    }
  }
}

TEST_F(EndToEnd, AFrameWithoutAHullIsSaidAndTheOthersAreMade) {
  simulate(kSmallTake);
  const fs::path mask = take() / "masks" / "camera_1" / "000001.png";
  CameraImage empty = read_picture(mask);
  for (std::uint16_t& value : empty.values.values()) value = 0;
  for (const char* camera : {"camera_1", "camera_2"}) {
    write_picture(empty, take() / "masks" / camera / "000001.png");
  }
  const fs::path hulls = folder_ / "hulls";
  const ProgramRun run = run_program({"hull", take().string(), "-o", hulls.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("hand found in 1 view"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("2 of 3 hulls"), std::string::npos) << run.out;
  EXPECT_EQ(names_in(hulls), (std::vector<std::string>{"000000.ply", "000002.ply", "hulls.json"}));
}

TEST_F(EndToEnd, LeftHandWithASphereSeenByFiveCamerasIsFound) {
  simulate({"--grasp", "sphere", "--cameras", "5", "--frames", "4", "--seed", "3", "--mode", "mask",
            "--hand", "left"});
  fit(result(), {"--no-report"});
  const Evaluation evaluation = evaluate(result());
  EXPECT_EQ(evaluation.fitted_count, 4u);
  EXPECT_LE(evaluation.mean.surface_error_mm, 3.0);
  EXPECT_EQ(read_result_json(result() / "result.json").side, Side::left);
}

TEST_F(EndToEnd, ALeftHandIsToldFromARightOneWhereTheTakeDoesNotSay) {
  simulate({"--mode", "mask", "--frames", "3", "--size", "320x240", "--hand", "left"});
  std::string info = read_text(take() / "take.toml");
  const std::string line = "hand = \"left\"\n";
  ASSERT_NE(info.find(line), std::string::npos);
  write_text(take() / "take.toml", info.erase(info.find(line), line.size()));
  const ProgramRun run =
      run_program({"fit", take().string(), "-o", result().string(), "--track", "--no-report"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("the left one, as the other fits"), std::string::npos) << run.err;
  EXPECT_EQ(read_result_json(result() / "result.json").side, Side::left);
}

TEST_F(EndToEnd, AHandThatWasLostOnTheWayIsSaidAndFoundAgain) {
  simulate({"--mode", "mask", "--frames", "8", "--turn-deg", "3", "--size", "320x240"});
  for (const char* camera : {"camera_0", "camera_1", "camera_2"}) {
    const fs::path mask = take() / "masks" / camera / "000004.png";
    CameraImage ball = read_picture(mask);
    for (int y = 0; y < ball.values.height(); ++y) {
      for (int x = 0; x < ball.values.width(); ++x) {
        const bool is_ball =
            std::hypot(x - 0.5 * ball.values.width(), y - 0.5 * ball.values.height()) < 12.0;
        ball.values(x, y) = is_ball ? 255 : 0;
      }
    }
    write_picture(ball, mask);
  }
  const ProgramRun run =
      run_program({"fit", take().string(), "-o", result().string(), "--track", "--no-report"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("frame 000004: no hand found"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("frame 000005: the hand was lost and is found again"), std::string::npos)
      << run.err;
  const Result tracked = read_result_json(result() / "result.json");
  ASSERT_EQ(tracked.frames.size(), 8u);
  EXPECT_FALSE(tracked.frames[4].pose);
  EXPECT_EQ(tracked.frames[4].status, "the hand is lost");
  const Evaluation evaluation = evaluate(result());
  EXPECT_EQ(evaluation.fitted_count, 7u);
  EXPECT_LE(evaluation.mean.surface_error_mm, 2.0);
}

TEST_F(EndToEnd, ACameraThatShowsAnotherMomentIsLeftOutAndNamed) {
  simulate({"--cameras", "4", "--frames", "4", "--size", "320x240", "--mode", "clean"});
  const fs::path masks = take() / "masks/camera_1";
  fs::copy_file(masks / "000000.png", masks / "000002.png", fs::copy_options::overwrite_existing);
  const ProgramRun run = fit(result(), {"--no-report"});
  const Result fitted = read_result_json(result() / "result.json");
  for (const std::size_t f : {0u, 1u, 2u, 3u}) {
    EXPECT_EQ(fitted.frames[f].left_out.count("camera_1"), f == 2 ? 1u : 0u) << f;
    EXPECT_EQ(fitted.frames[f].views.size(), f == 2 ? 3u : 4u) << f;
  }
  EXPECT_LE(evaluate(result()).worst.keypoint_error_mm, 2.0);
}

TEST_F(EndToEnd, ASoftGraspLetsFramesDepartALittle) {
  simulate(kSmallTake);
  fit(result(), {"--grasp", "soft", "--no-report"});
  const Result soft = read_result_json(result() / "result.json");
  double largest = 0.0;
  for (const ResultFrame& frame : soft.frames) {
    ASSERT_TRUE(frame.pose);
    largest = std::max(largest, (frame.pose->angles - soft.grasp_angles).cwiseAbs().maxCoeff());
  }
  EXPECT_GT(largest, 1e-4);
  EXPECT_LT(largest, 0.35);
  EXPECT_LE(evaluate(result()).mean.surface_error_mm, 2.0);
}

TEST_F(EndToEnd, NumberOfThreadsDoesNotChangeABit) {
  simulate({"--frames", "3", "--size", "320x240", "--seed", "2"});
  fit(folder_ / "one", {"--threads", "1"});
  fit(folder_ / "two", {"--threads", "2"});
  const auto without_times = [](const fs::path& file) {
    auto content = nlohmann::ordered_json::parse(read_text(file));
    EXPECT_EQ(content["report"].erase("seconds"), 1u);
    return content.dump();
  };
  EXPECT_EQ(without_times(folder_ / "one/result.json"), without_times(folder_ / "two/result.json"));
  for (const char* name : {"angles.csv", "hand.glb", "meshes/000002.ply"}) {
    EXPECT_EQ(read_text(folder_ / "one" / name), read_text(folder_ / "two" / name)) << name;
  }
}

TEST_F(EndToEnd, SameSeedMakesTheSameTake) {
  simulate({"--frames", "2", "--size", "320x240", "--seed", "9", "--threads", "1"});
  fs::rename(take(), folder_ / "first");
  simulate({"--frames", "2", "--size", "320x240", "--seed", "9", "--threads", "2"});
  std::size_t file_count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(take())) {
    if (!entry.is_regular_file()) continue;
    ++file_count;
    const fs::path twin = folder_ / "first" / fs::relative(entry.path(), take());
    EXPECT_EQ(read_text(entry.path()), read_text(twin)) << twin;
  }
  EXPECT_EQ(file_count, 4u + 2u + 2u * 3u);  // descriptions and object, truth, pictures
}

TEST_F(EndToEnd, ResultHoldsTheFilesThatTheFormatsPromise) {
  simulate(kSmallTake);
  fit(result(), {"--hulls"});
  const bool has_page = !viewer_page().empty();  // TEGATA_VIEWER=OFF builds without it
  std::vector<std::string> files = {"angles.csv", "hand.glb", "hulls", "meshes", "result.json"};
  if (has_page) files.insert(files.end() - 1, "report.html");
  EXPECT_EQ(names_in(result()), files);
  const std::vector<std::string> frames = {"000000.ply", "000001.ply", "000002.ply"};
  EXPECT_EQ(names_in(result() / "meshes"), frames);
  EXPECT_EQ(names_in(result() / "hulls"), frames);
  if (!has_page) {
    const ProgramRun run = run_program({"report", result().string()});
    EXPECT_EQ(run.exit_code, 1);
    ASSERT_EQ(run.error_lines().size(), 1U) << run.err;
    EXPECT_TRUE(says(run.error_lines().front(), "TEGATA_VIEWER=OFF"));
    return;
  }
  const std::string page = read_text(result() / "report.html");
  EXPECT_NE(page.find("id=\"tegata-report\""), std::string::npos);
  EXPECT_NE(page.find("\"jpeg\":\"/9j/"), std::string::npos);
  EXPECT_NE(page.find("\"hull\":{"), std::string::npos);
}

TEST_F(EndToEnd, ChosenFramesAloneAreFittedAndFreeGraspsDiffer) {
  simulate(kSmallTake);
  fit(result(), {"--no-report", "--frames", "0:2:2", "--grasp", "free"});
  const Result fitted = read_result_json(result() / "result.json");
  ASSERT_EQ(fitted.frames.size(), 2u);
  EXPECT_EQ(fitted.frames[0].name, "000000");
  EXPECT_EQ(fitted.frames[1].name, "000002");
  ASSERT_TRUE(fitted.frames[0].pose && fitted.frames[1].pose);
  EXPECT_GT((fitted.frames[0].pose->angles - fitted.frames[1].pose->angles).norm(), 1e-6);
}

TEST_F(EndToEnd, FixedGraspHasOneSetOfAngles) {
  simulate(kSmallTake);
  fit(result(), {"--no-report"});
  const Result fitted = read_result_json(result() / "result.json");
  for (const ResultFrame& frame : fitted.frames) {
    ASSERT_TRUE(frame.pose.has_value());
    EXPECT_EQ(frame.pose->angles, fitted.grasp_angles);
  }
}

TEST_F(EndToEnd, HandThatTheFitWroteFitsTheTakeAgain) {
  simulate(kSmallTake);
  fit(result(), {"--no-report"});
  fit(folder_ / "again", {"--no-report", "--hand", (result() / "hand.glb").string()});
  const double first = evaluate(result()).mean.surface_error_mm;
  EXPECT_LE(evaluate(folder_ / "again").mean.surface_error_mm, first + 1.0);
}

TEST_F(EndToEnd, ScriptsGetOneJsonObjectFromEachCommand) {
  std::vector<std::string> arguments = {"simulate", take().string(), "--quiet", "--json"};
  arguments.insert(arguments.end(), kSmallTake.begin(), kSmallTake.end());
  EXPECT_EQ(json::parse(run_program(arguments).out).at("frames"), 3);
  EXPECT_EQ(json::parse(fit(result(), {"--no-report", "--json"}).out).at("frames"), 3);

  const json take_info = json::parse(run_program({"info", take().string(), "--json"}).out);
  EXPECT_EQ(take_info.at("kind"), "take");
  EXPECT_EQ(take_info.at("source"), "masks");
  EXPECT_EQ(take_info.at("cameras").size(), 3u);
  EXPECT_EQ(take_info.at("truth"), true);
  const json result_info = json::parse(run_program({"info", result().string(), "--json"}).out);
  EXPECT_EQ(result_info.at("kind"), "result");
  EXPECT_EQ(result_info.at("grasp_deg").size(), 20u);
  const json figures = json::parse(
      run_program({"evaluate", result().string(), "--truth", take().string(), "--json"}).out);
  EXPECT_TRUE(figures.is_object());

  const fs::path picture = folder_ / "picture.png";
  const json drawn = json::parse(
      run_program({"picture", result().string(), "--take", take().string(), "-o", picture.string(),
                   "--frames", "2", "--width", "160", "--quiet", "--json"})
          .out);
  EXPECT_EQ(drawn.at("rows"), 2);
  EXPECT_EQ(drawn.at("columns"), 4);
  EXPECT_GE(read_picture(picture).values.width(), 4 * 160);

  const fs::path film = folder_ / "hand.mp4";
  const ProgramRun filmed = run_program(
      {"picture", result().string(), "-o", film.string(), "--width", "97", "--quiet", "--json"});
  EXPECT_EQ(filmed.exit_code, 0) << filmed.err;
  EXPECT_EQ(filmed.err, "");
  VideoFile video(film);
  EXPECT_EQ(json::parse(filmed.out).at("pictures"), video.frame_count());
  const Image<std::uint16_t> first = video.read(0).values;
  EXPECT_EQ(first.width(), 98);
  EXPECT_NE(first.values(), video.read(video.frame_count() / 2).values.values());
  const ProgramRun refused =
      run_program({"picture", result().string(), "-o", (folder_ / "p.png").string()});
  EXPECT_EQ(refused.exit_code, 1);
  ASSERT_EQ(refused.error_lines().size(), 1U) << refused.err;
  EXPECT_TRUE(says(refused.error_lines().front(), "p.png", "--take", ".mp4"));
}

}  // namespace
}  // namespace tegata

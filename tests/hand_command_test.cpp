// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// `tegata hand` from the outside, and hands from files in the other commands.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "run_program.h"
#include "tegata/base/angle.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

class HandCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs `tegata hand`; a failure where it does not exit with 0.
  static ProgramRun hand(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "hand");
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run;
  }
  /// Expects one line of error with all parts in it, and no new file.
  template <typename... Parts>
  void expect_refused(const std::vector<std::string>& arguments, const Parts&... parts) const {
    const std::vector<std::string> before = names_in(folder_.path());
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    ASSERT_EQ(run.error_lines().size(), 1U) << run.err;
    EXPECT_TRUE(says(run.error_lines().front(), "tegata: error: ", parts...));
    EXPECT_EQ(names_in(folder_.path()), before);
  }
  static nlohmann::json json_of(const ProgramRun& run) { return nlohmann::json::parse(run.out); }

  /// The example of docs/formats.md with the mesh that it speaks of: the built-in hand, flat, in
  /// millimetres.
  std::string scanned_hand(const std::string& folder = ".") const {
    const std::string document = read_text(TEGATA_SOURCE_DIR "/docs/formats.md");
    const std::size_t begin = document.find("```toml\nmesh = ") + 8;
    const std::string content = document.substr(begin, document.find("```", begin) - begin);
    fs::create_directories(folder_ / folder);
    write_text(folder_ / folder / "hand.toml", content);
    TriangleMesh mesh = PosedHand(built_in_hand({}, Side::right), {}).surface();
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= 1000.0;
    write_ply(mesh, folder_ / folder / "scan.ply");
    return (folder_ / folder / "hand.toml").string();
  }

  TestFolder folder_;
};

TEST_F(HandCommand, InfoSaysSizeBonesAndLimits) {
  const std::string text = hand({"info"}).out;
  for (const char* part : {"built-in", "right", "189.0 mm", "vertices", "closed", "index_proximal",
                           "thumb_cmc_abduction", "little_dip_flexion"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  const nlohmann::json json = json_of(hand({"info", "--json", "--side", "left"}));
  EXPECT_EQ(json.at("side"), "left");
  EXPECT_EQ(json.at("bone_lengths").size(), 16U);
  EXPECT_EQ(json.at("angles").size(), 20U);
  EXPECT_NEAR(json.at("length").get<double>(), 0.189, 1e-3);
  EXPECT_NEAR(json.at("angles").at("index_pip_flexion").at("upper").get<double>(), 105.0 * kDegree,
              1e-9);
}

TEST_F(HandCommand, SizesMakeOtherHands) {
  const auto length = [](const std::vector<std::string>& sizes) {
    std::vector<std::string> arguments = {"info", "--json"};
    arguments.insert(arguments.end(), sizes.begin(), sizes.end());
    return json_of(hand(arguments)).at("length").get<double>();
  };
  EXPECT_NEAR(length({"--length-mm", "170"}), 0.170, 1e-3);
  EXPECT_GT(length({"--percentile", "95", "--sex", "male"}),
            length({"--percentile", "5", "--sex", "female"}) + 0.03);
}

TEST_F(HandCommand, ConvertedHandsAreReadBackTheSame) {
  for (const std::string side : {"right", "left"}) {
    hand({"convert", "--side", side, "-o", path("hand.glb")});
    const nlohmann::json json = json_of(hand({"info", path("hand.glb"), "--json"}));
    EXPECT_EQ(json.at("side"), side);
    EXPECT_EQ(json.at("bone_lengths"),
              json_of(hand({"info", "--side", side, "--json"})).at("bone_lengths"));
  }
  hand({"convert", path("hand.glb"), "--mirror", "-o", path("other.gltf")});
  EXPECT_EQ(json_of(hand({"info", path("other.gltf"), "--json"})).at("side"), "right");
}

TEST_F(HandCommand, AScannedHandIsInspectedConvertedAndBent) {
  const std::string scan = scanned_hand();
  const nlohmann::json json = json_of(hand({"info", scan, "--json"}));
  EXPECT_EQ(json.at("name"), "anna");
  EXPECT_NEAR(json.at("length").get<double>(), 0.189, 2e-3);
  hand({"convert", scan, "-o", path("scan.glb")});
  const std::vector<std::string> bend = {"--angle", "index_mcp_flexion=50", "-o"};
  std::vector<std::string> first = {"pose", scan}, second = {"pose", path("scan.glb")};
  first.insert(first.end(), bend.begin(), bend.end());
  second.insert(second.end(), bend.begin(), bend.end());
  first.push_back(path("a.ply"));
  second.push_back(path("b.ply"));
  hand(first);
  hand(second);
  const TriangleMesh a = read_ply(path("a.ply")), b = read_ply(path("b.ply"));
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    ASSERT_LT((a.vertices[i] - b.vertices[i]).norm(), 1e-5);
  }
}

TEST_F(HandCommand, PoseBendsByDegreesInEveryKindOfFile) {
  HandPose pose;
  pose.angles[6] = 60.0 * kDegree;  // index_pip_flexion
  pose.angles[2] = -5.0 * kDegree;  // thumb_mcp_flexion
  const HandModel model = built_in_hand({}, Side::right);
  const TriangleMesh expected = PosedHand(model, pose).surface();
  for (const std::string name : {"hand.ply", "hand.obj", "hand.glb"}) {
    hand({"pose", "--angle", "index_pip_flexion=60", "--angle", "thumb_mcp_flexion=-5", "-o",
          path(name)});
  }
  const TriangleMesh ply = read_ply(path("hand.ply")), obj = read_obj(path("hand.obj"));
  ASSERT_EQ(ply.vertices.size(), expected.vertices.size());
  ASSERT_EQ(obj.vertices.size(), expected.vertices.size());
  for (std::size_t i = 0; i < expected.vertices.size(); ++i) {
    ASSERT_LT((ply.vertices[i] - expected.vertices[i]).norm(), 1e-6);
    ASSERT_LT((obj.vertices[i] - expected.vertices[i]).norm(), 1e-6);
  }
  EXPECT_NE(read_text(path("hand.glb")).find("\"animations\""), std::string::npos);
  const HandModel again = read_hand_gltf(path("hand.glb"), Side::right);  // in its rest pose
  EXPECT_LT((again.rest_angles - model.rest_angles).norm(), 1e-9);
}

TEST_F(HandCommand, PoseTakesTheGraspOfAResult) {
  Result result;
  result.take = "take";
  result.model_name = "built-in";
  result.grasp_angles = relaxed_angles();
  ResultFrame frame;
  frame.name = "000007";
  frame.pose = HandPose{{Eigen::Quaterniond::Identity(), {0.0, 0.0, 2.0}}, relaxed_angles()};
  frame.keypoints.fill(Eigen::Vector3d::Zero());
  result.frames.push_back(frame);
  result.side = Side::left;
  write_result_json(result, folder_ / "result.json");
  const std::string folder = folder_.path().string();
  hand({"pose", "--result", folder, "-o", path("grasp.ply")});
  hand({"pose", "--result", folder, "--frame", "000007", "-o", path("frame.ply")});
  hand({"pose", "--side", "left", "--from", "relaxed", "-o", path("relaxed.ply")});
  const TriangleMesh grasp = read_ply(path("grasp.ply")), placed = read_ply(path("frame.ply")),
                     relaxed = read_ply(path("relaxed.ply"));
  for (std::size_t i = 0; i < relaxed.vertices.size(); ++i) {
    ASSERT_LT((grasp.vertices[i] - relaxed.vertices[i]).norm(), 1e-6);
    ASSERT_LT((placed.vertices[i] - relaxed.vertices[i] - Eigen::Vector3d(0, 0, 2)).norm(), 1e-6);
  }
  expect_refused({"hand", "pose", "--result", folder, "--frame", "8", "-o", path("x.ply")}, folder,
                 "'8'");
  expect_refused({"hand", "pose", "--side", "right", "--result", folder, "-o", path("x.ply")},
                 folder, "--side left");
}

TEST_F(HandCommand, AnglesBeyondTheLimitsAreWarnedOf) {
  const std::vector<std::string> arguments = {"pose", "--angle", "ring_pip_flexion=130", "-o",
                                              path("hand.ply")};
  const ProgramRun run = hand(arguments);
  ASSERT_EQ(run.error_lines().size(), 1U) << run.err;
  EXPECT_TRUE(says(run.error_lines()[0], "warning", "ring_pip_flexion", "130", "105"));
  std::vector<std::string> quiet = arguments;
  quiet.push_back("--quiet");
  EXPECT_EQ(hand(quiet).err, "");
}

TEST_F(HandCommand, PictureShowsTheHandFromEverySide) {
  hand({"picture", "--from", "relaxed", "--width", "96", "-o", path("hand.png")});
  const CameraImage picture = read_picture(path("hand.png"));
  ASSERT_EQ(picture.values.width(), 4 * 96);
  ASSERT_EQ(picture.values.height(), 96);
  std::vector<double> shares;  // of pixels with the hand
  for (int view = 0; view < 4; ++view) {
    int count = 0;
    for (int y = 0; y < 96; ++y) {
      for (int x = 0; x < 96; ++x) count += picture.values(96 * view + x, y, 2) < 200 ? 1 : 0;
    }
    shares.push_back(count / (96.0 * 96.0));
  }
  for (const double share : shares) {
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.5);
  }
  EXPECT_NEAR(shares[0], shares[1], 0.05);  // back and palm are each other's mirror image, nearly
  EXPECT_GT(shares[0], shares[3]);
  hand({"picture", "--views", "little,tips", "--width", "32", "-o", path("two.png")});
  EXPECT_EQ(read_picture(path("two.png")).values.width(), 64);
}

TEST_F(HandCommand, BadHandsAreOneError) {
  const std::string scan = scanned_hand();
  write_text(folder_ / "cut.glb", std::string("glTF\2\0\0\0\0\1\0\0", 12));
  write_text(folder_ / "text.glb", "no hand at all");
  expect_refused({"hand", "info", path("absent.glb")}, "absent.glb");
  expect_refused({"hand", "info", path("cut.glb")}, "cut.glb", "cut off");
  expect_refused({"hand", "info", path("text.glb")}, "text.glb", "glTF");
  expect_refused({"hand", "info", path("scan.ply")}, "scan.ply", ".toml");
  expect_refused({"hand", "info", scan, "--side", "left"}, "hand.toml", "right", "--mirror");
  expect_refused({"hand", "info", scan, "--length-mm", "180"}, "hand.toml", "size");
  expect_refused({"hand", "info", "--length-mm", "18"}, "length");
  replace_in_file(scan, "thumb_ip ", "thumb_pi ");
  expect_refused({"hand", "info", scan}, "hand.toml", "thumb_pi", "thumb_ip");
}

TEST_F(HandCommand, BadOutputsAreOneErrorAndLeaveNothing) {
  expect_refused({"hand", "convert", "-o", path("hand.ply")}, "hand.ply", ".glb");
  expect_refused({"hand", "pose", "-o", path("hand.stl")}, "hand.stl", ".obj");
  expect_refused({"hand", "pose", "-o", path("absent/hand.ply")}, "absent/hand.ply");
  expect_refused({"hand", "picture", "-o", path("hand.xyz")}, "hand.xyz");
  const std::vector<std::string> before = names_in(folder_.path());
  for (const std::string name : {"hand.ply", "hand.obj", "hand.glb"}) {
    const ProgramRun run = run_program({"hand", "pose", "-o", path(name)}, 1000);
    EXPECT_EQ(run.exit_code, 1);
    ASSERT_EQ(run.error_lines().size(), 1U) << run.err;
    EXPECT_TRUE(says(run.error_lines()[0], name, "written"));
    EXPECT_EQ(names_in(folder_.path()), before);
  }
}

TEST_F(HandCommand, WrongUsageExitsWithTwo) {
  const std::vector<std::vector<std::string>> mistakes = {
      {"hand"},
      {"hand", "sketch"},
      {"hand", "convert"},
      {"hand", "pose", "--angle", "index_pip_flexion=60"},
      {"hand", "pose", "--angle", "index_pip=60", "-o", path("x.ply")},
      {"hand", "pose", "--angle", "index_pip_flexion", "-o", path("x.ply")},
      {"hand", "pose", "--angle", "index_pip_flexion=6o", "-o", path("x.ply")},
      {"hand", "pose", "--angle", "index_pip_flexion=nan", "-o", path("x.ply")},
      {"hand", "pose", "--frame", "000000", "-o", path("x.ply")},
      {"hand", "picture", "--views", "inside", "-o", path("x.png")},
      {"hand", "info", "--percentile", "100"},
      {"hand", "info", "--side", "both"},
  };
  for (const std::vector<std::string>& arguments : mistakes) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments.back();
    EXPECT_NE(run.err, "");
    EXPECT_TRUE(names_in(folder_.path()).empty());
  }
}

TEST_F(HandCommand, EverySubcommandExplainsItselfWithAnExample) {
  for (const std::string command : {"info", "convert", "pose", "picture"}) {
    EXPECT_NE(hand({command, "--help"}).out.find("Example: tegata hand " + command),
              std::string::npos);
  }
}

TEST_F(HandCommand, ATakeOfAScannedHandIsFittedWithThatHand) {
  const std::string scan = scanned_hand("hands");
  ProgramRun run = run_program({"simulate", path("take"), "--hand", scan, "--mode", "clean",
                                "--frames", "2", "--size", "320x240", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  run = run_program(
      {"fit", path("take"), "-o", path("result"), "--hand", scan, "--quiet", "--no-report"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(read_result_json(folder_ / "result" / "result.json").model_name, "anna");
  run = run_program({"evaluate", path("result"), "--truth", path("take"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run_program({"picture", path("result"), "--take", path("take"), "--hand", scan, "-o",
                         path("picture.png"), "--quiet"})
                .exit_code,
            0);
}

}  // namespace
}  // namespace tegata

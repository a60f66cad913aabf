// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// `tegata export` from the outside, hand.glb, and what other programs read of them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "glb_for_tests.h"
#include "run_program.h"
#include "tegata/export/export_readers_for_tests.h"
#include "tegata/export/moving_result_for_tests.h"
#include "tegata/export/result_folder.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr double kTolerance = 1e-4;  // [m]

CameraRig two_cameras() {
  CameraRig rig(2);
  for (std::size_t i = 0; i < rig.size(); ++i) {
    rig[i].name = i == 0 ? "left" : "right";
    rig[i].width = 640;
    rig[i].height = 480;
    rig[i].fx = rig[i].fy = 800.0;
    rig[i].cx = 319.5;
    rig[i].cy = 239.5;
    rig[i].camera_from_world = {so3_exp({0.1, 1.5 * static_cast<double>(i), 0.0}), {0.1, 0.2, 0.9}};
  }
  return rig;
}

/// A result of the built-in hand whose first and fourth frames have no pose.
class ExportCommand : public testing::Test {
 protected:
  ExportCommand() : hand_(built_in_hand({}, Side::left)), result_(moving_result(hand_)) {
    fs::create_directories(folder_ / "result");
    write_result_files(result_, hand_, folder_ / "result", two_cameras());
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Exports to a file or folder of that name.
  ProgramRun run(const std::string& format, const std::string& name,
                 std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"export", path("result"), "--to", format, "-o", path(name)});
    return run_program(more);
  }
  std::string exported(const std::string& format) const {
    const ProgramRun done = run(format, "hand." + format, {"--quiet"});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.err, "");
    return format == "urdf" ? std::string() : read_text(folder_ / ("hand." + format));
  }
  /// Runs a command and gives what it printed; a failure where it does not exit with 0.
  std::string output_of(const std::string& command) const {
    const int code = std::system((command + " > '" + path("output") + "' 2>&1").c_str());
    const std::string output = read_text(folder_ / "output");
    EXPECT_EQ(code, 0) << command << "\n" << output;
    return output;
  }
  static bool works(const std::string& command) {
    return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
  }
  /// Runs a script of Python with the file, the result and names of keypoints.
  void expect_script_agrees(const std::string& program, const std::string& script,
                            const std::string& file) const {
    write_text(folder_ / "script.py", script);
    const std::string output = output_of(program + " '" + path("script.py") + "' -- '" +
                                         path(file) + "' '" + path("result/result.json") + "'");
    EXPECT_NE(output.find("agrees"), std::string::npos) << output;
  }

  TestFolder folder_;
  HandModel hand_;
  Result result_;
};

TEST_F(ExportCommand, EveryFormatGivesTheKeypointsOfTheResult) {
  expect_keypoints(csv_keypoints(exported("csv")), result_, kTolerance);
  expect_keypoints(trc_keypoints(exported("trc")), result_, kTolerance);
  expect_keypoints(mot_keypoints(exported("mot"), hand_.skeleton), result_, kTolerance);
  std::vector<NamedPoints> bvh = bvh_keypoints(exported("bvh"));
  ASSERT_EQ(bvh.size(), result_.frames.size());
  for (const std::size_t held : {0U, 3U}) bvh[held].clear();
  expect_keypoints(bvh, result_, kTolerance);
  exported("urdf");
  expect_keypoints(urdf_keypoints(read_text(folder_ / "hand.urdf/hand.urdf"),
                                  read_text(folder_ / "hand.urdf/joint_states.csv")),
                   result_, kTolerance);
}

TEST_F(ExportCommand, CheckUrdfTakesTheHand) {
  if (!works("command -v check_urdf")) GTEST_SKIP() << "check_urdf is absent: liburdfdom-tools";
  exported("urdf");
  const std::string output = output_of("check_urdf '" + path("hand.urdf/hand.urdf") + "'");
  EXPECT_NE(output.find("Successfully Parsed XML"), std::string::npos) << output;
  EXPECT_NE(output.find("root Link: wrist has 1 child(ren)"), std::string::npos) << output;
  EXPECT_NE(output.find("little_tip"), std::string::npos) << output;
}

TEST_F(ExportCommand, NumpyReadsTheArrays) {
  if (!works("/usr/bin/python3 -c 'import numpy'")) GTEST_SKIP() << "python3-numpy is absent";
  exported("npz");
  expect_script_agrees("/usr/bin/python3", R"(
import json, sys
import numpy as np
npz = np.load(sys.argv[2])
result = json.load(open(sys.argv[3]))
count = len(result["frames"])
assert list(npz["joint_names"]) == result["joint_names"]
assert list(npz["keypoint_names"]) == result["keypoint_names"]
assert npz["keypoints"].shape == (count, 21, 3) and npz["keypoints"].dtype == np.float64
assert npz["angles"].shape == (count, 20) and npz["support"].shape == (count, 16)
assert npz["vertices"].shape[0] == count and npz["vertices"].dtype == np.float32
assert npz["triangles"].max() + 1 == npz["vertices"].shape[1]
assert np.array_equal(npz["grasp_angles"], result["grasp"]["angles"])
for i, frame in enumerate(result["frames"]):
    assert npz["frame"][i] == frame["frame"] and npz["status"][i] == frame["status"]
    assert npz["time"][i] == frame["time"] and npz["has_pose"][i] == ("rotation" in frame)
    if "rotation" not in frame:
        for name in ("rotation", "translation", "angles", "keypoints", "support", "vertices"):
            assert np.isnan(npz[name][i]).all(), name
        continue
    for name in ("rotation", "translation", "angles", "keypoints"):
        assert np.array_equal(npz[name][i], frame[name]), name
    assert np.array_equal(npz["support"][i], [frame["support"][n] for n in npz["bone_names"]])
    # Every fingertip lies in the hand's surface.
    tips = npz["keypoints"][i][4::4].astype(np.float32)
    gaps = np.linalg.norm(npz["vertices"][i][:, None] - tips, axis=2).min(axis=0)
    assert gaps.max() < 0.015, gaps
print("agrees")
)",
                       "hand.npz");
}

// Blender is z up: what is x, y, z in the result is x, z, -y there. The importers of Debian's
// Blender 3.4 ask for what its Python 3.11 and NumPy 1.24 no longer have.
constexpr const char* kBlenderScript = R"(
import builtins, bpy, json, sys
import numpy
from mathutils import Vector
numpy.bool = bool
old_open = open
builtins.open = lambda file, mode="r", *more, **named: old_open(file, mode.replace("U", ""), *more, **named)
file, result = sys.argv[sys.argv.index("--") + 1:]
result = json.load(open(result))
names = result["keypoint_names"]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.context.scene.render.fps = 10
first, tips = IMPORT
hand = next(o for o in bpy.context.scene.objects if o.type == "ARMATURE")
worst, compared = 0.0, 0
for i, frame in enumerate(result["frames"]):
    if "rotation" not in frame:
        continue
    bpy.context.scene.frame_set(first + i)
    for name, (x, y, z) in zip(names, frame["keypoints"]):
        bone, end = tips(name)
        bone = hand.pose.bones[bone]
        place = hand.matrix_world @ (bone.tail if end else bone.head)
        worst = max(worst, (place - Vector((x, z, -y))).length)
        compared += 1
print("worst distance:", worst, "of", compared)
CAMERAS
if compared >= 21 and worst < 1e-4:
    print("agrees")
)";

std::string blender_script(const std::string& import, const std::string& cameras) {
  std::string script = kBlenderScript;
  script.replace(script.find("IMPORT"), 6, import);
  return script.replace(script.find("CAMERAS"), 7, cameras);
}

constexpr const char* kBlender = "blender --background --python-exit-code 1 --python";

TEST_F(ExportCommand, BlenderReadsTheBvh) {
  if (!works("command -v blender")) GTEST_SKIP() << "blender is absent";
  exported("bvh");
  expect_script_agrees(kBlender,
                       blender_script("1, lambda n: (n, False) if not n.endswith('_tip') else "
                                      "(n[:-3] + ('ip' if n == 'thumb_tip' else 'dip'), True)\n"
                                      "bpy.ops.import_anim.bvh(filepath=file, global_scale=0.01)",
                                      ""),
                       "hand.bvh");
}

TEST_F(ExportCommand, BlenderReadsTheGlbAndItsCameras) {
  if (!works("command -v blender")) GTEST_SKIP() << "blender is absent";
  const std::string import = R"(0, None
def tips(name):
    digit, _, joint = name.partition("_")
    digit = {"little": "pinky"}.get(digit, digit)
    if name == "wrist":
        return "wrist", False
    if digit == "thumb":
        ends = {"cmc": "metacarpal", "mcp": "phalanx-proximal", "ip": "phalanx-distal"}
        return "thumb-" + ends.get(joint, "tip"), False
    ends = {"mcp": "phalanx-proximal", "pip": "phalanx-intermediate", "dip": "phalanx-distal"}
    return digit + "-finger-" + ends.get(joint, "tip"), False
bpy.ops.import_scene.gltf(filepath=file))";
  std::string cameras;
  for (const Camera& camera : two_cameras()) {
    const Eigen::Vector3d place = camera.center_in_world();
    cameras += text("place = bpy.data.objects['", camera.name, "'].matrix_world.translation\n",
                    "assert (place - Vector((", place.x(), ", ", place.z(), ", ", -place.y(),
                    "))).length < 1e-4, place\n");
  }
  expect_script_agrees(kBlender, blender_script(import, cameras), "result/hand.glb");
}

/// What WebXR calls the keypoints.
std::string webxr_name(const std::string& keypoint) {
  if (keypoint == "wrist") return keypoint;
  const std::string digit = keypoint.substr(0, keypoint.find('_'));
  const std::string joint = keypoint.substr(keypoint.find('_') + 1);
  const std::map<std::string, std::string> thumb = {
      {"cmc", "metacarpal"}, {"mcp", "phalanx-proximal"}, {"ip", "phalanx-distal"}, {"tip", "tip"}};
  const std::map<std::string, std::string> finger = {{"mcp", "phalanx-proximal"},
                                                     {"pip", "phalanx-intermediate"},
                                                     {"dip", "phalanx-distal"},
                                                     {"tip", "tip"}};
  if (digit == "thumb") return "thumb-" + thumb.at(joint);
  return (digit == "little" ? "pinky" : digit) + "-finger-" + finger.at(joint);
}

TEST_F(ExportCommand, GlbMovesTheJointsWithTheResult) {
  const Glb glb(read_text(folder_ / "result/hand.glb"));
  const std::vector<std::string> joints = glb.joint_names();
  EXPECT_EQ(std::set<std::string>(joints.begin(), joints.end()).size(), 25U);
  for (const std::string digit : {"index", "middle", "ring", "pinky"}) {
    EXPECT_EQ(std::count(joints.begin(), joints.end(), digit + "-finger-metacarpal"), 1);
  }
  std::vector<NamedPoints> frames;
  for (const ResultFrame& frame : result_.frames) {
    NamedPoints& points = frames.emplace_back();
    const double time = frame.time - result_.frames.front().time;
    if (glb.world("wrist", time).linear().norm() == 0.0) continue;  // hidden
    for (const std::string_view name : keypoint_names()) {
      const std::string joint = webxr_name(std::string(name));
      EXPECT_EQ(std::count(joints.begin(), joints.end(), joint), 1) << joint;
      points[std::string(name)] = y_down(glb.world(joint, time).translation());
    }
  }
  expect_keypoints(frames, result_, kTolerance);
}

TEST_F(ExportCommand, GlbHasTheCameras) {
  const Glb glb(read_text(folder_ / "result/hand.glb"));
  const auto& cameras = glb.json().at("cameras");
  ASSERT_EQ(cameras.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Camera camera = two_cameras()[i];
    EXPECT_EQ(cameras[i].at("name"), camera.name);
    EXPECT_NEAR(cameras[i].at("perspective").at("yfov").get<double>(),
                2.0 * std::atan(240.0 / 800.0), 1e-6);
    // It looks along its -z; up is y.
    const Eigen::Affine3d world = glb.world(camera.name, 0.0);
    EXPECT_LT((y_down(world.translation()) - camera.center_in_world()).norm(), 1e-6);
    const Eigen::Quaterniond world_from_camera = camera.camera_from_world.rotation.conjugate();
    EXPECT_LT(
        (y_down(-world.linear().col(2)) - world_from_camera * Eigen::Vector3d::UnitZ()).norm(),
        1e-6);
    EXPECT_LT((y_down(world.linear().col(1)) + world_from_camera * Eigen::Vector3d::UnitY()).norm(),
              1e-6);
  }
}

TEST_F(ExportCommand, ValidatorFindsNothingInTheGlb) {
  const fs::path modules = fs::path(TEGATA_SOURCE_DIR) / "build/assets/node_modules";
  if (!fs::exists(modules / "gltf-validator") || !works("node --version")) {
    GTEST_SKIP() << "gltf-validator is absent: scripts/fetch_test_assets.sh";
  }
  write_text(folder_ / "validate.js", R"(
const bytes = new Uint8Array(require('fs').readFileSync(process.argv[2]));
require('gltf-validator').validateBytes(bytes).then(report => {
  console.log(JSON.stringify(report.issues));
  process.exit(report.issues.numErrors + report.issues.numWarnings > 0 ? 1 : 0);
});
)");
  output_of("NODE_PATH='" + modules.string() + "' node '" + path("validate.js") + "' '" +
            path("result/hand.glb") + "'");
}

TEST_F(ExportCommand, TellsWhatTheFormatCannotSay) {
  const ProgramRun bvh = run("bvh", "hand.bvh");
  EXPECT_NE(bvh.err.find("2 without a pose show the one before: a,0, d,3"), std::string::npos)
      << bvh.err;
  const auto json = nlohmann::json::parse(run("bvh", "hand.bvh", {"--json", "--quiet"}).out);
  EXPECT_EQ(json.at("notes").size(), 1U);
  EXPECT_EQ(json.at("frames"), 8);
  EXPECT_EQ(run("csv", "hand.csv").err, "");
}

TEST_F(ExportCommand, RefusesAnotherHandThanTheFittedOne) {
  ASSERT_EQ(run_program({"hand", "convert", "--side", "left", "--length-mm", "170", "-o",
                         path("short.glb"), "--quiet"})
                .exit_code,
            0);
  const ProgramRun done = run("bvh", "hand.bvh", {"--hand", path("short.glb")});
  EXPECT_EQ(done.exit_code, 1);
  ASSERT_EQ(done.error_lines().size(), 1U) << done.err;
  EXPECT_TRUE(says(done.error_lines().front(), "short", "mm from the result's", "built-in"));
  EXPECT_FALSE(fs::exists(folder_ / "hand.bvh"));
}

TEST_F(ExportCommand, TakesTheHandFromElsewhereWhereTheResultHasNone) {
  fs::remove(folder_ / "result/hand.glb");
  exported("urdf");
  expect_keypoints(urdf_keypoints(read_text(folder_ / "hand.urdf/hand.urdf"),
                                  read_text(folder_ / "hand.urdf/joint_states.csv")),
                   result_, kTolerance);
}

TEST_F(ExportCommand, LeavesNothingHalfWritten) {
  const std::vector<std::string> before = names_in(folder_.path());
  for (const std::string format : {"npz", "urdf"}) {
    const ProgramRun done = run_program(
        {"export", path("result"), "--to", format, "-o", path("hand." + format)}, 20000);
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_EQ(done.error_lines().size(), 1U) << done.err;
    EXPECT_EQ(names_in(folder_.path()), before);
  }
}

TEST_F(ExportCommand, ReplacesAFolderOnlyWhenAsked) {
  exported("urdf");
  EXPECT_EQ(run("urdf", "hand.urdf").exit_code, 1);
  EXPECT_EQ(run("urdf", "hand.urdf", {"--force"}).exit_code, 0);
  EXPECT_EQ(run("urdf", "result", {"--force"}).exit_code, 1);  // that is no URDF's folder
  EXPECT_EQ(run("fbx", "hand.fbx").exit_code, 2);
}

}  // namespace
}  // namespace tegata

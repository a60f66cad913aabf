// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/virtual_room.h"

#include <array>
#include <cmath>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/base/random.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/sim/hand_motion.h"
#include "tegata/sim/infrared_camera.h"
#include "tegata/sim/room_cameras.h"
#include "tegata/sim/warm_body.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/take.h"
#include "tegata/take/truth.h"

namespace tegata {
namespace {

constexpr double kLongestObjectEdge = 0.0035;  // [m]

constexpr std::array<std::pair<SimulatedMode, std::string_view>, 3> kModeNames = {{
    {SimulatedMode::infrared, "infrared"},
    {SimulatedMode::mask, "mask"},
    {SimulatedMode::clean, "clean"},
}};

// What each stream of random numbers is for, so that no two share one.
enum class Stream : std::uint64_t {
  grasp = 1,
  cameras,
  motion,
  skin,
  forearm,
  landmarks,
  room,
  noise
};

// Mixes the take's seed with what the numbers are for (SplitMix64's finalizer, Steele et al. 2014).
std::uint64_t stream_seed(std::uint64_t seed, Stream stream, std::uint64_t frame = 0,
                          std::uint64_t camera = 0) {
  std::uint64_t mixed = seed;
  for (const std::uint64_t part : {static_cast<std::uint64_t>(stream), frame, camera}) {
    mixed += 0x9e3779b97f4a7c15u * (part + 1);
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
    mixed ^= mixed >> 31;
  }
  return mixed;
}

std::string frame_name(std::size_t frame) {
  const std::string digits = std::to_string(frame);
  return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

// Everything that does not change from frame to frame.
struct Room {
  const HandModel& hand;
  const SimulationOptions& options;
  CameraRig rig;
  Grasp grasp;
  std::vector<Rigid3d> world_from_hand;  // one a frame
  TriangleMesh object_in_hand;           // empty where nothing may hide the hand
  WarmSurface forearm_in_hand;           // empty where there is none
  std::vector<float> skin;               // radiance, one a vertex of the hand

  HandPose pose(std::size_t frame) const { return {world_from_hand[frame], grasp.angles}; }
};

Room furnished_room(const HandModel& hand, const SimulationOptions& options) {
  const std::uint64_t seed = options.seed;
  Room room{hand, options, {}, {}, {}, {}, {}, {}};
  room.rig = room_cameras({options.camera_count, options.width, options.height, options.distortion,
                           stream_seed(seed, Stream::cameras)});
  room.grasp = make_grasp(hand, options.grasp, stream_seed(seed, Stream::grasp));
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& keypoint :
       posed_keypoints(hand.skeleton, HandPose{{}, room.grasp.angles})) {
    center += keypoint / kKeypointCount;
  }
  room.world_from_hand = hand_motion(
      center, {options.frame_count, options.turn_deg, stream_seed(seed, Stream::motion)});
  if (options.mode != SimulatedMode::clean) {
    room.object_in_hand = object_surface(room.grasp.held.object, kLongestObjectEdge);
    for (Eigen::Vector3d& vertex : room.object_in_hand.vertices) {
      vertex = room.grasp.held.hand_from_object * vertex;
    }
  }
  if (options.forearm) {
    room.forearm_in_hand = forearm_surface(hand, stream_seed(seed, Stream::forearm));
  }
  room.skin = skin_radiance(hand, stream_seed(seed, Stream::skin));
  return room;
}

RoomScene scene_of_frame(const Room& room, const TriangleMesh& hand_surface, std::size_t frame) {
  const Rigid3d& world_from_hand = room.world_from_hand[frame];
  RoomScene scene;
  scene.warm = joined({hand_surface, room.skin}, moved(world_from_hand, room.forearm_in_hand));
  scene.cold = room.object_in_hand;
  for (Eigen::Vector3d& vertex : scene.cold.vertices) vertex = world_from_hand * vertex;
  return scene;
}

void write_frame(const Room& room, std::size_t frame, const std::filesystem::path& folder) {
  const TriangleMesh surface = PosedHand(room.hand, room.pose(frame)).surface();
  write_ply(surface, folder / "truth" / (frame_name(frame) + ".ply"));
  const RoomScene scene = scene_of_frame(room, surface, frame);
  const bool infrared = room.options.mode == SimulatedMode::infrared;
  for (std::size_t c = 0; c < room.rig.size(); ++c) {
    const InfraredSensor sensor{room.options.bits,
                                stream_seed(room.options.seed, Stream::room, 0, c),
                                stream_seed(room.options.seed, Stream::noise, frame, c)};
    const CameraImage picture = infrared ? infrared_picture(scene, room.rig[c], sensor)
                                         : mask_from_silhouette(room_mask(scene, room.rig[c]));
    write_picture(picture, folder / (infrared ? "images" : "masks") / room.rig[c].name /
                               (frame_name(frame) + ".png"));
  }
}

// As somebody who clicks on landmarks in two pictures gets them.
InitialLandmarks rough_landmarks(const Room& room) {
  Random random(stream_seed(room.options.seed, Stream::landmarks));
  const auto keypoints = posed_keypoints(room.hand.skeleton, room.pose(0));
  const auto rough = [&](std::size_t keypoint) -> Eigen::Vector3d {
    const Eigen::Vector3d way(random.normal(), random.normal(), random.normal());
    return keypoints[keypoint] + random.uniform(0.005, 0.015) * way.normalized();
  };
  InitialLandmarks landmarks;
  landmarks.wrist = rough(kWrist);
  landmarks.index_mcp = rough(kIndexMcp);
  landmarks.little_mcp = rough(kLittleMcp);
  return landmarks;
}

void write_descriptions(const Room& room, const std::filesystem::path& folder) {
  const SimulationOptions& options = room.options;
  TakeInfo info;
  info.name = text(simulated_grasp_name(options.grasp), "-", simulated_mode_name(options.mode), "-",
                   side_name(options.side), "-", options.seed);
  info.side = options.side;
  if (options.initial_pose) info.initial_landmarks = rough_landmarks(room);
  write_take_info(info, folder / "take.toml");
  write_calibration(room.rig, folder / "calibration.toml");

  Truth truth;
  truth.side = options.side;
  for (std::size_t frame = 0; frame < room.world_from_hand.size(); ++frame) {
    truth.frames.push_back({frame_name(frame),
                            posed_keypoints(room.hand.skeleton, room.pose(frame)),
                            room.grasp.angles});
  }
  write_truth_json(truth, folder / "truth.json");
  if (!room.object_in_hand.triangles.empty()) write_ply(room.object_in_hand, folder / "object.ply");
}

void check_options(const HandModel& hand, const SimulationOptions& options) {
  if (hand.skeleton.side != options.side) {
    throw Error("simulated take: got a ", side_name(hand.skeleton.side), " hand ('", hand.name,
                "'), expected a ", side_name(options.side), " one as the options say");
  }
  if (options.frame_count < 1) {
    throw Error("simulated take: got ", options.frame_count, " frames, expected 1 or more");
  }
  if (!std::isfinite(options.turn_deg)) {
    throw Error("simulated take: got a turn of ", options.turn_deg, " degrees, expected a number");
  }
  if (options.bits != 8 && options.bits != 16) {
    throw Error("simulated take: got ", options.bits, " bits a pixel, expected 8 or 16");
  }
}

}  // namespace

std::string_view simulated_mode_name(SimulatedMode mode) {
  for (const auto& [named, name] : kModeNames) {
    if (named == mode) return name;
  }
  throw Error("simulated take: got mode number ", static_cast<int>(mode), ", expected a known one");
}

SimulatedMode simulated_mode_from_name(std::string_view name) {
  for (const auto& [mode, its_name] : kModeNames) {
    if (its_name == name) return mode;
  }
  throw Error("simulated take: got mode '", name, "', expected infrared, mask or clean");
}

void simulate_take(const HandModel& hand, const SimulationOptions& options,
                   const std::filesystem::path& folder, bool replace, const Observer& observer) {
  check_options(hand, options);
  check_hand(hand);
  const Room room = furnished_room(hand, options);
  StagedFolder staged(folder, replace, "take.toml");
  const char* pictures = options.mode == SimulatedMode::infrared ? "images" : "masks";
  for (const Camera& camera : room.rig) {
    std::filesystem::create_directories(staged.path() / pictures / camera.name);
  }
  std::filesystem::create_directories(staged.path() / "truth");
  write_descriptions(room, staged.path());

  const std::size_t frame_count = room.world_from_hand.size();
  std::mutex one_at_a_time;
  std::size_t done = 0;
  parallel_for(frame_count, options.threads, [&](std::size_t frame) {
    write_frame(room, frame, staged.path());
    const std::lock_guard lock(one_at_a_time);
    observer.progress("simulate", ++done, frame_count);
  });
  staged.commit();
}

}  // namespace tegata

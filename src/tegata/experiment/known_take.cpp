// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/experiment/known_take.h"

#include "tegata/base/angle.h"
#include "tegata/evaluate/surface_error.h"
#include "tegata/mesh/mesh_file.h"

namespace tegata {

KnownTake make_known_take(const HandModel& hand, const SimulationOptions& room,
                          const std::filesystem::path& folder) {
  simulate_take(hand, room, folder, false, {});
  Take take = Take::open(folder);
  PrepareOptions prepare;
  prepare.threads = 1;
  KnownTake known{prepare_take(take, prepare, {}), {}, {}};
  const Truth truth = read_truth_json(folder / "truth.json");
  for (const std::size_t i : known.prepared.usable()) {
    known.truth.push_back(truth.frames[i]);
    known.surfaces.push_back(read_ply(folder / "truth" / (truth.frames[i].name + ".ply")));
    const SceneFrame& scene = known.prepared.scene();
    for (Eigen::Vector3d& point : known.truth.back().keypoints) point = scene.in_scene(point);
    for (Eigen::Vector3d& point : known.surfaces.back().vertices) point = scene.in_scene(point);
  }
  std::filesystem::remove_all(folder);
  return known;
}

double surface_error_mm(const HandModel& hand, std::span<const HandPose> poses,
                        const KnownTake& known) {
  double sum = 0.0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const TruthFrame& truth = known.truth[k];
    const Eigen::Vector3d along =
        (truth.keypoints[kMiddleMcp] - truth.keypoints[kWrist]).normalized();
    sum += surface_error(PosedHand(hand, poses[k]).surface(), known.surfaces[k],
                         {along, truth.keypoints[kWrist]});
  }
  return 1000.0 * sum / static_cast<double>(poses.size());
}

double angle_error_deg(std::span<const HandPose> poses, const KnownTake& known, int angle_count) {
  double sum = 0.0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const JointAngles off = (poses[k].angles - *known.truth[k].angles).cwiseAbs();
    sum += off.head(angle_count).mean();
  }
  return kDegreesPerRadian * sum / static_cast<double>(poses.size());
}

}  // namespace tegata

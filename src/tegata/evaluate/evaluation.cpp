// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/evaluate/evaluation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/evaluate/keypoint_error.h"
#include "tegata/evaluate/surface_error.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/result.h"
#include "tegata/take/truth.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr double kMillimetres = 1000.0;
constexpr std::size_t kMiddleMcp = 9;

// The finger side is the positive one.
Eigen::Hyperplane<double, 3> wrist_plane(const TruthFrame& truth) {
  const Eigen::Vector3d along = truth.keypoints[kMiddleMcp] - truth.keypoints[0];
  if (!(along.norm() > 0.0)) {
    throw Error("truth.json: frame ", truth.name,
                ": got the wrist and middle_mcp at the same place, expected a hand");
  }
  return {along.normalized(), truth.keypoints[0]};
}

TriangleMesh read_surface(const fs::path& folder, const std::string& frame, const char* what) {
  const fs::path file = folder / (frame + ".ply");
  if (!fs::exists(file)) {
    throw Error(file.string(), ": there is no such file, expected the ", what, " surface of frame ",
                frame);
  }
  return read_ply(file);
}

Evaluation::Frame compare_frame(const ResultFrame& fitted, const TruthFrame& truth,
                                const TriangleMesh& fitted_surface,
                                const TriangleMesh& true_surface) {
  Evaluation::Frame frame;
  frame.name = fitted.name;
  frame.status = fitted.status;
  frame.surface_error_mm =
      kMillimetres * surface_error(fitted_surface, true_surface, wrist_plane(truth));
  if (const auto error = vertex_error(fitted_surface, true_surface)) {
    frame.vertex_error_mm = kMillimetres * *error;
  }
  const Keypoints &a = fitted.keypoints, &b = truth.keypoints;
  frame.keypoint_error_mm = kMillimetres * keypoint_error(a, b);
  frame.keypoint_root_relative_mm = kMillimetres * root_relative_keypoint_error(a, b);
  frame.keypoint_procrustes_mm = kMillimetres * procrustes_keypoint_error(a, b);
  if (truth.angles) {
    frame.angle_error_deg =
        kDegreesPerRadian * (fitted.pose->angles - *truth.angles).cwiseAbs().mean();
  }
  frame.flexion_error_deg = kDegreesPerRadian * flexion_error(a, b);
  return frame;
}

// Of the first frame compared: the object is fixed in the hand's frame, and so is the hand.
std::optional<double> compare_object(const fs::path& result_folder, const fs::path& truth_folder,
                                     const ResultFrame& fitted) {
  const fs::path found = result_folder / "object.ply", truth = truth_folder / "object.ply";
  if (!fs::exists(found) || !fs::exists(truth)) return std::nullopt;
  TriangleMesh hand = read_surface(result_folder / "meshes", fitted.name, "fitted");
  const Rigid3d hand_from_world = fitted.pose->world_from_hand.inverse();
  for (Eigen::Vector3d& vertex : hand.vertices) vertex = hand_from_world * vertex;
  constexpr double kReach = 0.01;
  const auto error = held_object_error(read_ply(found), read_ply(truth), hand, kReach);
  return error ? std::optional(kMillimetres * *error) : std::nullopt;
}

double median_of(const std::vector<double>& sorted) {
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

void summarise(Evaluation& evaluation) {
  for (const EvaluationMeasure& measure : evaluation_measures()) {
    std::vector<double> values;
    for (const Evaluation::Frame& frame : evaluation.frames) {
      if (const auto value = measure.get(frame)) values.push_back(*value);
    }
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    measure.set(evaluation.mean, sum / static_cast<double>(values.size()));
    measure.set(evaluation.median, median_of(values));
    measure.set(evaluation.worst, values.back());
  }
}

struct Pair {
  const ResultFrame* fitted;
  const TruthFrame* truth;
};

// The frames that are fitted and known; counts the others.
std::vector<Pair> match_frames(const Result& result, const Truth& truth, Evaluation& evaluation) {
  std::map<std::string, const TruthFrame*> known;
  for (const TruthFrame& frame : truth.frames) known.emplace(frame.name, &frame);
  std::vector<Pair> pairs;
  std::size_t common = 0;
  for (const ResultFrame& frame : result.frames) {
    const auto found = known.find(frame.name);
    if (found != known.end()) ++common;
    if (!frame.pose) {
      ++evaluation.not_fitted_count;
      continue;
    }
    ++evaluation.fitted_count;
    if (frame.status == "ok") ++evaluation.ok_count;
    if (found == known.end()) {
      ++evaluation.without_truth_count;
    } else {
      pairs.push_back({&frame, found->second});
    }
  }
  if (common == 0) {
    throw Error("the result (", result.frames.size(), " frames) and the truth (",
                truth.frames.size(), " frames) have no frame in common, expected some of one name");
  }
  evaluation.not_in_result_count = truth.frames.size() - common;
  return pairs;
}

}  // namespace

// One entry a measure, so that the summary, the table and the JSON cannot leave one out.
#define TEGATA_MEASURE(field, title)                                                  \
  EvaluationMeasure {                                                                 \
#field, title,                                                                    \
        [](const Evaluation::Frame& f) -> std::optional < double>                     \
    { return f.field; }, [](Evaluation::Frame & f, double value) { f.field = value; } \
  }
const std::vector<EvaluationMeasure>& evaluation_measures() {
  static const std::vector<EvaluationMeasure> kMeasures = {
      TEGATA_MEASURE(surface_error_mm, "surface error [mm]"),
      TEGATA_MEASURE(vertex_error_mm, "vertex error [mm]"),
      TEGATA_MEASURE(keypoint_error_mm, "keypoint error [mm]"),
      TEGATA_MEASURE(keypoint_root_relative_mm, "  root-relative [mm]"),
      TEGATA_MEASURE(keypoint_procrustes_mm, "  Procrustes-aligned [mm]"),
      TEGATA_MEASURE(angle_error_deg, "joint angle error [deg]"),
      TEGATA_MEASURE(flexion_error_deg, "flexion error [deg]"),
  };
  return kMeasures;
}
#undef TEGATA_MEASURE

Evaluation evaluate_result(const fs::path& result_folder, const fs::path& truth_folder,
                           int threads) {
  const Result result = read_result_json(result_folder / "result.json");
  const Truth truth = read_truth_json(truth_folder / "truth.json");
  if (result.side != truth.side) {
    throw Error(result_folder.string(), ": got a ", side_name(result.side), " hand, expected the ",
                side_name(truth.side), " one of ", (truth_folder / "truth.json").string());
  }
  Evaluation evaluation;
  evaluation.take = result.take;
  const std::vector<Pair> pairs = match_frames(result, truth, evaluation);
  evaluation.frames.resize(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    const std::string& name = pairs[i].fitted->name;
    const TriangleMesh fitted = read_surface(result_folder / "meshes", name, "fitted");
    const TriangleMesh known = read_surface(truth_folder / "truth", name, "true");
    try {
      evaluation.frames[i] = compare_frame(*pairs[i].fitted, *pairs[i].truth, fitted, known);
    } catch (const Error& error) {
      throw Error(truth_folder.string(), ": frame ", name, ": ", error.what());
    }
  });
  summarise(evaluation);
  if (!pairs.empty()) {
    evaluation.object_error_mm = compare_object(result_folder, truth_folder, *pairs[0].fitted);
  }
  return evaluation;
}

}  // namespace tegata

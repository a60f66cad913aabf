// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tegata {

/// How far a result is from the truth. The measures are those of docs/formats.md, "Truth", each
/// over the frames that have a pose, whatever their status.
struct Evaluation {
  struct Frame {
    std::string name;
    std::string status;
    /// Over what lies on the finger side of the plane through the true wrist across the line to the
    /// true middle MCP joint; the one plane cuts both surfaces.
    double surface_error_mm = 0.0;
    std::optional<double> vertex_error_mm;  ///< only where the meshes share their topology
    double keypoint_error_mm = 0.0;         ///< absolute
    double keypoint_root_relative_mm = 0.0;
    double keypoint_procrustes_mm = 0.0;    ///< after the best turn, shift and scale
    std::optional<double> angle_error_deg;  ///< only where the truth has angles
    double flexion_error_deg = 0.0;
  };
  std::string take;
  std::vector<Frame> frames;            ///< those that were compared, in the order of the result
  std::size_t fitted_count = 0;         ///< in the result with a pose
  std::size_t ok_count = 0;             ///< of these, with status "ok"
  std::size_t without_truth_count = 0;  ///< of these, not in the truth and so not in `frames`
  std::size_t not_fitted_count = 0;     ///< in the result without a pose
  std::size_t not_in_result_count = 0;  ///< in the truth, but not in the result (not asked for)
  /// Over `frames`, or over those that have the measure; name and status are empty. Without meaning
  /// where there are no frames.
  Frame mean, median, worst;
  /// Of what hides the hand, where the hand is within 10 mm of it; absent where the truth or the
  /// result has no object.
  std::optional<double> object_error_mm;
};

/// Compares RESULT with the truth in `truth_folder` (truth.json, truth/ and object.ply), and reads
/// nothing else of the take. Throws Error naming the file for anything missing or malformed, and
/// where the two are of different hands or have no frame in common.
Evaluation evaluate_result(const std::filesystem::path& result_folder,
                           const std::filesystem::path& truth_folder, int threads);

/// A table for people.
std::string evaluation_table(const Evaluation& evaluation);
/// The same for scripts.
std::string evaluation_json(const Evaluation& evaluation);

/// One of the measures: what it is called and where it lies in a frame.
struct EvaluationMeasure {
  const char* key;    ///< in JSON, with its unit
  const char* title;  ///< in the table
  std::optional<double> (*get)(const Evaluation::Frame& frame);
  void (*set)(Evaluation::Frame& frame, double value);
};
/// All measures, in the order of the struct.
const std::vector<EvaluationMeasure>& evaluation_measures();

}  // namespace tegata

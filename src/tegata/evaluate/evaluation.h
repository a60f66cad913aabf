// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tegata {

/// How far a result is from the truth; each figure is a mean over the fitted frames.
struct Evaluation {
  struct Frame {
    std::string name;
    double surface_error_mm = 0.0;
    std::optional<double> vertex_error_mm;   ///< only where the meshes share their topology
    double keypoint_error_mm = 0.0;          ///< absolute
    double keypoint_root_relative_mm = 0.0;
    double keypoint_procrustes_mm = 0.0;
    std::optional<double> angle_error_deg;   ///< only where the truth has angles
    double flexion_error_deg = 0.0;
  };
  std::vector<Frame> frames;
  std::size_t fitted_count = 0;
  std::size_t not_fitted_count = 0;
  /// Means over `frames`; the name is empty.
  Frame mean;
};

/// Compares RESULT with the truth in `truth_folder` (truth.json and truth/), and reads nothing else
/// of the take. The measures are those of docs/formats.md, "Truth".
Evaluation evaluate_result(const std::filesystem::path& result_folder,
                           const std::filesystem::path& truth_folder, int threads);

/// A table for people.
std::string evaluation_table(const Evaluation& evaluation);
/// The same for scripts.
std::string evaluation_json(const Evaluation& evaluation);

}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tegata/evaluate/evaluation.h"

namespace tegata {
namespace {

using nlohmann::ordered_json;

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:>9.2f}", *value) : fmt::format("{:>9}", "-");
}

std::string count_line(std::size_t count, const char* what) {
  return count == 0 ? "" : fmt::format("{} frame{} {}\n", count, count == 1 ? "" : "s", what);
}

ordered_json measures_to_json(const Evaluation::Frame& frame) {
  ordered_json object = ordered_json::object();
  for (const EvaluationMeasure& measure : evaluation_measures()) {
    const auto value = measure.get(frame);
    object[measure.key] = value ? ordered_json(*value) : ordered_json();
  }
  return object;
}

}  // namespace

std::string evaluation_table(const Evaluation& evaluation) {
  std::string table;
  if (!evaluation.frames.empty()) {
    table += fmt::format("{:<26}{:>9}{:>9}{:>9}\n", "", "mean", "median", "worst");
    for (const EvaluationMeasure& measure : evaluation_measures()) {
      table +=
          fmt::format("{:<26}{}{}{}\n", measure.title, cell(measure.get(evaluation.mean)),
                      cell(measure.get(evaluation.median)), cell(measure.get(evaluation.worst)));
    }
  }
  if (evaluation.object_error_mm) {
    table += fmt::format("{:<26}{}\n", "held object [mm]", cell(evaluation.object_error_mm));
  }
  table += fmt::format("{} of {} frames fitted, {} with status ok\n", evaluation.fitted_count,
                       evaluation.fitted_count + evaluation.not_fitted_count, evaluation.ok_count);
  table += count_line(evaluation.without_truth_count, "fitted but not in the truth");
  table += count_line(evaluation.not_in_result_count, "of the truth not in the result");
  return table;
}

std::string evaluation_json(const Evaluation& evaluation) {
  ordered_json root;
  root["format"] = "tegata-evaluation";
  root["version"] = 1;
  root["take"] = evaluation.take;
  root["fitted_count"] = evaluation.fitted_count;
  root["ok_count"] = evaluation.ok_count;
  root["not_fitted_count"] = evaluation.not_fitted_count;
  root["without_truth_count"] = evaluation.without_truth_count;
  root["not_in_result_count"] = evaluation.not_in_result_count;
  const bool any = !evaluation.frames.empty();
  root["mean"] = any ? measures_to_json(evaluation.mean) : ordered_json();
  root["median"] = any ? measures_to_json(evaluation.median) : ordered_json();
  root["worst"] = any ? measures_to_json(evaluation.worst) : ordered_json();
  const auto& object = evaluation.object_error_mm;
  root["object_error_mm"] = object ? ordered_json(*object) : ordered_json();
  root["frames"] = ordered_json::array();
  for (const Evaluation::Frame& frame : evaluation.frames) {
    ordered_json entry;
    entry["frame"] = frame.name;
    entry["status"] = frame.status;
    entry.update(measures_to_json(frame));
    root["frames"].push_back(std::move(entry));
  }
  return root.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace tegata

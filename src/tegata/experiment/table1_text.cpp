// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/experiment/table1_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace tegata {
namespace {

constexpr std::array<std::string_view, kTable1FitCount> kFitTitles = {
    "paper, single frames", "paper, all frames", "default, single frames", "default, all frames"};
constexpr std::array<std::string_view, kTable1Grasps.size()> kGraspTitles = {
    "power (cylinder)", "precision (pinch)", "lateral (plate)"};

std::string table_of(const Table1& table, std::string_view title, double FitError::*measure) {
  std::string text = fmt::format("{:<26}", title);
  for (const std::string_view grasp : kGraspTitles) text += fmt::format("{:>19}", grasp);
  text += fmt::format("\n{:<26}{:>16}{:.1f} to {:.1f}, its three grasps\n", "the paper, Table I",
                      "", kPaperLeast.*measure, kPaperGreatest.*measure);
  for (std::size_t fit = 0; fit < kTable1FitCount; ++fit) {
    text += fmt::format("{:<26}", kFitTitles[fit]);
    for (const auto& of_grasp : table.errors) {
      text += fmt::format("{:>19}", fmt::format("{:.1f} +- {:.1f}", of_grasp[fit].mean.*measure,
                                                of_grasp[fit].deviation.*measure));
    }
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json json_of(const std::vector<FitError>& errors, const ErrorSpread& spread) {
  nlohmann::ordered_json json;
  const auto add = [&](const char* key, double FitError::*measure) {
    nlohmann::ordered_json of_seeds = nlohmann::ordered_json::array();
    for (const FitError& error : errors) of_seeds.push_back(error.*measure);
    json[key] = {{"mean", spread.mean.*measure},
                 {"standard_deviation", spread.deviation.*measure},
                 {"seeds", of_seeds}};
  };
  add("surface_error_mm", &FitError::surface_mm);
  add("angle_error_deg", &FitError::angle_deg);
  return json;
}

}  // namespace

std::string table1_text(const Table1& table) {
  return fmt::format(
             "mean over {} seed{} +- standard deviation, {} frames of three infrared "
             "cameras\n\n",
             table.seed_count, table.seed_count == 1 ? "" : "s", table.frame_count) +
         table_of(table, "surface error [mm]", &FitError::surface_mm) + "\n" +
         table_of(table, "joint angle error [deg]", &FitError::angle_deg);
}

std::string table1_json(const Table1& table) {
  nlohmann::ordered_json json;
  json["experiment"] = "table1";
  json["seeds"] = table.seed_count;
  json["frames"] = table.frame_count;
  json["paper"] = {{"surface_error_mm", {kPaperLeast.surface_mm, kPaperGreatest.surface_mm}},
                   {"angle_error_deg", {kPaperLeast.angle_deg, kPaperGreatest.angle_deg}}};
  for (std::size_t grasp = 0; grasp < kTable1Grasps.size(); ++grasp) {
    auto& of_grasp = json["grasps"][std::string(simulated_grasp_name(kTable1Grasps[grasp]))];
    for (std::size_t fit = 0; fit < kTable1FitCount; ++fit) {
      of_grasp[std::string(table1_fit_name(static_cast<Table1Fit>(fit)))] =
          json_of(table.of_seeds[grasp][fit], table.errors[grasp][fit]);
    }
  }
  json["weights"] = nlohmann::ordered_json::array();
  for (const WeightRecord::Frame& frame : table.weights.frames) {
    json["weights"].push_back(
        {{"frame", frame.name}, {"weights", frame.weights}, {"support", frame.support}});
  }
  return json.dump() + "\n";
}

}  // namespace tegata

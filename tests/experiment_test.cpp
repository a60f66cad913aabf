// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// `tegata experiment` and `tegata fit --method paper` from the outside.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

TEST(Experiment, Table1HasEveryFitAndTheSameBytesForOneAndTwoThreads) {
  const TestFolder folder;
  for (const char* threads : {"1", "2"}) {
    const ProgramRun run =
        run_program({"experiment", "table1", "--seeds", "1", "--frames", "1", "--threads", threads,
                     "-o", (folder / threads).string(), "--json", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, read_text(folder / threads / "table1.json"));
    EXPECT_EQ(names_in(folder / threads), (std::vector<std::string>{"table1.json", "table1.txt",
                                                                    "weights.csv", "weights.svg"}));
  }
  EXPECT_EQ(read_text(folder / "1" / "table1.json"), read_text(folder / "2" / "table1.json"));
  const auto json = nlohmann::json::parse(read_text(folder / "1" / "table1.json"));
  for (const char* grasp : {"cylinder", "pinch", "lateral"}) {
    for (const char* fit : {"paper_single", "paper_all", "default_single", "default_all"}) {
      const double error = json["grasps"][grasp][fit]["surface_error_mm"]["mean"];
      EXPECT_GT(error, 0.0) << grasp << " " << fit;
      EXPECT_LT(error, 20.0) << grasp << " " << fit;
    }
  }
}

TEST(Experiment, AccuracyFitsAndMeasuresEveryGrasp) {
  const TestFolder folder;
  const ProgramRun run =
      run_program({"experiment", "accuracy", "--mode", "clean", "--seeds", "1", "--frames", "1",
                   "-o", (folder / "suite").string(), "--json", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, read_text(folder / "suite" / "accuracy.json"));
  EXPECT_EQ(names_in(folder / "suite"),
            (std::vector<std::string>{"accuracy.json", "accuracy.txt"}));
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["modes"].size(), 1u);
  const auto& takes = json["modes"]["clean"]["takes"];
  ASSERT_EQ(takes.size(), 3u);
  for (const auto& take : takes) {
    EXPECT_GT(take["surface_error_mm"], 0.0) << take;
    EXPECT_LT(take["surface_error_mm"], 5.0) << take;
    EXPECT_GT(take["thumb_error_deg"], 0.0) << take;
  }
  EXPECT_EQ(run_program({"experiment", "accuracy", "--mode", "fog"}).exit_code, 2);
}

TEST(Experiment, PaperMethodFitsATakeFromTheCommandLine) {
  const TestFolder folder;
  const std::string take = (folder / "take").string(), result = (folder / "result").string();
  ASSERT_EQ(
      run_program({"simulate", take, "--mode", "clean", "--frames", "2", "--quiet"}).exit_code, 0);
  const ProgramRun run =
      run_program({"fit", take, "-o", result, "--method", "paper", "--no-report", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Result fitted = read_result_json(folder / "result" / "result.json");
  ASSERT_EQ(fitted.frames.size(), 2u);
  ASSERT_TRUE(fitted.frames[1].pose.has_value());
  EXPECT_EQ(fitted.frames[0].pose->angles, fitted.frames[1].pose->angles);
  EXPECT_EQ(run_program({"fit", take, "-o", result + "2", "--method", "thesis"}).exit_code, 2);
}

}  // namespace
}  // namespace tegata

// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings of real hands through the whole program.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "run_program.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

TEST(Recordings, TwoVideosOfABareHandAreFitted) {
  const fs::path recording = fs::path(TEGATA_DATA_DIR) / "hand_2cam";
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is not there";
  const TestFolder folder;
  const fs::path take = folder / "take", result = folder / "result";
  const std::string convert = text(TEGATA_SOURCE_DIR, "/examples/two_cameras/make_take.sh '",
                                   recording.string(), "' '", take.string(), "' >&2");
  ASSERT_EQ(std::system(convert.c_str()), 0);

  const ProgramRun run = run_program({"fit", take.string(), "-o", result.string(), "--quiet",
                                      "--no-report", "--grasp", "free", "--frames", "60:78:6"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Result fitted = read_result_json(result / "result.json");
  ASSERT_EQ(fitted.frames.size(), 4u);
  std::size_t ok = 0;
  double overlap = 0.0;
  for (const ResultFrame& frame : fitted.frames) {
    if (frame.status != "ok") continue;
    ASSERT_EQ(frame.silhouette_iou.size(), 2u);
    ++ok;
    for (const auto& [camera, iou] : frame.silhouette_iou) overlap += iou / 2.0;
  }
  EXPECT_GE(ok, 3u);
  EXPECT_GE(overlap / static_cast<double>(ok), 0.6);
}

}  // namespace
}  // namespace tegata

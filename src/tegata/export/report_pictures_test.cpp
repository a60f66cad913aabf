// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_pictures.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "tegata/base/random.h"
#include "tegata/export/report_json.h"
#include "tegata/export/test_result.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr std::size_t kFrames = 12, kCameras = 2;

/// Pictures of noise, which JPEG hardly makes smaller; plain ones where `is_plain` says so.
void write_noisy_take(const std::filesystem::path& folder,
                      const std::function<bool(std::size_t)>& is_plain) {
  std::filesystem::create_directories(folder);
  std::ofstream calibration(folder / "calibration.toml");
  Random random(5);
  for (const std::string camera : {"left", "right"}) {
    calibration << "[cam_" << camera << "]\nname = \"" << camera
                << "\"\nsize = [320, 240]\nmatrix = [[200.0, 0.0, 160.0], [0.0, 200.0, 120.0], "
                   "[0.0, 0.0, 1.0]]\ndistortions = [0.0, 0.0, 0.0, 0.0, 0.0]\n"
                   "rotation = [0.0, 0.0, 0.0]\ntranslation = ["
                << (camera == "left" ? 0.0 : -0.3) << ", 0.0, 0.0]\n";
    std::filesystem::create_directories(folder / "images" / camera);
    for (std::size_t i = 0; i < kFrames; ++i) {
      CameraImage picture{Image<std::uint16_t>(kWidth, kHeight, 90, 1), 8};
      for (int y = 0; y < kHeight && !is_plain(i); ++y) {
        for (int x = 0; x < kWidth; ++x) {
          picture.values(x, y) = static_cast<std::uint16_t>(random.uniform(0.0, 255.0));
        }
      }
      write_picture(picture, folder / "images" / camera / (text("frame", i) + ".png"));
    }
  }
}

/// Dots all over, whose outlines take more room than many a picture.
std::vector<std::optional<Silhouette>> dotted(const TakeFrame&) {
  Silhouette dots(kWidth, kHeight, PixelLabel::background);
  for (int y = 2; y < kHeight; y += 8) {
    for (int x = 2; x < kWidth; x += 8) dots(x, y) = PixelLabel::hand;
  }
  return {dots, dots};
}

struct Made {
  std::set<std::size_t> frames;
  std::size_t picture_count = 0, bytes = 0;
  std::vector<std::string> limits;
};

Made pictures_within(const std::filesystem::path& folder, std::size_t most_bytes) {
  Take take = Take::open(folder);
  const HandModel hand =
      built_in_hand(HandShape{}, Side::right, {.cell_size = 0.005, .triangle_count = 300});
  const Result result = test_result(kFrames);
  const ReportPictures pictures =
      make_report_pictures(take, result, hand, dotted, {.most_bytes = most_bytes}, {});
  Made made;
  made.limits = pictures.limits;
  const auto page = nlohmann::json::parse(report_json({result, hand, take.rig(), pictures, {}}));
  for (std::size_t i = 0; i < page["frames"].size(); ++i) {
    if (!page["frames"][i].contains("pictures")) continue;
    made.frames.insert(i);
    for (const auto& picture : page["frames"][i]["pictures"]) {
      ++made.picture_count;
      for (const char* part : {"jpeg", "hand", "silhouette"}) {
        made.bytes += picture[part].get<std::string>().size();
      }
    }
  }
  return made;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + " ";
  return all;
}

TEST(ReportPictures, AllArePutInWholeWhereThereIsRoom) {
  const TestFolder folder;
  write_noisy_take(folder / "take", [](std::size_t) { return true; });
  const Made made = pictures_within(folder / "take", 11'000'000);
  EXPECT_EQ(made.picture_count, kFrames * kCameras);
  EXPECT_TRUE(made.limits.empty()) << joined(made.limits);
}

TEST(ReportPictures, PageKeepsWithinItsBytesAndSaysWhatItLacks) {
  const std::function<bool(std::size_t)> all_noisy = [](std::size_t) { return false; };
  // Those that the size is judged by tell nothing of the others.
  const std::function<bool(std::size_t)> samples_plain = [](std::size_t i) { return i % 3 == 0; };
  for (const auto& is_plain : {all_noisy, samples_plain}) {
    const TestFolder folder;
    const std::filesystem::path take = folder / "take";
    write_noisy_take(take, is_plain);
    constexpr std::size_t kMost = 200'000;
    const Made made = pictures_within(take, kMost);
    EXPECT_LE(made.bytes, kMost);
    EXPECT_GE(made.bytes, kMost / 4) << "far fewer pictures than would fit";
    ASSERT_LT(made.frames.size(), kFrames);
    EXPECT_TRUE(
        says(joined(made.limits), text("Pictures of ", made.frames.size(), " of 12 frames")));
    EXPECT_TRUE(made.frames.contains(kFrames - 1)) << "the frame to doubt most has no pictures";
  }
}

}  // namespace
}  // namespace tegata

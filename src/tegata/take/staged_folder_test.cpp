// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/staged_folder.h"

#include <gtest/gtest.h>

#include <iterator>

#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t entry_count(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(StagedFolder, NothingRemainsWithoutCommit) {
  const TestFolder folder;
  {
    const StagedFolder staged(folder / "result", false);
    write_file(staged.path() / "a.txt", "a");
    EXPECT_FALSE(fs::exists(folder / "result"));
  }
  EXPECT_EQ(entry_count(folder.path()), 0);
}

TEST(StagedFolder, AppearsWholeOnCommitAndLeavesNoSibling) {
  const TestFolder folder;
  {
    StagedFolder staged(folder / "deep/result/", false);
    write_file(staged.path() / "a.txt", "a");
    staged.commit();
  }
  EXPECT_EQ(read_file(folder / "deep/result/a.txt"), "a");
  EXPECT_EQ(entry_count(folder / "deep"), 1);
}

TEST(StagedFolder, AnExistingFolderIsNotTouchedWithoutForce) {
  const TestFolder folder;
  fs::create_directories(folder / "result");
  EXPECT_TRUE(says(error_of([&] { StagedFolder(folder / "result", false); }), "result", "--force"));
  EXPECT_EQ(entry_count(folder.path()), 1);
}

TEST(StagedFolder, ReplacesOnlyAtCommitAndKeepsNothingOfTheOld) {
  const TestFolder folder;
  fs::create_directories(folder / "result");
  write_file(folder / "result/old.txt", "old");
  { const StagedFolder abandoned(folder / "result", true); }
  EXPECT_TRUE(fs::exists(folder / "result/old.txt"));
  StagedFolder staged(folder / "result", true);
  write_file(staged.path() / "new.txt", "new");
  EXPECT_TRUE(fs::exists(folder / "result/old.txt"));
  staged.commit();
  EXPECT_FALSE(fs::exists(folder / "result/old.txt"));
  EXPECT_EQ(read_file(folder / "result/new.txt"), "new");
  EXPECT_EQ(entry_count(folder.path()), 1);
}

TEST(StagedFolder, NeverReplacesAFileOrAFolderWithoutTheMarker) {
  const TestFolder folder;
  write_file(folder / "file", "content");
  EXPECT_TRUE(says(error_of([&] { StagedFolder(folder / "file", true); }), "is a file"));
  fs::create_directories(folder / "take/images");
  EXPECT_TRUE(says(error_of([&] { StagedFolder(folder / "take", true, "result.json"); }), "take",
                   "result.json"));
  write_file(folder / "take/result.json", "{}");
  EXPECT_NO_THROW(StagedFolder(folder / "take", true, "result.json"));
  EXPECT_EQ(entry_count(folder.path()), 2);
}

TEST(StagedFolder, TwoAtOnceDoNotShareTheirStaging) {
  const TestFolder folder;
  StagedFolder one(folder / "result", false);
  StagedFolder other(folder / "result", false);
  EXPECT_NE(one.path(), other.path());
  one.commit();
  EXPECT_TRUE(says(error_of([&] { other.commit(); }), "meanwhile"));
}

TEST(StagedFolder, AParentThatCannotBeMadeIsSaid) {
  const TestFolder folder;
  write_file(folder / "file", "content");
  EXPECT_TRUE(says(error_of([&] { StagedFolder(folder / "file/result", false); }), "file/result",
                   "Not a directory"));
}

TEST(WriteFile, AFullDiskIsSaidWithFileAndReason) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const std::size_t size : {std::size_t{1}, std::size_t{1} << 20}) {
    EXPECT_TRUE(says(error_of([&] { write_file("/dev/full", std::string(size, 'x')); }),
                     "/dev/full", "No space left"));
  }
}

TEST(WriteFile, AMissingFolderIsSaid) {
  const TestFolder folder;
  EXPECT_TRUE(says(error_of([&] { write_file(folder / "no/a.txt", "a"); }), "no/a.txt",
                   "No such file or directory"));
}

TEST(ReadFile, MissingFilesAndFoldersAreSaid) {
  const TestFolder folder;
  EXPECT_TRUE(says(error_of([&] { read_file(folder / "a.txt"); }), "a.txt", "No such file"));
  EXPECT_TRUE(says(error_of([&] { read_file(folder.path()); }), "Is a directory"));
}

TEST(ReadFile, GivesBackWhatWasWrittenWithNulsAndAllLengthsOfBlocks) {
  const TestFolder folder;
  for (const std::size_t size : {0u, 1u, 65535u, 65536u, 65537u, 200000u}) {
    std::string content(size, '\0');
    for (std::size_t i = 0; i < size; ++i) content[i] = static_cast<char>(i * 31 % 256);
    write_file(folder / "a.bin", content);
    EXPECT_EQ(read_file(folder / "a.bin"), content);
  }
}

}  // namespace
}  // namespace tegata

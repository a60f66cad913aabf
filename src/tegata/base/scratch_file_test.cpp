// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/base/scratch_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <string>

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

class ScratchFileTest : public ::testing::Test {
 protected:
  ScratchFileTest()
      : folder_(fs::temp_directory_path() / ("tegata_scratch_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~ScratchFileTest() override { fs::remove_all(folder_); }

  fs::path folder_;
};

std::vector<std::byte> some_bytes(std::size_t seed) {
  std::vector<std::byte> bytes(1000 * seed + 3);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::byte>(i * seed + i / 7);
  return bytes;
}

TEST_F(ScratchFileTest, GivesEachItsOwnBytesBackToAllThreadsAtOnce) {
  ScratchFile file(folder_);
  constexpr std::size_t kCount = 40;
  std::vector<ScratchFile::Place> places;
  for (std::size_t i = 0; i < kCount; ++i) places.push_back(file.append(some_bytes(i)));
  const ScratchFile moved = std::move(file);
  std::vector<int> is_same(kCount, 0);
  parallel_for(kCount, 4,
               [&](std::size_t i) { is_same[i] = moved.read(places[i]) == some_bytes(i) ? 1 : 0; });
  EXPECT_EQ(is_same, std::vector<int>(kCount, 1));
}

TEST_F(ScratchFileTest, LeavesNothingInTheFolderEvenIfTheProcessIsKilled) {
  ScratchFile file(folder_);
  file.append(some_bytes(5));
  EXPECT_TRUE(fs::is_empty(folder_)) << "a name would outlive the process";
}

TEST_F(ScratchFileTest, AFolderThatIsNotThereIsNamedWithTheReason) {
  try {
    ScratchFile file(folder_ / "missing");
    FAIL() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find((folder_ / "missing").string()), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
}

TEST_F(ScratchFileTest, ADiskThatTakesNoMoreIsAnErrorAndNotATornFrame) {
  ScratchFile file(folder_);
  const ScratchFile::Place before = file.append(some_bytes(2));
  // A limit to a file's size stands for the full disk.
  rlimit usual{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &usual), 0);
  const auto usual_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit low{5000, usual.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &low), 0);
  std::string message;
  try {
    file.append(some_bytes(4));
  } catch (const Error& error) {
    message = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, usual_handler);
  EXPECT_NE(message.find(folder_.string()), std::string::npos) << message;
  EXPECT_NE(message.find("File too large"), std::string::npos) << message;
  EXPECT_EQ(file.read(before), some_bytes(2));
}

}  // namespace
}  // namespace tegata

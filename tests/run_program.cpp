// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>

#include "tegata/base/error.h"

namespace tegata {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

std::string content_of(std::FILE* file) {
  std::rewind(file);
  std::string content;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) content += static_cast<char>(c);
  return content;
}

// In the child: only calls that are safe after fork.
[[noreturn]] void become_program(char* const* arguments, int out, int err,
                                 std::optional<std::uint64_t> largest_file) {
  if (largest_file) {
    std::signal(SIGXFSZ, SIG_IGN);  // so that the write fails instead, with EFBIG
    const rlimit limit{*largest_file, *largest_file};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(126);
  }
  const int null = open("/dev/null", O_RDONLY);
  if (dup2(null, STDIN_FILENO) < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(err, STDERR_FILENO) < 0)
    _exit(126);
  execv(arguments[0], arguments);
  _exit(127);
}

}  // namespace

std::vector<std::string> ProgramRun::error_lines() const {
  std::vector<std::string> lines;
  std::istringstream stream(err);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

ProgramRun run_program(const std::vector<std::string>& arguments,
                       std::optional<std::uint64_t> largest_file) {
  std::vector<std::string> words = {TEGATA_PROGRAM_FILE};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const OpenFile out(std::tmpfile()), err(std::tmpfile());
  if (!out || !err) throw Error("temporary file: cannot be made");
  const pid_t child = fork();
  if (child < 0) throw Error("fork: failed");
  if (child == 0)
    become_program(pointers.data(), fileno(out.get()), fileno(err.get()), largest_file);
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw Error("waitpid: failed");
  ProgramRun run;
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = content_of(out.get());
  run.err = content_of(err.get());
  return run;
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file.string(), ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_text(const std::filesystem::path& file, const std::string& content) {
  std::ofstream stream(file, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream) throw Error(file.string(), ": cannot be written");
}

void replace_in_file(const std::filesystem::path& file, const std::string& from,
                     const std::string& to) {
  std::string content = read_text(file);
  const std::size_t at = content.find(from);
  ASSERT_NE(at, std::string::npos) << file << " does not hold '" << from << "'";
  content.replace(at, from.size(), to);
  write_text(file, content);
}

}  // namespace tegata

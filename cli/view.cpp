// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "command.h"
#include "tegata/export/viewer_page.h"

namespace tegata {
namespace view_command {

namespace fs = std::filesystem;

struct Arguments {
  std::string result;
  CommonOptions common;
};

bool has_display() {
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* value = std::getenv(variable);  // NOLINT: nothing here changes the environment
    if (value != nullptr && *value != '\0') return true;
  }
  return false;
}

/// Has the desktop open a file; false where it cannot.
bool open_on_desktop(const fs::path& file) {
  std::string opener = "xdg-open", name = file.string();
  std::array<char*, 3> words = {opener.data(), name.data(), nullptr};
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    // What browsers print is not ours.
    const int null = open("/dev/null", O_RDWR);
    dup2(null, STDIN_FILENO);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    execvp(words[0], words.data());
    _exit(127);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void run(const Arguments& arguments) {
  fs::path page = arguments.result;
  if (fs::is_directory(page)) page /= "report.html";
  if (!fs::exists(page)) {
    require_viewer_page();
    throw Error(page.string(), ": is not there; `tegata report ", arguments.result,
                " --take TAKE` makes it");
  }
  page = fs::absolute(page).lexically_normal();
  const bool opened = has_display() && open_on_desktop(page);
  if (arguments.common.json) {
    std::cout << nlohmann::ordered_json{{"report", page.string()}, {"opened", opened}}.dump()
              << "\n";
  } else if (opened) {
    std::cout << "opened " << page.string() << "\n";
  } else {
    std::cout << "open this in a browser: " << page.string() << "\n";
  }
}

}  // namespace view_command

void add_view_command(CLI::App& program) {
  using namespace view_command;
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("view", "Open the report page of a result");
  command->add_option("RESULT", arguments->result, "Folder that fit made, or a report page")
      ->required();
  add_common_options(*command, arguments->common);
  command->footer("Example: tegata view demo/result\n");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace tegata

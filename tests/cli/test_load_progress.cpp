// SPDX-License-Identifier: MIT
// Loading a large mesh shows a bar on a terminal, and only there.
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>

#include "cli/program.h"

namespace {

using strahl_test::contains;
using strahl_test::Folder;
using Words = std::vector<std::string>;

std::string large_mesh(const Folder& folder) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 80000; ++i) text += "# the same triangle over and over again\nf 1 2 3\n";
  return folder.file("large.obj", text);
}

/// What `strahl ARGUMENTS` shows on a terminal.
std::string on_terminal(const Words& arguments) {
  Words words{STRAHL_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == -1) {
    std::cout << "no terminal can be opened here (is /dev/pts mounted?)" << std::endl;
    std::exit(77);
  }
  if (child == 0) {
    execv(STRAHL_PROGRAM, argv.data());
    _exit(127);
  }
  std::string shown;
  std::array<char, 4096> buffer{};
  // At the end of the child, Linux reports an error instead of the end of the file.
  for (ssize_t got = 0; (got = read(terminal, buffer.data(), buffer.size())) > 0;)
    shown.append(buffer.data(), static_cast<std::size_t>(got));
  close(terminal);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
  return shown;
}

TEST_CASE("a large mesh is shown to load, and the line is wiped") {
  const Folder folder;
  const std::string mesh = large_mesh(folder);
  const std::string shown = on_terminal({"explain", mesh, "--lanes", "1"});
  CHECK(contains(shown, "\rload "));
  CHECK(contains(shown, "large.obj\033[K"));
  CHECK(contains(shown, "\r\033[K"));
  CHECK_FALSE(contains(on_terminal({"explain", mesh, "--lanes", "1", "--no-progress"}), "load "));
  CHECK_FALSE(contains(on_terminal({"explain", mesh, "--lanes", "1", "-q"}), "load "));
}

TEST_CASE("nothing is shown elsewhere") {
  const Folder folder;
  const strahl_test::Outcome outcome = folder.run({"explain", large_mesh(folder), "--lanes", "1"});
  CHECK(outcome.code == 0);
  CHECK_FALSE(contains(outcome.err, "load "));
}

}  // namespace

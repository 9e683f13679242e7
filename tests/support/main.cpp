// SPDX-License-Identifier: MIT
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>

#include "support/needs.h"

int main(int count, char** arguments) {
  Catch::Session session;
  if (const int error = session.applyCommandLine(count, arguments); error != 0) return error;
  for (const auto& [file, path] : strahl::test::Needs::all())
    if (session.configData().testsOrTags == std::vector<std::string>{"[#" + file + "]"} &&
        !std::filesystem::exists(path)) {
      std::printf("skipped: %s is not there\n", path.c_str());
      return 77;
    }
  return session.run();
}

// SPDX-License-Identifier: MIT
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>

#include "support/needs.h"

int main(int count, char** arguments) {
  Catch::Session session;
  if (const int error = session.applyCommandLine(count, arguments); error != 0) return error;
  const std::vector<std::string>& asked = session.configData().testsOrTags;
  for (const auto& [file, path] : strahl::test::Needs::all())
    if (asked.size() == 1 && asked.front().starts_with("[#" + file + "]") && !std::filesystem::exists(path)) {
      std::printf("skipped: %s is not there\n", path.c_str());
      return 77;
    }
  return session.run();
}

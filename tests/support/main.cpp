// SPDX-License-Identifier: MIT
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>

#include "support/needs.h"

int main(int count, char** arguments) {
  for (const std::string& path : strahl::test::Needs::paths())
    if (!std::filesystem::exists(path)) {
      std::printf("skipped: %s is not there\n", path.c_str());
      return 77;
    }
  return Catch::Session().run(count, arguments);
}

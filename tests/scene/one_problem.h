// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "scene/validate.h"

namespace strahl::test {

/// Validation finds one thing wrong, and says so in these words.
inline void check_one_problem(const Scene& scene, const std::string& words) {
  const std::vector<Diagnostic> found = validate(scene);
  INFO(words);
  REQUIRE(found.size() == 1);
  CHECK(found[0].message.find(words) != std::string::npos);
}

}  // namespace strahl::test

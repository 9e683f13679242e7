// SPDX-License-Identifier: MIT
// What the environment asks of a test that can be long.
#pragma once

#include <cstdlib>
#include <string>

namespace strahl::test {

/// The number that the variable states, 1e9 for example; else otherwise.
[[nodiscard]] inline double count_asked_for(const char* variable, double otherwise) {
  const char* stated = std::getenv(variable);
  return stated == nullptr ? otherwise : std::stod(stated);
}

/// The device that STRAHL_DEVICE names; else PoCL.
[[nodiscard]] inline std::string device_asked_for() {
  const char* stated = std::getenv("STRAHL_DEVICE");
  return stated == nullptr ? "pocl" : stated;
}

/// Whether a test of many scenes asks the program with every effect, which tests share and test_generic holds to those
/// of scenes: true, but with STRAHL_OWN_PROGRAMS, which entries of the label slow set.
[[nodiscard]] inline bool asks_generic() { return std::getenv("STRAHL_OWN_PROGRAMS") == nullptr; }

}  // namespace strahl::test

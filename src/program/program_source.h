// SPDX-License-Identifier: MIT
// What a device's compiler is given.
#pragma once

#include <string>

namespace strahl {

/// Everything that decides what a program computes.
struct ProgramSource {
  std::string text;     ///< Complete OpenCL C, includes expanded.
  std::string options;  ///< Build options.
};

}  // namespace strahl

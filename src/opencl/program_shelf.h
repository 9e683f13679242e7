// SPDX-License-Identifier: MIT
// The programs that a device has built lately, for whoever asks again: a second scene that calls for the same effects
// needs no more than its buffers.
#pragma once

#include <list>
#include <mutex>
#include <string>

#include "opencl/program.h"

namespace strahl {

class ProgramShelf {
 public:
  /// The program of this source, from build_program where it is not here. Threads may ask at once, and wait for each
  /// other. Throws what build_program does; what fails is asked for again.
  [[nodiscard]] cl::Program get(const Device& device, const ProgramSource& source, ProgramReport* report);

  /// What is kept at most; the one asked for longest ago goes first.
  static constexpr std::size_t most = 32;

 private:
  struct Built {
    ProgramSource source;
    cl::Program program;
    std::size_t binary_bytes;
  };
  std::mutex mutex_;
  std::list<Built> built_;  ///< The latest first.
};

}  // namespace strahl

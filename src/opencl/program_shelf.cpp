// SPDX-License-Identifier: MIT
#include "opencl/program_shelf.h"

#include <algorithm>

namespace strahl {

cl::Program ProgramShelf::get(const Device& device, const ProgramSource& source, ProgramReport* report) {
  const std::scoped_lock lock(mutex_);
  const auto found = std::find_if(built_.begin(), built_.end(), [&](const Built& built) {
    return built.source.options == source.options && built.source.text == source.text;
  });
  if (found != built_.end()) {
    built_.splice(built_.begin(), built_, found);
    if (report != nullptr) *report = {0, true, built_.front().binary_bytes};
    return built_.front().program;
  }
  ProgramReport how;
  cl::Program program = build_program(device, source, &how);
  built_.push_front({source, program, how.binary_bytes});
  if (built_.size() > most) built_.pop_back();
  if (report != nullptr) *report = how;
  return program;
}

cl::Program program_on(const Device& device, const ProgramSource& source, ProgramReport* report, bool is_cached) {
  return is_cached ? device.programs().get(device, source, report) : build_program(device, source, report, false);
}

}  // namespace strahl

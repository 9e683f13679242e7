// SPDX-License-Identifier: MIT
#include "trust/canary_loops.h"

#include <algorithm>

#include "packing/scene_buffers.h"

namespace strahl {
namespace {

/// Steps of the kernel's generator from 0 to that state; 0 where it is not met within `most`.
std::uint64_t steps_to(std::uint32_t state, std::uint64_t most) {
  std::uint32_t x = 0;
  for (std::uint64_t step = 0; step <= most; ++step, x = x * 1664525u + 1013904223u)
    if (x == state) return step;
  return 0;
}

}  // namespace

std::optional<std::uint64_t> LoopTurns::limit() const {
  std::optional<std::uint64_t> least;
  for (std::size_t i = 0; i < loop_cases.size(); ++i)
    if (made[i] < loop_cases[i].turns()) least = std::min(least.value_or(made[i]), made[i]);
  return least;
}

bool LoopTurns::can_be_told() const {
  for (std::size_t i = 0; i < loop_cases.size(); ++i)
    if (are_whole[i] != (made[i] == loop_cases[i].turns())) return false;
  return true;
}

LoopTurns turns_made(const Device& device, const cl::Program& program) {
  std::array<cl_uint, 2 * loop_cases.size()> turns{};
  std::array<cl_uint, 2 * loop_cases.size()> states{};
  for (std::size_t i = 0; i < loop_cases.size(); ++i) {
    turns[2 * i] = loop_cases[i].outer;
    turns[2 * i + 1] = loop_cases[i].inner;
  }
  const cl::Buffer turns_buffer = allocate(device, sizeof turns, "the canary");
  const cl::Buffer state_buffer = allocate(device, sizeof states, "the canary");
  write_buffer(device, turns_buffer, turns.data(), sizeof turns);
  checked(device.info().text(), [&] {
    cl::Kernel kernel(program, "canary_loops");
    kernel.setArg(0, turns_buffer);
    kernel.setArg(1, state_buffer);
    device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(loop_cases.size()), cl::NDRange(1));
    device.queue().finish();
  });
  read_buffer(device, state_buffer, states.data(), sizeof states);
  LoopTurns result;
  for (std::size_t i = 0; i < loop_cases.size(); ++i) {
    result.made[i] = steps_to(states[2 * i], loop_cases[i].turns());
    result.are_whole[i] = states[2 * i + 1] != 0;
  }
  return result;
}

}  // namespace strahl

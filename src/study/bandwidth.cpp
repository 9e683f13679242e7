// SPDX-License-Identifier: MIT
#include "study/bandwidth.h"

#include <algorithm>
#include <vector>

#include "opencl/program.h"
#include "packing/scene_buffers.h"
#include "program/program_text.h"
#include "stopwatch.h"

namespace strahl {
namespace {

constexpr std::size_t largest_group = 64;
constexpr std::size_t reals_per_item = 256;
constexpr std::size_t group_reals = largest_group * reals_per_item;
constexpr int rounds = 5;

/// Seconds of the fastest round, after one that does not count.
template <typename Run>
double fastest(Run run) {
  run();
  double best = 0;
  for (int round = 0; round < rounds; ++round) {
    const Stopwatch start;
    run();
    best = round == 0 ? start.seconds() : std::min(best, start.seconds());
  }
  return best;
}

}  // namespace

Bandwidth measure_bandwidth(const Device& device) {
  const int lanes = default_lanes(device.info().native_vector_width, Precision::stable);
  const cl::Program program = build_program(
      device, program_source("kernels/bandwidth.cl", features_of(Scene{}, RenderSettings{}), Precision::stable, lanes));
  const std::uint64_t most = std::min<std::uint64_t>(std::uint64_t{1} << 28, device.info().max_allocation / 4);
  const std::size_t groups = std::max<std::size_t>(1, most / sizeof(float) / group_reals);
  const std::size_t reals = groups * group_reals, bytes = reals * sizeof(float), items = groups * largest_group;
  const cl::Buffer in = allocate(device, bytes, "the bandwidth test"),
                   other = allocate(device, bytes, "the bandwidth test"),
                   out = allocate(device, items * sizeof(float), "the bandwidth test");
  write_buffer(device, in, std::vector<float>(reals, 1.0F).data(), bytes);

  return checked(device.info().text(), [&] {
    cl::Kernel kernel(program, "bandwidth");
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    kernel.setArg(2, static_cast<cl_int>(reals_per_item) / lanes);
    const std::size_t group = group_size(device, kernel, largest_group);
    const double read = fastest([&] {
      device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items), cl::NDRange(group));
      device.queue().finish();
    });
    const double copy = fastest([&] {
      device.queue().enqueueCopyBuffer(in, other, 0, 0, bytes);
      device.queue().finish();
    });
    std::vector<float> sums(items);
    read_buffer(device, out, sums.data(), items * sizeof(float));
    for (const float sum : sums)
      if (sum != static_cast<float>(reals_per_item))
        throw DeviceError("bandwidth", 0, device.info().text(), "the device does not sum what it reads");
    return Bandwidth{static_cast<double>(bytes) / read, static_cast<double>(bytes) / copy};
  });
}

}  // namespace strahl

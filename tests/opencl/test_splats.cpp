// SPDX-License-Identifier: MIT
// Splats that many work-items add to the same words at once (cl/film/splat.h): the sums are the host's, on PoCL and
// llvmpipe, by atomic additions of 64 bits and by two of 32 with a carry.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "cl/math_tiers.h"
#include "opencl/program.h"
#include "program/kernel_source.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

/// Of all values together. in_halves: as where the device has no atomic addition of 64 bits.
SplatWords sum_on(const std::string& selector, bool in_halves, const std::vector<float>& values) {
  KernelFiles files = kernel_files();
  files["kernels/splats.cl"] =
      "#include \"film/splat.h\"\n"
      "KERNEL void splats(GLOBAL const float* values, GLOBAL uint* counters, GLOBAL long* words) {\n"
      "  Scene scene;\n  scene.counters = counters;\n"
      "  splat_channel(&scene, words, values[get_global_id(0)]);\n}\n";
  const std::string text = "#define REAL_BITS 32\n#define HAS_LIGHT_PATHS 1\n#define HAS_LOOP_LIMIT 0\n" +
                           std::string(in_halves ? "#undef cl_khr_int64_base_atomics\n" : "") +
                           expand_kernel(files, "kernels/splats.cl", {});
  const Device device = Device::open(selector);
  cl::Kernel kernel(build_program(device, {text, ""}), "splats");
  std::vector<float> given = values;
  std::vector<std::uint32_t> counters(64, 0);
  SplatWords words{};
  const auto upload = [&](auto& from) {
    return cl::Buffer(device.context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, from.size() * sizeof from[0],
                      from.data());
  };
  const std::array buffers{upload(given), upload(counters), upload(words)};
  for (std::size_t i = 0; i < buffers.size(); ++i) kernel.setArg(static_cast<cl_uint>(i), buffers.at(i));
  device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(values.size()), cl::NDRange(16));
  device.queue().enqueueReadBuffer(buffers.back(), CL_TRUE, 0, sizeof words, words.data());
  return words;
}

}  // namespace

TEST_CASE("splats of many work-items add up, with and without atomic additions of 64 bits") {
  require_pocl_and_rusticl();
  std::mt19937 random(9);
  std::vector<float> values;
  // Positive ones and both signs; alike, so that lower halves overflow in step; of all sizes.
  for (const int kind : {0, 1, 2}) {
    values.clear();
    while (values.size() < 65536) {
      const auto bits = static_cast<std::uint32_t>(random());
      const float any = std::bit_cast<float>(bits), alike = kind == 0 ? 0x1.fffffep-21F : -0x1.234566p-20F;
      if (kind < 2)
        values.push_back(bits % 8 == 0 ? -alike : alike);
      else if (std::isfinite(any))
        values.push_back(any);
    }
    SplatWords expected{};
    std::array<std::uint32_t, 4> counts{};
    for (const float value : values) add_splat(expected, value, &counts);
    for (const char* device : {"pocl", "llvmpipe"})
      for (const bool in_halves : {false, true}) {
        CAPTURE(kind, device, in_halves);
        CHECK(sum_on(device, in_halves, values) == expected);
      }
  }
}

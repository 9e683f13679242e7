// SPDX-License-Identifier: MIT
// Functions of cl/ on PoCL in single precision against what they are defined to be: random numbers, the film's sums
// (rusticl's, too), angles, lengths, the wave of a checkerboard. tests/cl/ asks the same of the host in full. 1 s.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "cl/math_tiers.h"
#include "opencl/program.h"
#include "program/kernel_source.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const std::string lane = "#define LANES 1\n#include \"lanes/lane_ops.h\"\n";
const std::string checkerboard = lane + "#include \"math/vec3_lanes.h\"\n#include \"math/sampling_lanes.h\"\n" +
                                 "#include \"scene/scene.h\"\n#include \"textures/place_lanes.h\"\n" +
                                 "#include \"textures/checkerboard_lanes.h\"\n";

/// The values of `expression` in the floats x and y, the integer bits and two longs `work`, with `includes` before it.
template <class Value>
std::vector<Value> values(const std::string& includes, const std::string& type, const std::string& expression,
                          const std::vector<float>& x, const std::vector<float>& y,
                          const std::vector<std::uint32_t>& bits = {}, const std::string& selector = "pocl") {
  KernelFiles files = kernel_files();
  files["kernels/functions.cl"] = includes +
                                  "KERNEL void functions(GLOBAL const float* xs, GLOBAL const float* ys, GLOBAL const "
                                  "uint* all_bits, GLOBAL uint* counters, GLOBAL long* all_work, GLOBAL " +
                                  type +
                                  "* out) {\n"
                                  "  int i = (int)get_global_id(0);\n  float x = xs[i], y = ys[i];\n"
                                  "  uint bits = all_bits[i];\n  GLOBAL long* work = all_work + 2 * i;\n"
                                  "  (void)x; (void)y; (void)bits; (void)counters; (void)work;\n"
                                  "  out[i] = " +
                                  expression + ";\n}\n";
  const std::string text = "#define REAL_BITS 32\n" + expand_kernel(files, "kernels/functions.cl", {});
  const Device device = Device::open(selector);
  cl::Kernel kernel(build_program(device, {text, ""}), "functions");
  const std::size_t count = std::max(x.size(), bits.size());
  std::vector<float> all_x = x, all_y = y;
  std::vector<std::uint32_t> all_bits = bits;
  all_x.resize(count);
  all_y.resize(count);
  all_bits.resize(count);
  const auto upload = [&](auto& from) {
    return cl::Buffer(device.context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, from.size() * sizeof from[0],
                      from.data());
  };
  std::vector<std::uint32_t> counters(count, 0);
  std::vector<std::int64_t> work(2 * count, 0);
  std::vector<Value> result(count);
  const std::array buffers{upload(all_x),    upload(all_y), upload(all_bits),
                           upload(counters), upload(work),  upload(result)};
  for (std::size_t i = 0; i < buffers.size(); ++i) kernel.setArg(static_cast<cl_uint>(i), buffers.at(i));
  device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count), cl::NDRange(1));
  device.queue().enqueueReadBuffer(buffers.back(), CL_TRUE, 0, count * sizeof(Value), result.data());
  return result;
}

double ulps(float value, double truth) {
  int exponent;
  std::frexp(truth, &exponent);
  return std::fabs(static_cast<double>(value) - truth) / std::ldexp(1.0, exponent - 24);
}

}  // namespace

TEST_CASE("random numbers lie below 1, whatever their bits") {
  require_pocl_and_rusticl();
  const std::vector<std::uint32_t> bits = {0,          1,          0xff,       0x100,      0x7fffffff,
                                           0x80000000, 0xffffff00, 0xffffff7f, 0xffffff80, 0xffffffff};
  const auto units =
      values<float>(lane + "#include \"math/rng_lanes.h\"\n", "float", "random_unit_w_1(bits)", {}, {}, bits);
  for (std::size_t i = 0; i < bits.size(); ++i) CHECK(units[i] == std::ldexp(static_cast<float>(bits[i] >> 8), -24));
}

TEST_CASE("the film adds as on the host, whatever a device does to small numbers") {
  require_pocl_and_rusticl();
  const std::vector<float> numbers{
      0,         1.0F,     -0.1F,           0x1p-149F, -0x1.8p-130F, 0x1.fffffcp-127F, 0x1p-20F, 0x1.7ffffep-21F,
      3.3e19F,   -1e13F,   0x1.fffffep127F, INFINITY,  NAN,          0x1.fffffep19F,   -0x1p20F, 1e-30F,
      0x1p-126F, -INFINITY};
  std::vector<float> x, y;
  for (const float a : numbers)
    for (const float b : numbers) {
      x.push_back(a);
      y.push_back(b);
    }
  const std::string sum =
      "#include \"film/film.h\"\n"
      "FN long2 film_sum(GLOBAL uint* counters, GLOBAL long* sum, real x, real y) {\n"
      "  Scene scene;\n  scene.counters = counters;\n"
      "  film_add_sample(&scene, sum, x);\n  film_add_sample(&scene, sum, y);\n"
      "  return (long2)(sum[0], sum[1]);\n}\n";
  for (const char* device : {"pocl", "llvmpipe"}) {
    const auto sums = values<FilmWords>(sum, "long2", "film_sum(counters, work, x, y)", x, y, {}, device);
    for (std::size_t i = 0; i < x.size(); ++i) {
      FilmWords expected{};
      std::array<std::uint32_t, 4> counts{};
      add_to_film(expected, x[i], &counts);
      add_to_film(expected, y[i], &counts);
      CAPTURE(device, x[i], y[i]);
      REQUIRE(sums[i] == expected);
    }
  }
}

TEST_CASE("angles are right to the last places") {
  require_pocl_and_rusticl();
  std::vector<float> x, y;
  for (int i = 0; i < 60000; ++i) {
    x.push_back(static_cast<float>(std::sin(i * 0.7)) * std::exp2(static_cast<float>(i % 9 - 4)));
    y.push_back(static_cast<float>(std::cos(i * 1.3 + 0.1)));
  }
  const std::string include = "#include \"portable.h\"\n#include \"math/angle.h\"\n";
  const auto angles = values<float>(include, "float", "atan2_turns(y, x)", x, y);
  const auto sines =
      values<float>(lane + "#include \"math/sincos_lanes.h\"\n", "float", "sincos_turns_w_1(x).sine", x, y);
  double worst_angle = 0, worst_sine = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double turns = std::atan2(static_cast<double>(y[i]), static_cast<double>(x[i])) / (2 * std::numbers::pi);
    worst_angle = std::max(worst_angle, ulps(angles[i], turns < 0 ? turns + 1 : turns));
    const double part = static_cast<double>(x[i]) - std::round(static_cast<double>(x[i]));
    if (part == 0 || std::fabs(part) == 0.5) continue;
    worst_sine = std::max(worst_sine, ulps(sines[i], std::sin(2 * std::numbers::pi * part)));
  }
  CHECK(worst_angle <= 1.75);
  CHECK(worst_sine <= 0.8);
}

TEST_CASE("lengths neither over- nor underflow") {
  require_pocl_and_rusticl();
  const std::vector<float> x = {3, 3e-30F, 3e30F, 1e-20F, 1e38F}, y = {4, 4e-30F, -4e30F, 0, 1e38F};
  const auto lengths = values<float>("#include \"math/vec3.h\"\n", "float", "length3(vec3(x, y, R(0.0)))", x, y);
  for (std::size_t i = 0; i < x.size(); ++i)
    CHECK(ulps(lengths[i], std::hypot(static_cast<double>(x[i]), static_cast<double>(y[i]))) < 3);
}

TEST_CASE("a checkerboard goes on below 0") {
  require_pocl_and_rusticl();
  const std::vector<float> x = {0.25F, 0.75F, 1.25F, -0.25F, -0.75F, -1.25F, -7.625F, 100.125F};
  const auto wave = values<float>(checkerboard, "float", "checker_wave_w_1(x, R(0.0))", x, {});
  for (std::size_t i = 0; i < x.size(); ++i) {
    INFO(x[i]);
    CHECK(wave[i] == (x[i] - std::floor(x[i]) > 0.5F ? -1 : 1));
  }
}

TEST_CASE("a checkerboard fades to even grey") {
  require_pocl_and_rusticl();
  // Over any box that is a whole number of periods wide the mean is 0, and where neighbours are more than 1 apart too,
  // and under what is infinite: also where a rate of 0 makes NaN of it.
  const std::vector<float> x = {0.1F, 0.6F, -7.3F, 100.9F, 0x1.123456p24F, -0x1.654321p30F, 0.1F, 0.6F},
                           width = {1, 2, 7, 3, 0, 0, INFINITY, NAN};
  const auto wave = values<float>(checkerboard, "float", "checker_wave_w_1(x, y)", x, width);
  for (std::size_t i = 0; i < x.size(); ++i) {
    INFO(x[i]);
    CHECK(std::fabs(wave[i]) < 0.01F);
  }
}

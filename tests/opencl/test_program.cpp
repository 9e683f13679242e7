// SPDX-License-Identifier: MIT
// Programs on PoCL, rusticl and whatever else is there: building, caching, and what a failure tells.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "opencl/own_cache.h"
#include "opencl/program.h"
#include "opencl/program_cache.h"
#include "opencl/program_shelf.h"
#include "program/kernel_source.h"
#include "support/devices.h"

using namespace strahl;
using Catch::Contains;
using strahl::test::OwnCache;
namespace fs = std::filesystem;

namespace {

const ProgramSource twice = {"__kernel void twice(__global int* a) { a[get_global_id(0)] *= FACTOR; }", "-DFACTOR=2"};

int run_twice(const Device& device, const cl::Program& program) {
  int value = 21;
  cl::Kernel kernel(program, "twice");
  const cl::Buffer buffer(device.context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, sizeof value, &value);
  kernel.setArg(0, buffer);
  device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1), cl::NDRange(1));
  device.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, sizeof value, &value);
  return value;
}

/// Builds, runs and checks; whether the binary came from the cache.
bool cached(const Device& device, const ProgramSource& source = twice, int expected = 42) {
  ProgramReport report;
  const cl::Program program = build_program(device, source, &report);
  CHECK(run_twice(device, program) == expected);
  CHECK(report.binary_bytes > 0);
  CHECK(report.seconds > 0);
  return report.from_cache;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

}  // namespace

TEST_CASE("A program is built once and then taken from the cache") {
  test::require_pocl_and_rusticl();
  for (const std::string& selector : test::present_devices()) {
    INFO(selector);
    const OwnCache cache;
    const Device device = Device::open(selector);
    CHECK_FALSE(cached(device));
    CHECK(cache.files().size() == 1);
    CHECK(cached(device));
    CHECK_FALSE(cached(device, {twice.text, "-DFACTOR=3"}, 63));
    CHECK_FALSE(cached(device, {twice.text + "\n", twice.options}));
    CHECK(cache.files().size() == 3);
    CHECK(clear_program_cache() == 3);
    CHECK(cache.files().empty());
    CHECK_FALSE(cached(device));
  }
}

TEST_CASE("What a device has built it does not build again") {
  test::require_pocl_and_rusticl();
  for (const std::string selector : {"pocl", "llvmpipe"}) {
    INFO(selector);
    const OwnCache cache;
    const Device device = Device::open(selector), copy = device;
    ProgramReport report;
    const cl::Program program = program_on(device, twice, &report);
    CHECK_FALSE(report.from_cache);
    const std::size_t bytes = report.binary_bytes;
    CHECK(clear_program_cache() == 1);
    CHECK(program_on(copy, twice, &report)() == program());
    CHECK(report.from_cache);
    CHECK(report.binary_bytes == bytes);
    CHECK(cache.files().empty());
    CHECK(run_twice(device, program_on(device, {twice.text, "-DFACTOR=3"})) == 63);
    CHECK(run_twice(device, program_on(device, {twice.text + "\n", twice.options}, &report)) == 42);
    CHECK_FALSE(report.from_cache);
    CHECK(program_on(device, twice, &report, false)() != program());
    CHECK_FALSE(report.from_cache);
    CHECK_THROWS_AS(program_on(device, {"no program", ""}), KernelBuildError);
    CHECK_THROWS_AS(program_on(device, {"no program", ""}), KernelBuildError);
    CHECK(program_on(device, twice)() == program());
  }
}

TEST_CASE("A device forgets the program that was asked for longest ago") {
  test::require_pocl_and_rusticl();
  const OwnCache cache;
  const Device device = Device::open("pocl");
  const auto numbered = [](std::size_t i) { return ProgramSource{twice.text, "-DFACTOR=" + std::to_string(i)}; };
  const auto is_there = [&](std::size_t i) {
    static_cast<void>(clear_program_cache());
    ProgramReport report;
    static_cast<void>(program_on(device, numbered(i), &report));
    return report.from_cache;
  };
  for (std::size_t i = 0; i < ProgramShelf::most; ++i) CHECK_FALSE(is_there(i));
  CHECK(is_there(0));
  CHECK_FALSE(is_there(ProgramShelf::most));
  CHECK(is_there(0));
  CHECK_FALSE(is_there(1));
}

TEST_CASE("Devices do not share binaries") {
  test::require_pocl_and_rusticl();
  const OwnCache cache;
  CHECK_FALSE(cached(Device::open("pocl")));
  CHECK_FALSE(cached(Device::open("llvmpipe")));
  CHECK(cache.files().size() == 2);
}

TEST_CASE("A damaged cache file is built anew and replaced") {
  test::require_pocl_and_rusticl();
  for (const std::string selector : {"pocl", "llvmpipe"}) {
    INFO(selector);
    const OwnCache cache;
    const Device device = Device::open(selector);
    CHECK_FALSE(cached(device));
    const fs::path file = cache.files().at(0);
    const std::string whole = bytes_of(file);
    std::string flipped = whole;
    flipped[whole.size() - 20] = static_cast<char>(flipped[whole.size() - 20] ^ 1);
    std::string other_magic = whole;
    other_magic[0] = 'S';
    for (const std::string& damaged :
         {std::string(), whole.substr(0, 20), whole.substr(0, whole.size() / 2), flipped, other_magic, whole + "x"}) {
      INFO(damaged.size());
      write(file, damaged);
      CHECK_FALSE(cached(device));
      CHECK(cached(device));
    }
  }
}

// On PoCL only: rusticl (Mesa 22.3) ends the process when it is given such a binary.
TEST_CASE("A binary that the driver rejects is built from source") {
  test::require_pocl_and_rusticl();
  const OwnCache cache;
  const Device device = Device::open("pocl");
  CHECK_FALSE(cached(device));
  // A file that is whole and for this key, but holds no binary.
  const std::string whole = bytes_of(cache.files().at(0));
  const std::string name = program_hash(twice);
  const std::string key = whole.substr(32, whole.find(twice.text) + twice.text.size() - 32);
  REQUIRE_FALSE(read_cached_binary(name, key).empty());
  write_cached_binary(name, key, {'n', 'o', ' ', 'b', 'i', 'n', 'a', 'r', 'y'});
  REQUIRE(read_cached_binary(name, key).size() == 9);
  CHECK_FALSE(cached(device));
  CHECK(cached(device));
}

TEST_CASE("A cache that cannot be written is no error") {
  test::require_pocl_and_rusticl();
  const OwnCache cache;
  write(cache.directory() / "file", "");
  setenv("STRAHL_CACHE_DIR", (cache.directory() / "file" / "below").c_str(), 1);
  const Device device = Device::open("pocl");
  CHECK_FALSE(cached(device));
  CHECK_FALSE(cached(device));
  CHECK(clear_program_cache() == 0);
}

TEST_CASE("A kernel that does not build is reported with place, options, log and source") {
  test::require_pocl_and_rusticl();
  for (const std::string& selector : test::present_devices()) {
    INFO(selector);
    const OwnCache cache;
    const Device device = Device::open(selector);
    const KernelFiles files = {{"kernels/render.cl", "#include \"shapes/sphere/sphere.h\"\n__kernel void k(void) {}\n"},
                               {"shapes/sphere/sphere.h", "// ok\nint radius(void) {\n  return undeclared_name;\n}\n"}};
    const ProgramSource source = {"// prelude\n" + expand_kernel(files, "kernels/render.cl", {}), "-DSEEN=1"};
    try {
      (void)build_program(device, source);
      FAIL("it was built");
    } catch (const KernelBuildError& error) {
      const std::string message = error.what();
      CHECK_THAT(message, Contains("clBuildProgram failed with CL_BUILD_PROGRAM_FAILURE on " + device.info().text()));
      CHECK_THAT(message, Contains("options: -DSEEN=1"));
      CHECK_THAT(message, Contains("shapes/sphere/sphere.h:3:"));
      CHECK_THAT(message, Contains("undeclared_name"));
      CHECK(error.code() == CL_BUILD_PROGRAM_FAILURE);
      CHECK(error.exit_code() == ExitCode::kernel_build);
      const fs::path dumped = cache.directory() / (program_hash(source) + ".failed.cl");
      CHECK_THAT(message, Contains(dumped.string()));
      CHECK(bytes_of(dumped) == completed_for(device, source).text);
    }
    CHECK(clear_program_cache() == 0);
    CHECK(cache.files().empty());
  }
}

TEST_CASE("The hash of a program is FNV-1a of text and options, kept apart") {
  CHECK(fnv1a("") == 0xcbf29ce484222325u);
  CHECK(fnv1a("foobar") == 0x85944171f73967e8u);
  CHECK(program_hash({"", ""}) == "af63bd4c8601b7df");
  CHECK(program_hash(twice) == program_hash(twice));
  CHECK(program_hash({"ab", "c"}) != program_hash({"a", "bc"}));
}

TEST_CASE("The cache directory follows the environment") {
  const OwnCache cache;
  CHECK(program_cache_directory() == cache.directory());
  unsetenv("STRAHL_CACHE_DIR");
  const char* home = std::getenv("HOME");
  const std::string old_home = home == nullptr ? "" : home;
  setenv("HOME", "/srv/somebody", 1);
  setenv("XDG_CACHE_HOME", "/cache", 1);
  CHECK(program_cache_directory() == "/cache/strahl");
  setenv("XDG_CACHE_HOME", "relative", 1);
  CHECK(program_cache_directory() == "/srv/somebody/.cache/strahl");
  unsetenv("XDG_CACHE_HOME");
  CHECK(program_cache_directory() == "/srv/somebody/.cache/strahl");
  unsetenv("HOME");
  CHECK(program_cache_directory().empty());
  CHECK(clear_program_cache() == 0);
  setenv("HOME", old_home.c_str(), 1);
}

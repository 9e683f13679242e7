// SPDX-License-Identifier: MIT
// Building OpenCL programs, first from the cached binary, else from source.
#include "opencl/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "opencl/cl_code.h"
#include "opencl/compiling.h"
#include "opencl/program_cache.h"

namespace strahl {

namespace {

/// Everything that a binary depends on.
std::string cache_key(const Device& device, const ProgramSource& source) {
  return fmt::format("{}\noptions {}\n{}", driver_key(device), source.options, source.text);
}

/// Empty where the driver does not take the binary: it may, whatever the key says.
std::optional<cl::Program> build_binary(const Device& device, const ProgramSource& source,
                                        const std::vector<unsigned char>& binary) {
  try {
    cl::Program program(device.context(), {device.device()}, cl::Program::Binaries{binary});
    program.build(device.device(), source.options.c_str());
    return program;
  } catch (const cl::Error&) {
    return std::nullopt;
  }
}

/// Whether the robust tier goes beyond single precision in doubles. The bits do not depend on it.
bool takes_doubles(const Device& device) {
  const char* words = std::getenv("STRAHL_DOUBLE_WORDS");
  return device.info().fp64 && (words == nullptr || std::string_view(words) != "1");
}

/// name: of the program, as `explain` prints it.
cl::Program build_text(const Device& device, const ProgramSource& source, const std::string& program_name) {
  const Compiling compiling;
  const std::string name = device.info().text();
  cl::Program program = checked(name, [&] { return cl::Program(device.context(), source.text); });
  try {
    program.build(device.device(), source.options.c_str());
  } catch (const cl::Error& error) {
    const std::string log = checked(name, [&] { return program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.device()); });
    throw KernelBuildError(fmt::format("{} failed with {} on {}\noptions: {}\nsource: {}\nbuild log:\n{}", error.what(),
                                       cl_code_name(error.err()), name, source.options,
                                       keep_failed_program(program_name, source.text), log),
                           error.err());
  }
  return program;
}

}  // namespace

/// OpenCL lets fp32 divisions and square roots be off by 2.5 and 3 ulp unless a program asks otherwise, which only some
/// devices take. PoCL, Intel's runtime and llvmpipe round correctly either way.
ProgramSource completed_for(const Device& device, ProgramSource source) {
  if (device.info().correctly_rounded_option) {
    const std::string option = " -cl-fp32-correctly-rounded-divide-sqrt";
    source.options += option;
    // The first line of strahl's own programs states them.
    if (source.text.starts_with("//")) source.text.insert(source.text.find('\n'), option);
  }
  // Below the first line, which says what the program is.
  std::string has;
  if (!device.info().fma) has += "#define SOFT_FMA 1\n";
  if (takes_doubles(device)) has += "#define WIDE_IS_DOUBLE 1\n";
  source.text.insert(source.text.find('\n') + 1, has);
  return source;
}

std::string driver_key(const Device& device) {
  const DeviceInfo& info = device.info();
  return checked(info.text(), [&] {
    const cl::Platform platform(device.device().getInfo<CL_DEVICE_PLATFORM>());
    return fmt::format("strahl {}\nplatform {} {}\ndevice {} {} {}\ndriver {}", STRAHL_VERSION,
                       platform.getInfo<CL_PLATFORM_NAME>(), platform.getInfo<CL_PLATFORM_VERSION>(), info.name,
                       info.vendor, info.version, info.driver);
  });
}

std::string program_hash(const ProgramSource& source) {
  // The zero keeps "ab" + "c" apart from "a" + "bc".
  return fmt::format("{:016x}", fnv1a(source.options, fnv1a(std::string_view("\0", 1), fnv1a(source.text))));
}

std::size_t group_size(const Device& device, const cl::Kernel& kernel, std::size_t wanted) {
  const std::size_t most = checked(device.info().text(),
                                   [&] { return kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device.device()); });
  return std::bit_floor(std::clamp<std::size_t>(most, 1, wanted));
}

bool is_program_cached(const Device& device, const ProgramSource& source) {
  return !read_cached_binary(program_hash(source), cache_key(device, completed_for(device, source))).empty();
}

cl::Program build_program(const Device& device, const ProgramSource& asked, ProgramReport* report, bool is_cached) {
  const ProgramSource source = completed_for(device, asked);
  const auto start = std::chrono::steady_clock::now();
  const std::string key = cache_key(device, source);
  const std::string name = program_hash(asked);

  std::vector<unsigned char> binary;
  if (is_cached) binary = read_cached_binary(name, key);
  std::optional<cl::Program> program;
  if (!binary.empty()) program = build_binary(device, source, binary);
  const bool from_cache = program.has_value();
  if (!program) {
    program = build_text(device, source, name);
    const auto binaries = checked(device.info().text(), [&] { return program->getInfo<CL_PROGRAM_BINARIES>(); });
    binary = binaries.at(0);
    if (is_cached) write_cached_binary(name, key, binary);
  }
  if (report != nullptr) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    *report = {seconds.count(), from_cache, binary.size()};
  }
  return *program;
}

}  // namespace strahl

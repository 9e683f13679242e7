// SPDX-License-Identifier: MIT
// From program text to an executable program, through strahl's own cache of device binaries.
#pragma once

#include <string>

#include "opencl/device.h"
#include "program/program_source.h"

namespace strahl {

/// How a program came to be, for --stats.
struct ProgramReport {
  double seconds = 0;
  bool from_cache = false;
  std::size_t binary_bytes = 0;
};

/// FNV-1a of text and options in hex, 16 digits: names the program in `explain`, dumps and the cache.
[[nodiscard]] std::string program_hash(const ProgramSource& source);

/// What the device is given of a program, by what it has: correctly rounded fp32 division and square root; fma in
/// integers where it has none (cl/math/soft_fma.h), doubles where it has them (cl/lanes/wide_lanes.h).
[[nodiscard]] ProgramSource completed_for(const Device& device, ProgramSource source);

/// Platform, device, driver and strahl, each with its version: what is cached of a device holds for these alone. A
/// driver update changes the version of one of them.
[[nodiscard]] std::string driver_key(const Device& device);

/// Builds, or takes the binary from the cache (key: text, options, platform, device, driver and strahl version; files
/// written atomically under $XDG_CACHE_HOME/strahl or ~/.cache/strahl; STRAHL_CACHE_DIR overrides; a cache that cannot
/// be read or written, or a binary that the driver rejects, is never an error: it is built from source).
/// Builds what completed_for makes of `source`.
/// is_cached: false: neither looks into the cache nor leaves anything there.
/// Throws KernelBuildError with options, build log and the path where the source was dumped.
[[nodiscard]] cl::Program build_program(const Device& device, const ProgramSource& source,
                                        ProgramReport* report = nullptr, bool is_cached = true);

/// As build_program; what this device, or one that it is a copy of, has built already is taken as it is
/// (opencl/program_shelf.h) and reported as from the cache.
[[nodiscard]] cl::Program program_on(const Device& device, const ProgramSource& source, ProgramReport* report = nullptr,
                                     bool is_cached = true);

/// Work-items of a group: `wanted`, a power of two, or as many as the kernel may have there, down to a power of two.
[[nodiscard]] std::size_t group_size(const Device& device, const cl::Kernel& kernel, std::size_t wanted);

/// Whether the cache holds a binary of this program, so that nothing has to be compiled for it.
[[nodiscard]] bool is_program_cached(const Device& device, const ProgramSource& source);

/// Removes every cached binary and every dumped source; returns how many binaries there were. Throws Error.
std::size_t clear_program_cache();
/// The directory in use; empty where there is none (no home directory), or where program_cache_fault() says why not:
/// nothing is cached.
[[nodiscard]] std::string program_cache_directory();
/// Why the directory is not used, with the remedy: somebody else could put programs there. Empty: nothing is wrong.
[[nodiscard]] std::string program_cache_fault();
/// Why STRAHL_CACHE_MIB is not heeded, and what is in its place. Empty: nothing is wrong.
[[nodiscard]] std::string program_cache_size_fault();

}  // namespace strahl

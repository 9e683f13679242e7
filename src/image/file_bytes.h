// SPDX-License-Identifier: MIT
// A whole input file in memory, and why a file cannot be one.
#pragma once

#include <cstdint>
#include <string>

namespace strahl {

/// What is read at most from a pipe, which may have no end.
constexpr std::uint64_t largest_stream = std::uint64_t{1} << 30;

/// Why a file cannot be read, with the remedy where there is one; empty where it can be. Regular files and pipes can;
/// a device cannot: it has no end.
[[nodiscard]] std::string unreadable_because(const std::string& path);

/// Works for pipes too. Throws InputError that says why a file cannot be read, or that it is larger than `most` bytes
/// or a pipe with more than largest_stream.
[[nodiscard]] std::string read_file(const std::string& path, std::uint64_t most = UINT64_MAX);

}  // namespace strahl

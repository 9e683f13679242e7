// SPDX-License-Identifier: MIT
// A whole input file in memory.
#pragma once

#include <string>

namespace strahl {

/// Works for pipes too. Throws InputError that says why a file cannot be read.
[[nodiscard]] std::string read_file(const std::string& path);

}  // namespace strahl

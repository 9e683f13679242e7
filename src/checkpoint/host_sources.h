// SPDX-License-Identifier: MIT
// Generated at build time (src/hash_files.cmake): what strahl's version does not tell of two builds between releases.
#pragma once

namespace strahl {

/// Of the host's sources that may decide a picture's bits: 16 hexadecimal digits. Those that decide none, as those of
/// the command line, take no part (CMakeLists.txt).
[[nodiscard]] const char* host_sources_hash();

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Generated at build time (src/hash_files.cmake): what decides a study's numbers beside the pictures themselves.
#pragma once

namespace strahl {

/// Of the sources of studies: 16 hexadecimal digits.
[[nodiscard]] const char* study_sources_hash();

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Metadata is written under a prefix, for OpenEXR gives many plain names a meaning and a type of their own ("version"
// as a string makes a file unreadable for some programs). Reading takes the prefix off again.
#pragma once

namespace strahl {

inline constexpr char exr_metadata_prefix[] = "strahl:";

}  // namespace strahl

// SPDX-License-Identifier: MIT
// The files below cl/, from the binary or from the directory that STRAHL_KERNEL_DIR names.
#pragma once

#include <map>
#include <string>

namespace strahl {

/// Path relative to cl/ ("shapes/sphere/sphere.h") → text.
using KernelFiles = std::map<std::string, std::string>;

/// The files in use. Throws Error where STRAHL_KERNEL_DIR does not name a directory of readable files.
[[nodiscard]] KernelFiles kernel_files();
/// STRAHL_KERNEL_DIR names the files in use; else they stay what they are.
[[nodiscard]] bool are_kernels_on_disk();

}  // namespace strahl

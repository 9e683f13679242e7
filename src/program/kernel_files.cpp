// SPDX-License-Identifier: MIT
// Reading kernel files from the binary or from disk.
#include "program/kernel_files.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "errors.h"
#include "program/embedded_kernels.h"

namespace strahl {

namespace {

namespace fs = std::filesystem;

constexpr const char* kernel_directory = "STRAHL_KERNEL_DIR";

KernelFiles read_directory(const fs::path& directory) {
  KernelFiles files;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".h" && extension != ".cl" && extension != ".def") continue;
      std::ifstream in(entry.path(), std::ios::binary);
      std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
      if (!in.is_open() || in.bad()) throw Error(fmt::format("{}: cannot be read", entry.path().string()));
      files[entry.path().lexically_relative(directory).generic_string()] = std::move(text);
    }
  } catch (const fs::filesystem_error& error) {
    throw Error(fmt::format("STRAHL_KERNEL_DIR must name the directory cl/ of a strahl source tree: {}", error.what()));
  }
  if (!files.contains("features.def"))
    throw Error(
        fmt::format("STRAHL_KERNEL_DIR must name the directory cl/ of a strahl source tree: \"{}\" has no "
                    "features.def",
                    directory.string()));
  return files;
}

}  // namespace

bool are_kernels_on_disk() {
  const char* directory = std::getenv(kernel_directory);
  return directory != nullptr && *directory != 0;
}

KernelFiles kernel_files() {
  if (are_kernels_on_disk()) return read_directory(std::getenv(kernel_directory));
  KernelFiles files;
  for (const EmbeddedKernel& kernel : embedded_kernels()) files.emplace(kernel.path, kernel.text);
  return files;
}

}  // namespace strahl

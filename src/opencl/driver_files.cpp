// SPDX-License-Identifier: MIT
#include "opencl/driver_files.h"

#include <dlfcn.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace strahl {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> icd_files() {
  const char* named = std::getenv("OCL_ICD_VENDORS");
  const fs::path where = named != nullptr && *named != 0 ? named : "/etc/OpenCL/vendors";
  if (where.extension() == ".icd") return {where};
  std::vector<fs::path> files;
  std::error_code unreadable;
  for (const fs::directory_entry& entry : fs::directory_iterator(where, unreadable))
    if (entry.path().extension() == ".icd") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether this process can still map what a driver with a compiler inside takes (PoCL 3.1 with LLVM 15: 0.3 GiB).
bool has_address_space() {
  constexpr std::size_t size = std::size_t{1} << 29;
  void* const memory = mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) return false;
  munmap(memory, size);
  return true;
}

/// "failed to map segment" is what the linker says of a file that may not be executed, too.
bool is_memory(const std::string& why) {
  if (why.find("Cannot allocate memory") != std::string::npos) return true;
  return why.find("map") != std::string::npos && !has_address_space();
}

}  // namespace

std::vector<UnloadableDriver> unloadable_drivers() {
  std::vector<UnloadableDriver> unloadable;
  for (const fs::path& file : icd_files()) {
    std::ifstream in(file);
    std::string library;
    if (!(in >> library)) continue;
    if (dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL) != nullptr) continue;  // Stays loaded: it would be anyway.
    const char* const words = dlerror();
    const std::string why = words != nullptr ? words : "unknown";
    unloadable.push_back({library, why, is_memory(why)});
  }
  return unloadable;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// POSIX. PoCL's rule for its cache: POCL_CACHE_DIR, else $XDG_CACHE_HOME/pocl/kcache, else $HOME/.cache/pocl/kcache.
#include "opencl/driver_environment.h"

#include <fmt/format.h>
#include <sched.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace strahl {
namespace {

namespace fs = std::filesystem;

const char* set_variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != 0 ? value : nullptr;
}

void ignore_relative_cache_home() {
  const char* cache = set_variable("XDG_CACHE_HOME");
  if (cache != nullptr && *cache != '/') unsetenv("XDG_CACHE_HOME");
}

std::string default_pocl_cache() {
  if (const char* cache = set_variable("XDG_CACHE_HOME")) return std::string(cache) + "/pocl/kcache";
  if (const char* home = std::getenv("HOME")) return std::string(home) + "/.cache/pocl/kcache";
  return "/tmp/pocl/kcache";
}

/// The same at every call, so that what is compiled is found again. Nobody else may write there: programs are run from
/// it.
std::string temporary_pocl_cache() {
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  if (error) return {};
  const std::string folder = (temporary / fmt::format("strahl-pocl-{}", geteuid())).string();
  struct stat status {};
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return {};
  const bool is_own = lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid() &&
                      (status.st_mode & 077) == 0;
  return is_own && unusable_folder(folder).empty() ? folder : std::string();
}

/// PoCL 3.1 numbers threads and processors alike.
bool may_run_on_all_processors() {
#ifdef __linux__
  cpu_set_t allowed;
  return sched_getaffinity(0, sizeof allowed, &allowed) == 0 && CPU_COUNT(&allowed) == sysconf(_SC_NPROCESSORS_CONF);
#else
  return false;
#endif
}

/// A launch wakes all threads at once, and Linux then lets two of them share a processor for some 10 ms while another
/// is idle. That is a sixth of a picture of four samples (docs/devices.md).
void keep_pocl_threads_apart() {
  if (set_variable("POCL_MAX_PTHREAD_COUNT") == nullptr && may_run_on_all_processors()) setenv("POCL_AFFINITY", "1", 0);
}

/// PoCL compiles a kernel a second time for the work-group size of its first launch, and that version is not in the
/// program's binary. The generic version is, and runs as fast where lanes are explicit: 0 % slower at 8 lanes, 15 % for
/// a scalar loop, against 2.3 s of compilation for a kernel with everything in it (PoCL 3.1).
void launch_what_the_binary_holds() { setenv("POCL_WORK_GROUP_SPECIALIZATION", "0", 0); }

std::string prepare() {
  ignore_relative_cache_home();
  keep_pocl_threads_apart();
  launch_what_the_binary_holds();
  if (const char* cache = set_variable("POCL_CACHE_DIR")) {
    const std::string why = unusable_folder(cache);
    return why.empty() ? why : fmt::format("its cache \"{}\" (POCL_CACHE_DIR) cannot be written: {}", cache, why);
  }
  unsetenv("POCL_CACHE_DIR");  // PoCL 3.1 ends the process where it is empty.
  const std::string cache = default_pocl_cache();
  std::string why = unusable_folder(cache);
  if (why.empty()) return why;
  const std::string temporary = temporary_pocl_cache();
  const std::string fault = fmt::format("its cache \"{}\" cannot be written ({})", cache, why);
  if (temporary.empty())
    return fault + ", nor can the folder for temporary files: name one that can with POCL_CACHE_DIR";
  setenv("POCL_CACHE_DIR", temporary.c_str(), 1);
  return fmt::format("{}: \"{}\" takes its place (POCL_CACHE_DIR)", fault, temporary);
}

}  // namespace

std::string unusable_folder(const std::string& folder) {
  fs::path there = folder;
  struct stat status {};
  while (stat(there.c_str(), &status) != 0) {
    if (errno != ENOENT) return std::strerror(errno);
    const fs::path parent = there.has_parent_path() ? there.parent_path() : fs::path(".");
    if (parent == there) return std::strerror(ENOENT);
    there = parent;
  }
  if (!S_ISDIR(status.st_mode)) return fmt::format("\"{}\" is not a folder", there.string());
  // Rights alone do not say it: of a full disk, or of /proc for root.
  std::string probe = (there / ".strahl-XXXXXX").string();
  if (mkdtemp(probe.data()) == nullptr) return std::strerror(errno);
  rmdir(probe.c_str());
  return {};
}

const std::string& prepare_driver_environment() {
  static const std::string note = prepare();
  return note;
}

}  // namespace strahl

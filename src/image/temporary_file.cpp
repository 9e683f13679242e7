// SPDX-License-Identifier: MIT
#include "image/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

namespace strahl {
namespace fs = std::filesystem;

namespace {

/// 32 hexadecimal digits; empty where the system has none.
const std::string& boot_id() {
  static const std::string known = [] {
    std::string id;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
    id.erase(std::remove(id.begin(), id.end(), '-'), id.end());
    return id;
  }();
  return known;
}

std::string prefix() { return fmt::format(".strahl-{}-", boot_id()); }

bool is_locked_by_us(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

bool is_the_file(int descriptor, const std::string& path) {
  struct stat open {
  }, named{};
  return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

/// Where its writer lives, or is not known to be gone, it stays.
void remove_if_abandoned(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat status {};
  const bool is_ours = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
  if (is_ours && is_locked_by_us(descriptor) && is_the_file(descriptor, path)) ::unlink(path.c_str());
  ::close(descriptor);
}

}  // namespace

TemporaryFile make_temporary_file(const std::string& folder) {
  // The name is free of the target's, which may already be as long as a name can be.
  static std::atomic<unsigned> counter{0};
  const std::string begin = prefix();
  while (true) {
    TemporaryFile file;
    file.path = (fs::path(folder) / fmt::format("{}{}-{}.tmp", begin, ::getpid(), counter++)).string();
    file.descriptor = ::open(file.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file.descriptor < 0) {
      if (errno == EEXIST) continue;
      file.error = errno;
      return file;
    }
    // Another process may take it for abandoned until it is locked. Where nobody can lock, nobody removes.
    const bool is_being_removed = !is_locked_by_us(file.descriptor) && errno == EWOULDBLOCK;
    const bool is_removed = ::access(file.path.c_str(), F_OK) != 0 && errno == ENOENT;
    if (!is_being_removed && !is_removed) return file;
    ::close(file.descriptor);
    ::unlink(file.path.c_str());
  }
}

void remove_abandoned_files(const std::string& folder) noexcept try {
  static std::mutex mutex;
  static std::set<std::string> seen;
  std::error_code failed;
  const std::string whole = fs::absolute(folder, failed).string();
  {
    const std::scoped_lock lock(mutex);
    if (failed || !seen.insert(whole).second) return;
  }
  if (boot_id().empty()) return;
  const std::string begin = prefix();
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(begin) && name.ends_with(".tmp")) remove_if_abandoned(at->path().string());
  }
} catch (const std::exception&) {
  return;  // Out of memory: another time.
}

}  // namespace strahl

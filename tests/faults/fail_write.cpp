// SPDX-License-Identifier: MIT
// Preloaded into a program, fails the n-th of its calls that write below a folder: open for writing, mkstemp, write,
// fsync, rename (Linux).
//
//   STRAHL_FAULT_FOLDER   only what is below it, and relative names, counts
//   STRAHL_FAULT_LOG      a line for each call that counts: its name
//   STRAHL_FAULT_CALL     n, from 1; without it all calls succeed
//   STRAHL_FAULT_KIND     "EIO" (this call), "ENOSPC" (this one and all later ones), "short" (a write writes half),
//                         "kill" (the process is killed before the call), "slow" (it succeeds after 2 s)
//   STRAHL_FAULT_NAME     only calls of this name count
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

namespace {

std::atomic<long> calls{0};

std::string text_of(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

bool counts(const std::string& path) {
  const std::string folder = text_of("STRAHL_FAULT_FOLDER");
  // The folder itself too, which is flushed.
  return !folder.empty() && ((path + "/").rfind(folder, 0) == 0 || (!path.empty() && path[0] != '/'));
}

std::string path_of(int descriptor) {
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t size = ::readlink(link.c_str(), path, sizeof path);
  return size > 0 ? std::string(path, static_cast<std::size_t>(size)) : "";
}

enum class Fault { none, error, half };

/// What shall become of this call, which counts; errno is set for an error.
Fault fault_of(const char* call) {
  if (const std::string only = text_of("STRAHL_FAULT_NAME"); !only.empty() && only != call) return Fault::none;
  const long number = ++calls;
  const std::string log = text_of("STRAHL_FAULT_LOG"), line = std::string(call) + "\n";
  const long file = ::syscall(SYS_openat, AT_FDCWD, log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (file >= 0) {
    if (::syscall(SYS_write, file, line.data(), line.size()) < 0) std::abort();
    ::syscall(SYS_close, file);
  }
  const std::string at = text_of("STRAHL_FAULT_CALL"), kind = text_of("STRAHL_FAULT_KIND");
  if (at.empty()) return Fault::none;
  const long wanted = std::atol(at.c_str());
  if (kind == "ENOSPC" ? number < wanted : number != wanted) return Fault::none;
  if (kind == "slow") {
    std::this_thread::sleep_for(std::chrono::seconds(2));
    return Fault::none;
  }
  if (kind == "kill") ::kill(::getpid(), SIGKILL);
  if (kind == "short") return std::strcmp(call, "write") == 0 ? Fault::half : Fault::none;
  errno = kind == "ENOSPC" ? ENOSPC : EIO;
  return Fault::error;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int open_as(const char* name, const char* path, int flags, mode_t mode) {
  const bool writes = (flags & O_ACCMODE) != O_RDONLY;
  if (writes && counts(path) && fault_of("open") == Fault::error) return -1;
  return next<int (*)(const char*, int, mode_t)>(name)(path, flags, mode);
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_as("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_as("open64", path, flags, mode);
}

int mkstemp(char* pattern) {
  if (counts(pattern) && fault_of("open") == Fault::error) return -1;
  return next<int (*)(char*)>("mkstemp")(pattern);
}

ssize_t write(int descriptor, const void* data, size_t size) {
  const Fault fault = counts(path_of(descriptor)) ? fault_of("write") : Fault::none;
  if (fault == Fault::error) return -1;
  if (fault == Fault::half && size > 1) size /= 2;
  return next<ssize_t (*)(int, const void*, size_t)>("write")(descriptor, data, size);
}

int fsync(int descriptor) {
  if (counts(path_of(descriptor)) && fault_of("fsync") == Fault::error) return -1;
  return next<int (*)(int)>("fsync")(descriptor);
}

int rename(const char* from, const char* to) noexcept {
  if (counts(to) && fault_of("rename") == Fault::error) return -1;
  return next<int (*)(const char*, const char*)>("rename")(from, to);
}
}

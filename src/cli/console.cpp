// SPDX-License-Identifier: MIT
// Writing to standard output and standard error (POSIX).
#include "cli/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <new>

#include "cli/printable.h"
#include "errors.h"

namespace strahl::cli {

namespace {

std::mutex mutex;
bool is_shown = false;  ///< There is a line that goes with the next one.

void put(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw Error(std::string("cannot write to standard output: ") + std::strerror(errno));
}

/// Nothing where there is no memory left for it: what is shown raw may do anything to a terminal.
std::string printable_or_nothing(const std::string& text) noexcept {
  try {
    return printable(text);
  } catch (const std::bad_alloc&) {
    return {};
  }
}

void wipe() noexcept {
  if (is_shown) std::fputs("\r\033[K", stderr);
  is_shown = false;
}

}  // namespace

void print(const std::string& text) {
  const std::scoped_lock lock(mutex);
  wipe();
  // A file or a program gets the bytes as they are.
  if (isatty(STDOUT_FILENO) != 0) return put(printable(text));
  put(text);
}

void say(const std::string& line) noexcept {
  const std::string safe = printable_or_nothing(line);
  const std::scoped_lock lock(mutex);
  wipe();
  std::fwrite(safe.data(), 1, safe.size(), stderr);
  std::fputc('\n', stderr);
}

void show_line(const std::string& line) noexcept {
  const std::string safe = printable_or_nothing(line);
  const std::scoped_lock lock(mutex);
  if (line.empty()) return wipe();
  std::fputc('\r', stderr);
  std::fwrite(safe.data(), 1, safe.size(), stderr);
  std::fputs("\033[K", stderr);
  is_shown = true;
}

void reserve_standard_streams() noexcept {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // open() takes the lowest free number, which is this stream's: the lower ones are open by now.
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF && open("/dev/null", O_RDONLY) == -1) return;
  }
}

}  // namespace strahl::cli

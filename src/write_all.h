// SPDX-License-Identifier: MIT
// Writing to an open descriptor.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

namespace strahl {

/// Writes all of it, however often a signal, a disk that is nearly full or a pipe that does not wait ends a call
/// part-way. 0, or errno.
[[nodiscard]] inline int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    if (count == 0) return EIO;
    if (errno == EAGAIN || errno == EWOULDBLOCK) {  // A pipe of others, who do not wait for its reader.
      pollfd ready{descriptor, POLLOUT, 0};
      if (::poll(&ready, 1, -1) >= 0) continue;
    }
    if (errno != EINTR) return errno;
  }
  return 0;
}

}  // namespace strahl

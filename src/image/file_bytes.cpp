// SPDX-License-Identifier: MIT
// Whole input files, by as few reads as the file's size allows (POSIX).
#include "image/file_bytes.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "errors.h"
#include "image/confined_reads.h"

namespace strahl {
namespace {

std::string cause_and_remedy(int error) {
  switch (error) {
    case ENOENT:
      return "there is no such file; is the path right?";
    case ENOTDIR:
      return "a part of its path is no folder; is the path right?";
    case ELOOP:
      return "its symbolic links go round in a loop; name the file itself";
    case EACCES:
    case EPERM:
      return fmt::format("no permission to read it ({}); chmod it, or run as its owner", std::strerror(error));
    default:
      return std::strerror(error);
  }
}

}  // namespace

std::string unreadable_because(const std::string& path) {
  struct stat status {};
  if (std::string outside = outside_because(path); !outside.empty()) return outside;
  if (stat(path.c_str(), &status) != 0) return cause_and_remedy(errno);
  if (S_ISDIR(status.st_mode)) return "it is a folder; name a file in it";
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return "it is a device; name a file or a pipe";
  if (S_ISSOCK(status.st_mode)) return "it is a socket; name a file or a pipe";
  return access(path.c_str(), R_OK) == 0 ? std::string() : cause_and_remedy(errno);
}

std::string read_file(const std::string& path, std::uint64_t most) {
  const auto fail = [&path](const std::string& why) {
    throw InputError(fmt::format("cannot read \"{}\": {}", path, why));
  };
  const std::string obstacle = unreadable_because(path);
  if (!obstacle.empty()) fail(obstacle);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  struct stat status {};
  if (!file || fstat(fileno(file.get()), &status) != 0) fail(cause_and_remedy(errno));

  // Pipes have no size, and a file may grow: the size is a first guess, the end of the data decides.
  const bool is_file = S_ISREG(status.st_mode);
  if (!is_file) most = std::min(most, largest_stream);
  const auto size = static_cast<std::uint64_t>(is_file ? status.st_size : 0);
  const auto require_room = [&](std::uint64_t bytes) {
    if (bytes > most)
      fail(fmt::format("it has more than {} MiB, the most that is read{}", most >> 20,
                       is_file ? "" : " from a pipe; is it endless? Else write it to a file first"));
  };
  require_room(size);
  std::string bytes;
  std::size_t room = std::max<std::size_t>(static_cast<std::size_t>(size) + 1, 65536);
  for (std::size_t used = 0;;) {
    bytes.resize(used + room);
    const std::size_t got = std::fread(bytes.data() + used, 1, room, file.get());
    used += got;
    require_room(used);
    if (got < room) {
      if (std::ferror(file.get())) fail(cause_and_remedy(errno));
      bytes.resize(used);
      return bytes;
    }
    room = std::max<std::size_t>(used, 65536);
  }
}

}  // namespace strahl

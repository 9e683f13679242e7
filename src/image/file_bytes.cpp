// SPDX-License-Identifier: MIT
// Whole input files, by as few reads as the file's size allows.
#include "image/file_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "errors.h"

namespace strahl {

std::string read_file(const std::string& path) {
  const auto fail = [&path](int error) {
    throw InputError(fmt::format("cannot read \"{}\": {}", path, std::strerror(error)));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) fail(errno);

  // Pipes have no size, and a file may grow: the size is a first guess, the end of the data decides.
  std::error_code no_size;
  const std::uintmax_t size = std::filesystem::file_size(path, no_size);
  std::string bytes;
  std::size_t room = no_size ? 65536 : static_cast<std::size_t>(size) + 1;
  for (std::size_t used = 0;;) {
    bytes.resize(used + room);
    const std::size_t got = std::fread(bytes.data() + used, 1, room, file.get());
    used += got;
    if (got < room) {
      if (std::ferror(file.get())) fail(errno);
      bytes.resize(used);
      return bytes;
    }
    room = std::max<std::size_t>(used, 65536);
  }
}

}  // namespace strahl

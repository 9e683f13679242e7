// SPDX-License-Identifier: MIT
#include "scene/meshes/inflated_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <new>

namespace strahl {

InflatedBytes::InflatedBytes(MeshSource& source, const char* begin) : source_(source), begin_(begin) {
  // zlib does not write to its input, whatever its types say.
  stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(begin));
  if (inflateInit(&stream_) != Z_OK) throw std::bad_alloc();
}

InflatedBytes::~InflatedBytes() { inflateEnd(&stream_); }

std::size_t InflatedBytes::inflate_some(void* to, std::size_t size) {
  constexpr std::size_t most_at_once = std::numeric_limits<uInt>::max();
  std::size_t done = 0;
  while (done < size && !ended_) {
    const char* at = reinterpret_cast<const char*>(stream_.next_in);
    source_.passed(at);
    const auto left = static_cast<std::size_t>(source_.end() - at);
    // In pieces, so that progress is told.
    stream_.avail_in = static_cast<uInt>(std::min(left, std::size_t{1} << 18));
    const auto room = static_cast<uInt>(std::min(size - done, most_at_once));
    stream_.next_out = static_cast<Bytef*>(to) + done;
    stream_.avail_out = room;
    const int code = inflate(&stream_, Z_NO_FLUSH);
    done += room - stream_.avail_out;
    ended_ = code == Z_STREAM_END;
    if (code == Z_MEM_ERROR) throw std::bad_alloc();
    if (code == Z_BUF_ERROR && left == 0) source_.fail(begin_, "the file ends inside the mesh that begins here");
    if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR) {
      source_.fail(begin_, fmt::format("the compressed mesh that begins here is damaged ({})",
                                       stream_.msg != nullptr ? stream_.msg : "a preset dictionary"));
    }
  }
  return done;
}

void InflatedBytes::read(void* to, std::size_t size) {
  if (inflate_some(to, size) < size) {
    source_.fail(begin_, "the compressed mesh that begins here ends before all that its header promises");
  }
}

bool InflatedBytes::ends() {
  char more = 0;
  return inflate_some(&more, 1) == 0;
}

std::size_t InflatedBytes::most() const {
  constexpr std::size_t best_ratio = 1032;  // of deflate: 258 bytes for 2 bits
  return best_ratio * static_cast<std::size_t>(source_.end() - begin_);
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Binary values for the PLY files that tests write.
#pragma once

#include <algorithm>
#include <bit>
#include <string>

namespace strahl::test {

template <class T>
std::string bytes(T value, bool big_endian) {
  std::string raw(reinterpret_cast<const char*>(&value), sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(raw);
  return raw;
}

}  // namespace strahl::test

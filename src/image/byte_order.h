// SPDX-License-Identifier: MIT
// Numbers in a file's byte order, whatever that of this computer is.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace strahl {

/// The number at `bytes`, which need not be aligned.
template <class T>
[[nodiscard]] T load(const char* bytes, std::endian order) {
  std::array<char, sizeof(T)> buffer;
  std::memcpy(buffer.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(buffer.begin(), buffer.end());
  return std::bit_cast<T>(buffer);
}

/// All of `values` in little-endian order.
template <class T>
[[nodiscard]] std::string little_endian_bytes(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  if constexpr (std::endian::native != std::endian::little) {
    for (auto at = bytes.begin(); at != bytes.end(); at += sizeof(T)) std::reverse(at, at + sizeof(T));
  }
  return bytes;
}

}  // namespace strahl

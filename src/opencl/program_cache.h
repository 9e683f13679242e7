// SPDX-License-Identifier: MIT
// strahl's own cache of device binaries: one file a program and device, whole or not at all.
//
// A file holds the complete key (all that the binary depends on, the source included) and a checksum, so neither an
// equal hash nor a damaged file can give a wrong program. Processes may share the directory: files are renamed into
// place. Files of another user, or that are no plain files, do not count. Whatever goes wrong with the cache means "not
// cached".
//
// All programs together take at most STRAHL_CACHE_MIB (512 without it): those used longest ago go first.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace strahl {

/// FNV-1a, 64 bits (Fowler, Noll and Vo, 1991).
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 0xcbf29ce484222325u) {
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3u;
  }
  return hash;
}

/// The binary stored for this key, empty where there is none. `name` begins the file's name.
[[nodiscard]] std::vector<unsigned char> read_cached_binary(const std::string& name, const std::string& key);

/// false: it is not stored, for whatever reason.
bool write_cached_binary(const std::string& name, const std::string& key, const std::vector<unsigned char>& binary);

/// Keeps the source of a program that does not build: below the cache, or in the directory for temporary files under a
/// name that nobody can foresee. Where it went, or why it went nowhere.
[[nodiscard]] std::string keep_failed_program(const std::string& name, const std::string& text);

}  // namespace strahl

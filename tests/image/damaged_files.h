// SPDX-License-Identifier: MIT
// Every reader against damaged files: whatever the bytes, an answer or an InputError, never a crash.
#pragma once

#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "errors.h"
#include "image/temporary_folder.h"

namespace strahl::test {

/// read(path) must throw InputError for every proper prefix of `good`.
template <class Read>
void check_truncations(const std::string& good, const std::string& path, Read read) {
  for (std::size_t size = 0; size < good.size(); size += 1 + size / 50) {
    put_bytes(path, good.substr(0, size));
    INFO(size << " of " << good.size() << " bytes");
    CHECK_THROWS_AS(read(path), InputError);
  }
}

/// read(path) must return or throw InputError for `good` with up to three bytes changed. Returns how many were
/// rejected.
template <class Read>
int check_mutations(const std::string& good, const std::string& path, int count, Read read) {
  std::mt19937 random(20111);
  int rejected = 0;
  for (int i = 0; i < count; ++i) {
    std::string bad = good;
    for (unsigned change = 0; change <= random() % 3; ++change) {
      bad[random() % bad.size()] = static_cast<char>(random() & 255U);
    }
    put_bytes(path, bad);
    INFO("mutation " << i);
    try {
      read(path);
    } catch (const InputError&) {
      ++rejected;
    } catch (const std::exception& e) {
      FAIL("not an InputError: " << e.what());
    }
  }
  return rejected;
}

}  // namespace strahl::test

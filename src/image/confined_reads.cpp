// SPDX-License-Identifier: MIT
#include "image/confined_reads.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "errors.h"

namespace strahl {
namespace {

namespace fs = std::filesystem;

/// Empty: all may be read. Of a thread: readers read in the one that loads the scene.
fs::path& root() {
  static thread_local fs::path path;
  return path;
}

}  // namespace

ConfinedReads::ConfinedReads(const std::string& folder) {
  std::error_code fault;
  const fs::path there = fs::canonical(folder, fault);
  if (fault || !fs::is_directory(there))
    throw UsageError(fmt::format("--root \"{}\": there is no such folder", folder));
  before_ = std::exchange(root(), there);
}

ConfinedReads::~ConfinedReads() { root() = std::move(before_); }

std::string outside_because(const std::string& path) {
  if (root().empty()) return {};
  std::error_code fault;
  const fs::path there = fs::canonical(path, fault);
  // What is there and has no name is open already: a pipe behind /dev/stdin, a file that was removed. Who opened it may
  // have had it from anywhere. What is not there cannot be read at all.
  if (fault)
    return fs::exists(path, fault) ? "it is a pipe or was removed, which --root does not read; name a file"
                                   : std::string();
  const auto [of_root, rest] = std::mismatch(root().begin(), root().end(), there.begin(), there.end());
  // Archives hold pipes, too; without a writer an open one is waited for without end.
  if (of_root == root().end())
    return fs::is_fifo(there, fault) ? "it is a pipe, which --root does not read; name a file" : std::string();
  return fmt::format("it lies outside of --root \"{}\"; put a copy there, or render without --root", root().string());
}

}  // namespace strahl

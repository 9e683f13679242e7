// SPDX-License-Identifier: MIT
// Other people's scenes name files: with --root they get at none but those below a folder.
#pragma once

#include <filesystem>
#include <string>

namespace strahl {

/// While one lives, unreadable_because(), and so whatever reads a file for a scene, refuses what lies outside of
/// `folder` once all links are resolved, and pipes. Of its own thread, in which it must end: other threads read as
/// before. Of several the last begun holds.
class ConfinedReads {
 public:
  /// Throws UsageError where there is no such folder.
  explicit ConfinedReads(const std::string& folder);
  ~ConfinedReads();
  ConfinedReads(const ConfinedReads&) = delete;
  ConfinedReads& operator=(const ConfinedReads&) = delete;

 private:
  std::filesystem::path before_;
};

/// Why the file must not be read; empty where it may.
[[nodiscard]] std::string outside_because(const std::string& path);

}  // namespace strahl

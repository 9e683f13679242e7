// SPDX-License-Identifier: MIT
// Other people's scenes name files: with --root they get at none but those below a folder.
#pragma once

#include <string>

namespace strahl {

/// While one lives, unreadable_because(), and so whatever reads a file for a scene, refuses what lies outside of
/// `folder` once all links are resolved, and pipes. One at a time; from all threads.
class ConfinedReads {
 public:
  /// Throws UsageError where there is no such folder.
  explicit ConfinedReads(const std::string& folder);
  ~ConfinedReads();
  ConfinedReads(const ConfinedReads&) = delete;
  ConfinedReads& operator=(const ConfinedReads&) = delete;
};

/// Why the file must not be read; empty where it may.
[[nodiscard]] std::string outside_because(const std::string& path);

}  // namespace strahl

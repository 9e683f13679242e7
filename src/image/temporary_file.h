// SPDX-License-Identifier: MIT
// Files under hidden names beside those that they will be: `.strahl-BOOT-PID-N.tmp`. Their writer holds a lock (flock)
// on each, which ends with the process, however that ends; so a file that can be locked is one whose writer was killed.
// BOOT, the running system's boot id, keeps that to one kernel: in a folder of the network the locks of another machine
// may be unknown here, so its files are left alone, as are those of before a restart.
#pragma once

#include <string>

namespace strahl {

struct TemporaryFile {
  std::string path;
  int descriptor = -1;  ///< Open for writing and locked; -1: it could not be made.
  int error = 0;        ///< errno, where it could not.
};

/// folder: where it is made.
[[nodiscard]] TemporaryFile make_temporary_file(const std::string& folder);

/// Removes this user's temporary files in the folder whose writers are gone. Only the first call for a folder looks: a
/// long job writes thousands of files to one. Never throws: what cannot be removed stays.
void remove_abandoned_files(const std::string& folder) noexcept;

}  // namespace strahl

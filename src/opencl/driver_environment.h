// SPDX-License-Identifier: MIT
// What the environment tells OpenCL drivers, put right before the loader starts them: PoCL offers no device where it
// cannot make its cache (containers without a home, the user nobody), and leaves its threads on one processor.
#pragma once

#include <string>

namespace strahl {

/// To be called before the first OpenCL call; does its work once a process.
///  - A relative XDG_CACHE_HOME is removed from the environment: the XDG Base Directory Specification has it ignored,
///    and drivers do not.
///  - POCL_CACHE_DIR, unless it names something, gets a folder of this user's among the temporary files where PoCL
///    could not make its cache. An empty one is removed, for PoCL 3.1 ends the process for it.
///  - POCL_WORK_GROUP_SPECIALIZATION becomes 0 unless it is set, so that PoCL launches what a program's binary holds.
///  - POCL_AFFINITY becomes 1, so that each of PoCL's threads has a processor of its own, unless the environment says
///    how many threads there are (POCL_MAX_PTHREAD_COUNT) or where they run, or this process may not run everywhere.
/// Returns what is to be said about PoCL's cache: empty where it is as PoCL has it by default.
const std::string& prepare_driver_environment();

/// Why a folder cannot be made, or not be written into; empty where both can be. Makes another one for a moment beside
/// it or in it, for rights alone do not tell.
[[nodiscard]] std::string unusable_folder(const std::string& folder);

}  // namespace strahl

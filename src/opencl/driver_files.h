// SPDX-License-Identifier: MIT
// The drivers that the OpenCL loader is told of by *.icd files. It passes over those that cannot be loaded without a
// word; why not is found out here, for a message.
#pragma once

#include <string>
#include <vector>

namespace strahl {

struct UnloadableDriver {
  std::string library;  ///< As its .icd file has it.
  std::string why;      ///< The dynamic linker's words.
  bool out_of_memory = false;
};

/// Tries to load each driver (OCL_ICD_VENDORS, else /etc/OpenCL/vendors); empty where all can be.
[[nodiscard]] std::vector<UnloadableDriver> unloadable_drivers();

}  // namespace strahl

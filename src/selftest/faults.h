// SPDX-License-Identifier: MIT
// Devices that are wrong, for tests of the self test: faults injected into the text or the options of its programs.
#pragma once

#include <string>
#include <vector>

#include "opencl/program.h"

namespace strahl::selftest {

struct FaultName {
  std::string name;
  std::string what;
};

[[nodiscard]] const std::vector<FaultName>& fault_names();

/// One fault, put into every program that it is given.
class Fault {
 public:
  /// name: of fault_names(), or empty for none. Throws std::logic_error for another.
  explicit Fault(const std::string& name);

  void inject(ProgramSource& source);
  /// Throws std::logic_error where no program had what the fault changes: it would be a fault that is none.
  void require_injected() const;

 private:
  std::string name_;
  int injected_ = 0;
};

}  // namespace strahl::selftest

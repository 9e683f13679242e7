// SPDX-License-Identifier: MIT
// Asks a device questions about one kind of shape in one tier: cl/kernels/probe.cl.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "opencl/device.h"
#include "opencl/program.h"
#include "selftest/question.h"
#include "settings/settings.h"

namespace strahl::selftest {

struct Answer {
  double t = 0;        ///< Infinite for a miss, in units of the direction as given.
  int primitive = -1;  ///< Within the question; -1 for a miss, FOUND_CUT (t is NaN) where loops were ended.
};

struct ProbeOptions {
  std::optional<int> lanes;  ///< None: what the device renders with.
  /// Changes the program before it is built (`--inject`); none: as it is.
  std::function<void(ProgramSource&)> change;
  bool ends_loops = false;  ///< The device does, and pictures there have the programs' form for that.
};

class Probe {
 public:
  /// Builds the program that holds only this kind (cl/shapes/shapes.def). Throws what program_on does.
  Probe(const Device&, const std::string& kind, Precision, const ProbeOptions& = {});
  ~Probe();
  Probe(Probe&&) noexcept;
  Probe& operator=(Probe&&) noexcept;

  /// Answer i belongs to question i. Throws std::logic_error for a question about another kind.
  [[nodiscard]] std::vector<Answer> ask(std::span<const Question>);

  [[nodiscard]] int lanes() const;
  /// What the device took for a primitive, padding to whole blocks counted, over all that was asked so far.
  [[nodiscard]] double nanoseconds_per_test() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace strahl::selftest

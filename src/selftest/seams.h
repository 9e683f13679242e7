// SPDX-License-Identifier: MIT
// Closed surfaces from within, at their shared edges and vertices: exactly one primitive is hit.
#pragma once

#include <cstdint>
#include <functional>

#include "selftest/closed_meshes.h"
#include "selftest/probe.h"

namespace strahl::selftest {

struct Seams {
  std::size_t rays = 0;
  std::size_t leaks = 0;    ///< Nothing is hit.
  std::size_t doubles = 0;  ///< With the primitive that was hit taken away, another one is, or the answer is no number.
  std::string first_wrong{};

  [[nodiscard]] std::size_t wrong() const { return leaks + doubles; }
};

/// "triangle" or "parallelogram", and for other kinds none: the surfaces made of it.
[[nodiscard]] std::vector<ClosedSurface> surfaces_of(const std::string& kind);

/// Adds to `seams` what the probe's device says of `rays` rays.
void ask_seams(Probe& probe, const std::string& kind, const ClosedSurface& surface, std::size_t rays,
               std::uint64_t seed, Seams& seams);

}  // namespace strahl::selftest

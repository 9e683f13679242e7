// SPDX-License-Identifier: MIT
// A program that answers rays, as a race sees it.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "study/ray_sets.h"

namespace strahl::bench {

class Contender {
 public:
  virtual ~Contender() = default;

  [[nodiscard]] virtual std::string program() const = 0;  ///< "strahl", "Embree 3.13.5".
  [[nodiscard]] virtual std::string variant() const = 0;  ///< "robust", "16 coherent".
  /// Everything that is not tracing: copies, layouts. Of any kind of rays, time and again.
  virtual void load(const RaySet& set) = 0;
  /// Answers the loaded rays; seconds.
  virtual double trace() = 0;
  /// Of the last trace: t a ray; 0 where any hit was asked for and there is one; infinite where nothing is hit.
  [[nodiscard]] virtual std::vector<double> distances() = 0;
  [[nodiscard]] virtual double build_seconds() const = 0;  ///< Of the tree.

 protected:
  Contender() = default;
  Contender(const Contender&) = delete;
  Contender& operator=(const Contender&) = delete;
};

}  // namespace strahl::bench

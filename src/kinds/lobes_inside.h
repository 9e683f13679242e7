// SPDX-License-Identifier: MIT
// Lobes of very many materials that hold each other.
#pragma once

#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// lobes_of() of one material after the other, each of the scene's looked at once. The scene may grow in between; its
/// materials must not change, and must hold such alone as stand before them.
class LobesInside {
 public:
  [[nodiscard]] int of(const Scene& scene, const Material& material);
  [[nodiscard]] bool transmits(const Scene& scene, const Material& material);

 private:
  [[nodiscard]] int of_known(const Material& material) const;

  std::vector<int> known_;  ///< By index.
};

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "render/shared_noise.h"

#include <algorithm>
#include <cmath>

namespace strahl {

double SharedNoise::overlap(double most) const {
  if (!(own > 0)) return most;
  const double most_beside = (std::sqrt(most) - 1) / 2;
  const auto of_axis = [&](double beside) { return 1 + 2 * std::clamp(beside / own, 0.0, most_beside); };
  return of_axis(left) * of_axis(above);
}

}  // namespace strahl

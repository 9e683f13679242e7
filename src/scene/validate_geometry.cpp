// SPDX-License-Identifier: MIT
#include "scene/validate_geometry.h"

#include "kinds/shapes.h"

namespace strahl {

std::vector<std::string> geometry_faults(const Geometry& geometry) {
  kinds::Faults faults;
  std::visit([&](const auto& shape) { kinds::check(faults, shape); }, geometry);
  return faults.take();
}

}  // namespace strahl

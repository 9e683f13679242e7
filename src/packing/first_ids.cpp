// SPDX-License-Identifier: MIT
#include "packing/first_ids.h"

#include <limits>

#include "errors.h"

namespace strahl {

std::vector<std::int64_t> first_ids(const Scene& scene) {
  std::vector<std::int64_t> first = {0};
  for_each_shape(scene, [&](const Shape& shape) { first.push_back(first.back() + primitive_count(shape)); });
  if (first.back() >= std::numeric_limits<std::int32_t>::max())
    throw Error("the scene has more than 2^31 - 1 primitives");
  return first;
}

}  // namespace strahl

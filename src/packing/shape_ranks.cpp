// SPDX-License-Identifier: MIT
#include "packing/shape_ranks.h"

#include <algorithm>
#include <utility>

#include "packing/packed_scene.h"

namespace strahl {

std::map<const Shape*, int> shape_ranks(const std::vector<const Shape*>& shapes) {
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (shapes[i]->priority) order.emplace_back(*shapes[i]->priority, shapes.size() - i);
  std::sort(order.begin(), order.end());
  std::map<const Shape*, int> ranks;
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    ranks[shapes[shapes.size() - order[rank].second]] = checked_offset(rank);
  return ranks;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Blocks of the size of pugixml's own, so that they take the place of those that xml_file.cpp gives back.
#include "scene/xml/xml_pool.h"

#include <algorithm>

namespace strahl {

/// The first block lasts until pugixml has given enough back. There before pugixml's, it does not stand between what
/// pugixml leaves free and the free memory behind.
XmlPool::XmlPool() { add_block(std::size_t{1} << 18); }

std::byte* XmlPool::bytes(std::size_t size) {
  constexpr std::size_t block_size = std::size_t{1} << 15;
  if (size > free_.size()) add_block(std::max(size, block_size));
  std::byte* first = free_.data();
  free_ = free_.subspan(size);
  return first;
}

void XmlPool::add_block(std::size_t size) {
  blocks_.push_back(std::make_unique_for_overwrite<std::byte[]>(size));
  free_ = {blocks_.back().get(), size};
}

}  // namespace strahl

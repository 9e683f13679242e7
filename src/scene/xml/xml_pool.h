// SPDX-License-Identifier: MIT
// The memory of a scene's elements: rows cut from blocks and texts that stay where they are, all freed at once.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace strahl {

class XmlPool {
 public:
  XmlPool();

  /// New elements or attributes side by side, none of them filled.
  template <class T>
  [[nodiscard]] std::span<T> row(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T>, "rows are freed, never destroyed");
    static_assert(alignof(T) == row_alignment && sizeof(T) % row_alignment == 0, "rows follow each other without gaps");
    T* first = reinterpret_cast<T*>(bytes(count * sizeof(T)));
    std::uninitialized_value_construct_n(first, count);
    return {first, count};
  }

  /// Keeps a text at one address.
  std::string& keep(std::string text) { return texts_.emplace_back(std::move(text)); }

 private:
  static constexpr std::size_t row_alignment = alignof(void*);

  [[nodiscard]] std::byte* bytes(std::size_t size);
  void add_block(std::size_t size);

  std::vector<std::unique_ptr<std::byte[]>> blocks_;
  std::span<std::byte> free_;  ///< The rest of the last block.
  std::deque<std::string> texts_;
};

}  // namespace strahl

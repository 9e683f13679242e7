// SPDX-License-Identifier: MIT
// The values behind a PLY header, one by one: as text (one element a line, or over several) and as binary numbers of
// either byte order.
//
// Both kinds have the same members, so that the reader is written once: real(), integer(), begin_element(),
// end_element(), skip_all(). What is truncated or malformed ends in SceneError.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "scene/meshes/ply_header.h"
#include "scene/meshes/text_cursor.h"

namespace strahl {

class PlyText {
 public:
  PlyText(MeshSource& source, const char* begin) : source_(source), p_(begin) {}

  [[nodiscard]] const char* position() {
    skip_to_word();
    return p_;
  }
  void seek(const char* p) { p_ = p; }

  void begin_element() {
    while (p_ != source_.end() && (is_blank(*p_) || *p_ == '\n')) ++p_;
    if (p_ == source_.end()) source_.fail(p_, "the file ends before the elements that its header promises");
    wrapped_at_ = nullptr;
  }

  /// What follows on the line is surplus, but where the element began in an earlier one: that one lacked values.
  void end_element() {
    skip_blanks();
    if (p_ == source_.end() || *p_ == '\n') return;
    if (wrapped_at_ != nullptr) source_.fail(wrapped_at_, "the line ends before all values that the header names");
    surplus_.add(p_);
    const void* newline = std::memchr(p_, '\n', static_cast<std::size_t>(source_.end() - p_));
    p_ = newline != nullptr ? static_cast<const char*>(newline) : source_.end();
  }

  double real(PlyType) {
    double value = 0;
    const std::string_view word = this->word();
    if (!parse_number(word, value)) source_.fail(word.data(), fmt::format("{} is not a number", in_quotes(word)));
    return value;
  }

  std::int64_t integer(PlyType type) {
    const char* at = position();
    const double value = real(type);
    if (!(std::abs(value) <= 4294967295.0) || value != std::trunc(value)) {
      source_.fail(at, fmt::format("{} is not an integer of 32 bits", value));
    }
    return static_cast<std::int64_t>(value);
  }

  /// How many values can follow at most.
  [[nodiscard]] std::uint64_t room(PlyType) const { return (static_cast<std::uint64_t>(source_.end() - p_) + 1) / 2; }

  void skip(PlyType, std::uint64_t count) {
    for (; count > 0; --count) static_cast<void>(word());
  }

  /// Reports what the data hold beyond the header's promise.
  void finish() {
    while (p_ != source_.end() && (is_blank(*p_) || *p_ == '\n')) ++p_;
    if (surplus_.count > 0) {
      source_.warn(surplus_.first, fmt::format("lines with more values than the header names: {}", surplus_.count));
    }
    if (p_ != source_.end()) source_.warn(p_, "text after the last element is ignored");
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
  void skip_blanks() {
    while (p_ != source_.end() && is_blank(*p_)) ++p_;
  }

  /// Elements may wrap over lines.
  void skip_to_word() {
    for (skip_blanks(); p_ != source_.end() && *p_ == '\n'; skip_blanks()) {
      if (wrapped_at_ == nullptr) wrapped_at_ = p_;
      ++p_;
    }
  }

  std::string_view word() {
    skip_to_word();
    const char* begin = p_;
    while (p_ != source_.end() && !is_blank(*p_) && *p_ != '\n') ++p_;
    if (p_ == begin) source_.fail(begin, "the file ends before the elements that its header promises");
    return {begin, static_cast<std::size_t>(p_ - begin)};
  }

  MeshSource& source_;
  const char* p_;
  const char* wrapped_at_ = nullptr;  ///< Where the element's first line has ended before its last value.
  Tally surplus_;
};

class PlyBinary {
 public:
  PlyBinary(MeshSource& source, const char* begin, bool swap) : source_(source), p_(begin), swap_(swap) {
    source.begin_binary(begin);
  }

  [[nodiscard]] const char* position() const { return p_; }
  void seek(const char* p) { p_ = p; }
  void begin_element() {}
  void end_element() {}

  double real(PlyType type) {
    if (type == PlyType::float32) return static_cast<double>(take<float>());
    if (type == PlyType::float64) return take<double>();
    return static_cast<double>(integer(type));
  }

  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
      case PlyType::float64:
        break;
    }
    source_.fail(p_, "a list of vertex indices that are not integers");
  }

  [[nodiscard]] std::uint64_t room(PlyType type) const {
    return static_cast<std::uint64_t>(source_.end() - p_) / size_of(type);
  }

  void skip(PlyType type, std::uint64_t count) {
    if (count > room(type)) truncated();
    p_ += count * size_of(type);
  }

  void finish() {
    if (p_ != source_.end()) {
      source_.warn(p_, fmt::format("{} bytes after the last element are ignored", source_.end() - p_));
    }
  }

 private:
  template <class T>
  T take() {
    std::array<char, sizeof(T)> bytes;
    if (static_cast<std::size_t>(source_.end() - p_) < sizeof(T)) truncated();
    std::memcpy(bytes.data(), p_, sizeof(T));
    if (swap_) std::ranges::reverse(bytes);
    p_ += sizeof(T);
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  [[noreturn]] void truncated() const {
    source_.fail(p_, "the file ends before the elements that its header promises");
  }

  MeshSource& source_;
  const char* p_;
  bool swap_;
};

}  // namespace strahl

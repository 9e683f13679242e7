// SPDX-License-Identifier: MIT
// Format: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays" (Robert Kern), and numpy.lib.format for
// versions 2 and 3: magic, version, length of the header, and the header as a Python dictionary
// {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }.
#include "image/npy_header.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <set>

#include "errors.h"
#include "image/byte_order.h"

namespace strahl {
namespace {

constexpr std::string_view npy_magic = "\x93NUMPY";

/// Reads the few forms of Python literal that such a header consists of.
class LiteralReader {
 public:
  LiteralReader(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError(fmt::format("\"{}\": damaged npy header: {} expected at character {}", path_, expected, at_));
  }

  bool accept(char wanted) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  void expect(char wanted) {
    if (!accept(wanted)) fail(fmt::format("'{}'", wanted));
  }

  std::string string() {
    skip_space();
    if (at_ == text_.size() || (text_[at_] != '\'' && text_[at_] != '"')) fail("a string");
    const std::size_t end = text_.find(text_[at_], at_ + 1);
    if (end == std::string_view::npos) fail("the end of a string");
    const std::string_view value = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return std::string(value);
  }

  bool boolean() {
    skip_space();
    for (const bool value : {true, false}) {
      const std::string_view name = value ? "True" : "False";
      if (text_.substr(at_, name.size()) != name) continue;
      at_ += name.size();
      return value;
    }
    fail("True or False");
  }

  std::vector<std::size_t> tuple() {
    std::vector<std::size_t> values;
    expect('(');
    while (!accept(')')) {
      values.push_back(integer());
      if (accept(')')) break;
      expect(',');
    }
    return values;
  }

  /// A structured type is a list: its text is kept for the message that rejects it.
  std::string type() {
    skip_space();
    if (at_ == text_.size() || text_[at_] != '[') return string();
    const std::size_t begin = at_;
    int depth = 0;
    do {
      if (at_ == text_.size()) fail("']'");
      if (text_[at_] == '[') ++depth;
      if (text_[at_] == ']') --depth;
      ++at_;
    } while (depth > 0);
    return std::string(text_.substr(begin, at_ - begin));
  }

  void expect_end() {
    skip_space();
    if (at_ != text_.size()) fail("the end");
  }

 private:
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t')) ++at_;
  }

  std::size_t integer() {
    skip_space();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("a length");
    at_ = static_cast<std::size_t>(end - text_.data());
    if (at_ < text_.size() && text_[at_] == 'L') ++at_;  // Python 2's long integers.
    return value;
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
};

}  // namespace

NpyHeader parse_npy_header(std::string_view bytes, const std::string& path) {
  const auto reject = [&path](const std::string& why) { throw InputError(fmt::format("\"{}\": {}", path, why)); };
  if (bytes.substr(0, npy_magic.size()) != npy_magic) reject("not an npy file; write one with numpy.save");
  if (bytes.size() < 10) reject("truncated npy file");
  const int version = static_cast<unsigned char>(bytes[6]);
  if (version < 1 || version > 3) reject(fmt::format("npy format version {} is unknown (1 to 3 are read)", version));
  const std::size_t begin = version == 1 ? 10 : 12;
  if (bytes.size() < begin) reject("truncated npy file");
  const std::size_t length = version == 1 ? load<std::uint16_t>(bytes.data() + 8, std::endian::little)
                                          : load<std::uint32_t>(bytes.data() + 8, std::endian::little);
  if (bytes.size() - begin < length) reject("truncated npy file: it ends within its header");

  NpyHeader header;
  header.size = begin + length;
  LiteralReader reader(bytes.substr(begin, length), path);
  std::set<std::string> keys;
  reader.expect('{');
  while (!reader.accept('}')) {
    const std::string key = reader.string();
    reader.expect(':');
    if (key == "descr") {
      header.descr = reader.type();
    } else if (key == "fortran_order") {
      header.fortran_order = reader.boolean();
    } else if (key == "shape") {
      header.shape = reader.tuple();
    } else {
      reader.fail("descr, fortran_order or shape");
    }
    keys.insert(key);
    if (reader.accept('}')) break;
    reader.expect(',');
  }
  reader.expect_end();
  if (keys.size() != 3) reject("damaged npy header: it lacks descr, fortran_order or shape");
  return header;
}

std::string npy_header_text(std::size_t rows, std::size_t columns) {
  std::string dictionary =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  dictionary.resize((10 + dictionary.size() + 1 + 63) / 64 * 64 - 10 - 1, ' ');
  dictionary += '\n';
  std::string text(npy_magic);
  text += {'\x01', '\x00', static_cast<char>(dictionary.size() & 255), static_cast<char>(dictionary.size() >> 8)};
  return text + dictionary;
}

}  // namespace strahl

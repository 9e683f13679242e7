// SPDX-License-Identifier: MIT
// Parses a PLY header (G. Turk, "The PLY Polygon File Format", Stanford, 1994; type names also of the later kind,
// uint8 ... float64). Lines may end in LF, CR LF or CR; an unknown line is a warning. Each count is checked against
// the size of the file before anything is allocated for it.
#include "scene/meshes/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "scene/meshes/text_cursor.h"

namespace strahl {
namespace {

PlyType parse_type(std::string_view word, MeshSource& source, const char* line) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> types{{
      {"char", PlyType::int8},
      {"int8", PlyType::int8},
      {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},
      {"short", PlyType::int16},
      {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},
      {"uint16", PlyType::uint16},
      {"int", PlyType::int32},
      {"int32", PlyType::int32},
      {"uint", PlyType::uint32},
      {"uint32", PlyType::uint32},
      {"float", PlyType::float32},
      {"float32", PlyType::float32},
      {"double", PlyType::float64},
      {"float64", PlyType::float64},
  }};
  for (const auto& [name, type] : types) {
    if (name == word) return type;
  }
  source.fail(word.empty() ? line : word.data(), fmt::format("{} is no type of a PLY property", in_quotes(word)));
}

PlyProperty parse_property(TextCursor& cursor, MeshSource& source, const char* line) {
  PlyProperty property;
  std::string_view word = cursor.word();
  if (word == "list") {
    const std::string_view count = cursor.word();
    property.count_type = parse_type(count, source, line);
    if (!is_integer(*property.count_type)) {
      source.fail(count.data(),
                  fmt::format("a list cannot count its items with {}; use an integer type", in_quotes(count)));
    }
    word = cursor.word();
  }
  property.type = parse_type(word, source, line);
  property.name = cursor.word();
  if (property.name.empty()) source.fail(line, "the property has no name");
  return property;
}

PlyElement parse_element(TextCursor& cursor, MeshSource& source, const char* line) {
  PlyElement element;
  element.at = line;
  element.name = cursor.word();
  const std::string_view count = cursor.word();
  std::int64_t number = 0;
  if (!parse_integer(count, number) || number < 0) {
    source.fail(count.empty() ? line : count.data(),
                fmt::format("{} is no number of elements of {}", in_quotes(count), in_quotes(element.name)));
  }
  element.count = static_cast<std::uint64_t>(number);
  return element;
}

/// As text, each value takes a digit and a separator, the very last one no separator.
std::uint64_t least_size(const PlyElement& element, PlyFormat format) {
  std::uint64_t size = 0;
  for (const PlyProperty& p : element.properties) {
    size += format == PlyFormat::ascii ? 2 : size_of(p.count_type.value_or(p.type));
  }
  return size;
}

void check_counts(const PlyHeader& header, MeshSource& source) {
  auto left = static_cast<std::uint64_t>(source.end() - header.data) + (header.format == PlyFormat::ascii ? 1 : 0);
  for (const PlyElement& element : header.elements) {
    const std::uint64_t size = least_size(element, header.format);
    if (size == 0) continue;
    if (element.count > left / size) {
      source.fail(element.at,
                  fmt::format("the header promises {} elements of {}, but the file can hold at most {}; it is "
                              "truncated or its header is wrong",
                              element.count, in_quotes(element.name), left / size));
    }
    left -= element.count * size;
  }
}

PlyFormat parse_format(TextCursor& cursor, MeshSource& source, const char* line) {
  const std::string_view format = cursor.word(), version = cursor.word();
  if (version != "1.0") source.fail(line, fmt::format("PLY version {} is not read, only 1.0", in_quotes(version)));
  if (format == "ascii") return PlyFormat::ascii;
  if (format == "binary_little_endian") return PlyFormat::little_endian;
  if (format == "binary_big_endian") return PlyFormat::big_endian;
  source.fail(format.data(), fmt::format("PLY format {} is unknown; there are ascii, binary_little_endian and "
                                         "binary_big_endian",
                                         in_quotes(format)));
}

/// Ends of the lines of the header become LF where they are CR alone.
void unify_header(MeshSource& source) {
  const std::string_view text(source.begin(), static_cast<std::size_t>(source.end() - source.begin()));
  if (!text.starts_with("ply\r") || text.starts_with("ply\r\n")) return;
  constexpr std::string_view last = "\rend_header\r";
  const std::size_t found = text.find(last);
  if (found == std::string_view::npos) return;
  const bool ascii = text.substr(0, found).find("\rformat ascii") != std::string_view::npos;
  source.unify_line_ends(ascii ? text.size() : found + last.size());
}

}  // namespace

int PlyElement::find(std::initializer_list<std::string_view> names) const {
  const auto found = std::ranges::find_if(properties, [&](const PlyProperty& p) {
    return std::ranges::find(names, std::string_view(p.name)) != names.end();
  });
  return found == properties.end() ? -1 : static_cast<int>(found - properties.begin());
}

PlyHeader read_ply_header(MeshSource& source) {
  unify_header(source);
  TextCursor cursor(source.begin(), source.end(), LineJoin::none);
  if (cursor.word() != "ply") source.fail(source.begin(), "not a PLY file: it does not begin with \"ply\"");
  PlyHeader header;
  bool has_format = false;
  Tally unknown;
  for (cursor.next_line(); !cursor.at_end(); cursor.next_line()) {
    const char* line = cursor.position();
    const std::string_view keyword = cursor.word();
    if (keyword == "end_header") {
      cursor.next_line();
      header.data = cursor.position();
      if (!has_format) source.fail(line, "the header names no format");
      if (unknown.count > 0) {
        source.warn(unknown.first, fmt::format("header lines ignored: {} with an unknown keyword", unknown.count));
      }
      check_counts(header, source);
      return header;
    }
    if (keyword == "format") {
      header.format = parse_format(cursor, source, line);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(parse_element(cursor, source, line));
    } else if (keyword == "property") {
      if (header.elements.empty()) source.fail(line, "a property before the first element");
      header.elements.back().properties.push_back(parse_property(cursor, source, line));
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      unknown.add(line);
    }
  }
  source.fail(source.begin(), "the header has no end_header; the file is truncated");
}

}  // namespace strahl

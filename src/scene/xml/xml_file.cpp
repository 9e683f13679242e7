// SPDX-License-Identifier: MIT
// pugixml parses in place: all texts of the tree lie in the file's own. Its byte offsets become lines and columns
// (columns count code points, so that an editor shows the same number after an umlaut).
#include "scene/xml/xml_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <pugixml.hpp>
#include <unordered_set>

#include "image/file_bytes.h"

namespace strahl {

namespace {

constexpr int deepest_nesting = 64;
constexpr std::uint64_t largest_text = std::uint64_t{1} << 30;  // Its tree takes some times as much memory.

/// Lines and columns of byte offsets that never decrease. pugixml overwrites the text that it parses, so all that is
/// needed is noted before.
class PlaceCursor {
 public:
  PlaceCursor(const std::string& file, const std::string& text) : file_(&file), size_(text.size()), starts_{0} {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
      starts_.push_back(at + 1);
    const auto bits = std::accumulate(text.begin(), text.end(), 0U, [](unsigned all, char c) { return all | byte(c); });
    if (bits >= 0x80U) original_ = text;
  }

  [[nodiscard]] XmlPlace at(std::ptrdiff_t offset) {
    const std::size_t target = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), size_);
    while (line_ + 1 < starts_.size() && starts_[line_ + 1] <= target) {
      offset_ = starts_[++line_];
      column_ = 0;
    }
    column_ += code_points(offset_, target);
    offset_ = target;
    return {file_, static_cast<int>(line_) + 1, static_cast<int>(column_) + 1};
  }

 private:
  static unsigned byte(char c) { return static_cast<unsigned char>(c); }

  [[nodiscard]] std::size_t code_points(std::size_t from, std::size_t to) const {
    if (original_.empty()) return to - from;
    const auto text = std::string_view(original_).substr(from, to - from);
    const auto is_first = [](char c) { return (byte(c) & 0xC0U) != 0x80U; };
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_first));
  }

  const std::string* file_;
  std::size_t size_;
  std::vector<std::size_t> starts_;  ///< Offset of each line.
  std::string original_;             ///< The text, where a column is not simply a byte: empty for pure ASCII.
  std::size_t line_ = 0, offset_ = 0, column_ = 0;
};

class TreeBuilder {
 public:
  TreeBuilder(PlaceCursor& places, XmlPool& pool, Diagnostics& diagnostics)
      : places_(places), pool_(pool), diagnostics_(diagnostics) {}

  /// Takes the children out of the document once they are read: tree and document are never there as a whole both.
  [[nodiscard]] XmlElement* build(pugi::xml_node node, int depth) {
    XmlElement& element = pool_.row<XmlElement>(1).front();
    element.tag = node.name();
    element.where = places_.at(node.offset_debug() - 1);
    read_attributes(element, node);
    XmlElement** end = &element.first_child;
    for (pugi::xml_node child = node.first_child(), next; child; child = next) {
      next = child.next_sibling();
      if (child.type() != pugi::node_element) {
        check_text(element, child);
      } else if (depth < deepest_nesting) {
        *end = build(child, depth + 1);
        end = &(*end)->next_sibling;
      } else {
        report_nesting(child);
      }
      if (!is_too_deep_) node.remove_child(child);
    }
    return &element;
  }

 private:
  void read_attributes(XmlElement& element, const pugi::xml_node& node) {
    std::size_t count = 0;
    for (pugi::xml_attribute given = node.first_attribute(); given; given = given.next_attribute()) ++count;
    const std::span<XmlAttribute> row = pool_.row<XmlAttribute>(count);
    std::unordered_set<std::string_view> names;
    for (pugi::xml_attribute given = node.first_attribute(); given; given = given.next_attribute()) {
      // A set takes time, and nearly all elements have few.
      if (count > 16 ? !names.insert(given.name()).second : element.attribute(given.name()).has_value())
        diagnostics_.error(element.where, fmt::format("attribute \"{}\" is given twice", given.name()));
      row[element.attributes.size()] = {given.name(), given.value()};
      element.attributes = row.first(element.attributes.size() + 1);
    }
  }

  void report_nesting(const pugi::xml_node& child) {
    diagnostics_.error(places_.at(child.offset_debug() - 1),
                       fmt::format("elements are nested deeper than {}", deepest_nesting));
    is_too_deep_ = true;
  }

  void check_text(const XmlElement& element, const pugi::xml_node& child) {
    const std::string_view text = child.value();
    const bool blank = std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; });
    if (blank) return;
    diagnostics_.unknown(element.where,
                         fmt::format("text inside <{}> is ignored; values stand in attributes", element.tag));
  }

  PlaceCursor& places_;
  XmlPool& pool_;
  Diagnostics& diagnostics_;
  bool is_too_deep_ = false;  ///< pugixml takes nodes out by recursion, which such a document could make overflow.
};

std::optional<std::string> file_text(const std::string& path, const SourceLocation& referrer,
                                     Diagnostics& diagnostics) {
  const bool is_included = !referrer.file.empty();
  const SourceLocation where = is_included ? referrer : SourceLocation{path};
  if (is_included) {
    if (const std::string obstacle = unreadable_because(path); !obstacle.empty()) {
      diagnostics.unreadable(where, path, obstacle);
      return std::nullopt;
    }
  }
  diagnostics.opened(path);
  std::string text;
  try {
    text = read_file(path, largest_text);
  } catch (const InputError& fault) {
    diagnostics.error(where, fault.what());
    return std::nullopt;
  }
  if (text.rfind("\xFF\xFE", 0) == 0 || text.rfind("\xFE\xFF", 0) == 0) {
    diagnostics.error(SourceLocation{path}, "is encoded as UTF-16; save it as UTF-8");
    return std::nullopt;
  }
  return text;
}

}  // namespace

XmlElement* read_xml_file(const std::string& path, const SourceLocation& referrer, XmlPool& pool,
                          Diagnostics& diagnostics) {
  std::optional<std::string> read = file_text(path, referrer, diagnostics);
  if (!read) return nullptr;
  std::string& text = pool.keep(std::move(*read));
  PlaceCursor places(pool.keep(path), text);
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer_inplace(text.data(), text.size() + 1, pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    diagnostics.error(places.at(result.offset), fmt::format("malformed XML: {}", result.description()));
    return nullptr;
  }
  const pugi::xml_node root = document.document_element();
  for (pugi::xml_node other = root.next_sibling(); other; other = other.next_sibling()) {
    if (other.type() != pugi::node_element) continue;
    diagnostics.error(places.at(other.offset_debug() - 1), "malformed XML: a file has one root element");
    return nullptr;
  }
  return TreeBuilder(places, pool, diagnostics).build(root, 1);
}

}  // namespace strahl

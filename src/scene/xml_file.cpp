// SPDX-License-Identifier: MIT
// pugixml parses; its byte offsets become lines and columns (columns count code points, so that an editor shows the
// same number after an umlaut).
#include "scene/xml_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>
#include <sstream>

namespace strahl {

namespace {

constexpr int deepest_nesting = 64;

class LineIndex {
 public:
  LineIndex(std::string file, const std::string& text) : file_(std::move(file)), text_(text), starts_{0} {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
      starts_.push_back(at + 1);
  }

  [[nodiscard]] SourceLocation at(std::ptrdiff_t offset) const {
    const std::size_t byte = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
    const auto line = std::upper_bound(starts_.begin(), starts_.end(), byte) - 1;
    const auto is_code_point = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    const auto column = std::count_if(text_.begin() + static_cast<std::ptrdiff_t>(*line),
                                      text_.begin() + static_cast<std::ptrdiff_t>(byte), is_code_point);
    return {file_, static_cast<int>(line - starts_.begin()) + 1, static_cast<int>(column) + 1};
  }

 private:
  std::string file_;
  const std::string& text_;
  std::vector<std::size_t> starts_;
};

class TreeBuilder {
 public:
  TreeBuilder(const LineIndex& lines, Diagnostics& diagnostics) : lines_(lines), diagnostics_(diagnostics) {}

  [[nodiscard]] XmlElement build(const pugi::xml_node& node, int depth) {
    XmlElement element;
    element.tag = node.name();
    element.where = lines_.at(node.offset_debug() - 1);
    element.attributes.reserve(size_of(node.attributes()));
    element.children.reserve(size_of(node.children()));
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      if (element.attribute(attribute.name()) != nullptr)
        diagnostics_.error(element.where, fmt::format("attribute \"{}\" is given twice", attribute.name()));
      element.attributes.emplace_back(attribute.name(), attribute.value());
    }
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element) {
        add_child(element, child, depth);
      } else {
        check_text(element, child);
      }
    }
    return element;
  }

 private:
  template <typename Range>
  static std::size_t size_of(const Range& range) {
    return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
  }

  void add_child(XmlElement& element, const pugi::xml_node& child, int depth) {
    if (depth < deepest_nesting) {
      element.children.push_back(build(child, depth + 1));
    } else {
      diagnostics_.error(lines_.at(child.offset_debug() - 1),
                         fmt::format("elements are nested deeper than {}", deepest_nesting));
    }
  }

  void check_text(const XmlElement& element, const pugi::xml_node& child) {
    const std::string text = child.value();
    const bool blank = std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; });
    if (blank) return;
    diagnostics_.unknown(element.where,
                         fmt::format("text inside <{}> is ignored; values stand in attributes", element.tag));
  }

  const LineIndex& lines_;
  Diagnostics& diagnostics_;
};

std::optional<std::string> file_text(const std::string& path, const SourceLocation& referrer,
                                     Diagnostics& diagnostics) {
  const SourceLocation where = referrer.file.empty() ? SourceLocation{path} : referrer;
  std::error_code ignored;
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path, ignored)) {
    diagnostics.error(where, fmt::format("cannot read \"{}\"; is the path right?", path));
    return std::nullopt;
  }
  std::ostringstream bytes;  // Pipes have no size to ask for.
  bytes << stream.rdbuf();
  std::string text = std::move(bytes).str();
  if (text.rfind("\xFF\xFE", 0) == 0 || text.rfind("\xFE\xFF", 0) == 0) {
    diagnostics.error(SourceLocation{path}, "is encoded as UTF-16; save it as UTF-8");
    return std::nullopt;
  }
  return text;
}

}  // namespace

std::optional<XmlElement> read_xml_file(const std::string& path, const SourceLocation& referrer,
                                        Diagnostics& diagnostics) {
  diagnostics.opened(path);
  const std::optional<std::string> text = file_text(path, referrer, diagnostics);
  if (!text) return std::nullopt;
  const LineIndex lines(path, *text);
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer(text->data(), text->size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    diagnostics.error(lines.at(result.offset), fmt::format("malformed XML: {}", result.description()));
    return std::nullopt;
  }
  const pugi::xml_node root = document.document_element();
  for (pugi::xml_node other = root.next_sibling(); other; other = other.next_sibling()) {
    if (other.type() != pugi::node_element) continue;
    diagnostics.error(lines.at(other.offset_debug() - 1), "malformed XML: a file has one root element");
    return std::nullopt;
  }
  return TreeBuilder(lines, diagnostics).build(root, 1);
}

}  // namespace strahl

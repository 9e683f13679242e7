// SPDX-License-Identifier: MIT
// Defaults, substitution and includes in document order. Replaced text is not searched again, and its length is
// limited, so that a hostile file cannot grow without bound.
#include "scene/xml_expand.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "scene/did_you_mean.h"
#include "scene/xml_file.h"
#include "scene/xml_upgrade.h"

namespace strahl {

namespace {

constexpr std::size_t longest_value = std::size_t{1} << 16;
constexpr int most_includes = 1000;

bool is_name_char(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::vector<std::string> names_of(const std::map<std::string, std::string>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

std::string canonical_path(const std::string& path) {
  std::error_code fault;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, fault);
  return fault ? path : canonical.string();
}

class Expander {
 public:
  Expander(std::string main_file, const std::map<std::string, std::string>& defines, Diagnostics& diagnostics)
      : main_file_(std::move(main_file)), defines_(defines), values_(defines), diagnostics_(diagnostics) {}

  [[nodiscard]] std::optional<XmlElement> read(const std::string& path, const SourceLocation& referrer) {
    const std::string canonical = canonical_path(path);
    if (std::find(open_.begin(), open_.end(), canonical) != open_.end()) {
      diagnostics_.error(referrer, fmt::format("\"{}\" includes itself; break the cycle", path));
      return std::nullopt;
    }
    std::optional<XmlElement> root = read_xml_file(path, referrer, diagnostics_);
    if (!root) return std::nullopt;
    upgrade_to_version_3(*root, diagnostics_);
    open_.push_back(canonical);
    static_cast<void>(substitute_attributes(*root));
    expand_children(*root);
    open_.pop_back();
    return root;
  }

  void report_unused_defines() {
    for (const auto& [name, value] : defines_) {
      if (used_.count(name) != 0) continue;
      std::vector<std::string> known(used_.begin(), used_.end());
      known.insert(known.end(), defaults_.begin(), defaults_.end());
      diagnostics_.unknown({main_file_}, fmt::format("-D {}={}: the scene does not use ${}{}; it has no effect", name,
                                                     value, name, did_you_mean(name, known)));
    }
  }

 private:
  void expand_children(XmlElement& element) {
    std::vector<XmlElement> given = std::move(element.children);
    element.children.clear();
    element.children.reserve(given.size());
    for (XmlElement& child : given) {
      if (!substitute_attributes(child)) continue;  // Reported; what lacks its value is left out.
      if (child.tag == "default") {
        add_default(child);
      } else if (child.tag == "include") {
        include(child, element.children);
      } else {
        expand_children(child);
        element.children.push_back(std::move(child));
      }
    }
  }

  void add_default(const XmlElement& element) {
    const std::string* name = element.attribute("name");
    const std::string* value = element.attribute("value");
    if (name == nullptr || value == nullptr || name->empty()) {
      diagnostics_.error(element.where, "<default> needs the attributes name and value");
      return;
    }
    defaults_.insert(*name);
    values_.emplace(*name, *value);
  }

  void include(const XmlElement& element, std::vector<XmlElement>& target) {
    const std::string* name = element.attribute("filename");
    if (name == nullptr) {
      diagnostics_.error(element.where, "<include> needs the attribute filename");
      return;
    }
    if (++includes_ > most_includes) {
      if (includes_ == most_includes + 1)
        diagnostics_.error(element.where, fmt::format("more than {} includes", most_includes));
      return;
    }
    std::optional<XmlElement> root = read(resolve_path(*name, element.where.file, main_file_), element.where);
    if (!root) return;
    if (root->tag == "scene") {
      for (XmlElement& child : root->children) target.push_back(std::move(child));
    } else {
      target.push_back(std::move(*root));
    }
  }

  [[nodiscard]] bool substitute_attributes(XmlElement& element) {
    bool ok = true;
    for (auto& [key, value] : element.attributes)
      if (value.find('$') != std::string::npos) ok = substitute(value, element.where) && ok;
    return ok;
  }

  [[nodiscard]] bool substitute(std::string& text, const SourceLocation& where) {
    std::string result;
    bool ok = true;
    for (std::size_t i = 0; i < text.size();) {
      if (text[i] != '$') {
        result += text[i++];
        continue;
      }
      const std::size_t begin = i + 1;
      for (i = begin; i < text.size() && is_name_char(text[i]);) ++i;
      const std::string name = text.substr(begin, i - begin);
      used_.insert(name);
      const auto found = values_.find(name);
      if (found == values_.end()) {
        report_undefined(name, where);
        ok = false;
      } else {
        result += found->second;
      }
      if (result.size() > longest_value) {
        diagnostics_.error(where, fmt::format("${} makes the text longer than {} bytes", name, longest_value));
        return false;
      }
    }
    text = std::move(result);
    return ok;
  }

  void report_undefined(const std::string& name, const SourceLocation& where) {
    diagnostics_.error(
        where, fmt::format("${} is not defined{}; give it a <default name=\"{}\"> before this place or -D {}=...", name,
                           did_you_mean(name, names_of(values_)), name, name));
  }

  std::string main_file_;
  const std::map<std::string, std::string>& defines_;
  std::map<std::string, std::string> values_;
  std::set<std::string> used_;
  std::set<std::string> defaults_;
  std::vector<std::string> open_;  ///< Canonical paths of the files being expanded, outermost first.
  int includes_ = 0;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<XmlElement> read_expanded_xml(const std::string& path, const std::map<std::string, std::string>& defines,
                                            Diagnostics& diagnostics) {
  Expander expander(path, defines, diagnostics);
  std::optional<XmlElement> root = expander.read(path, {});
  if (root) expander.report_unused_defines();
  return root;
}

std::string resolve_path(const std::string& name, const std::string& asking_file, const std::string& main_file) {
  namespace fs = std::filesystem;
  const fs::path beside_asking = fs::path(asking_file).parent_path() / name;
  const fs::path beside_main = fs::path(main_file).parent_path() / name;
  std::error_code ignored;
  const bool only_beside_main = !fs::exists(beside_asking, ignored) && fs::exists(beside_main, ignored);
  return (only_beside_main ? beside_main : beside_asking).lexically_normal().string();
}

}  // namespace strahl

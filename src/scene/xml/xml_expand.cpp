// SPDX-License-Identifier: MIT
// Defaults, substitution and includes in document order. Replaced text is not searched again, and its length is
// limited, of each text and of all together, so that a hostile file cannot grow without bound.
#include "scene/xml/xml_expand.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <set>
#include <utility>

#include "did_you_mean.h"
#include "scene/xml/xml_file.h"
#include "scene/xml/xml_upgrade.h"
#include "scene/xml/xml_vocabulary.h"

namespace strahl {

namespace {

constexpr std::size_t longest_value = std::size_t{1} << 16;
constexpr std::size_t most_growth = std::size_t{1} << 26;  ///< Of all texts together, beyond what the files hold.
constexpr int most_includes = 1000;
constexpr std::size_t deepest_include = 64;  ///< Files within files: trees of elements are walked recursively.

bool is_name_char(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::vector<std::string> names_of(const std::map<std::string, std::string>& values) {
  std::vector<std::string> names;
  names.reserve(values.size());
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

/// What other renderers' scenes often have a default for is an option here, whatever the scene has: "spp" for spp,
/// samples ...; empty for other names.
std::string option_for(const std::string& name) {
  static const std::map<std::string, std::string> options = {
      {"spp", "spp"},         {"samples", "spp"},           {"sample_count", "spp"}, {"samplecount", "spp"},
      {"width", "width"},     {"height", "height"},         {"seed", "seed"},        {"max_depth", "max-depth"},
      {"depth", "max-depth"}, {"integrator", "integrator"}, {"sampler", "sampler"}};
  const auto found = options.find(name);
  return found == options.end() ? std::string() : found->second;
}

std::string canonical_path(const std::string& path) {
  std::error_code fault;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, fault);
  return fault ? path : canonical.string();
}

class Expander {
 public:
  Expander(std::string main_file, const std::map<std::string, std::string>& defines, SearchPath& search_path,
           XmlPool& pool, Diagnostics& diagnostics)
      : main_file_(std::move(main_file)),
        defines_(defines),
        values_(defines),
        search_path_(search_path),
        pool_(pool),
        diagnostics_(diagnostics) {}

  /// parent: of the <include>; null of the main file.
  [[nodiscard]] XmlElement* read(const std::string& path, const SourceLocation& referrer, const XmlElement* parent) {
    const std::string canonical = canonical_path(path);
    if (std::find(open_.begin(), open_.end(), canonical) != open_.end()) {
      diagnostics_.error(referrer, fmt::format("\"{}\" includes itself; break the cycle", path));
      return nullptr;
    }
    if (open_.size() > deepest_include) {
      diagnostics_.error(referrer, fmt::format("more than {} files include each other in turn", deepest_include));
      return nullptr;
    }
    XmlElement* root = read_xml_file(path, referrer, pool_, diagnostics_);
    if (root == nullptr) return nullptr;
    const int includers_version = version_;
    const int version = version_ = major_version(*root, includers_version, diagnostics_);
    open_.push_back(canonical);
    static_cast<void>(substitute_attributes(*root));
    // What a <scene> holds takes the place of the <include>.
    expand_children(*root, root->tag == "scene" && parent != nullptr ? *parent : *root);
    open_.pop_back();
    version_ = includers_version;
    upgrade_to_version_3(*root, parent, version, pool_, diagnostics_);
    return root;
  }

  void report_unused_defines() {
    for (const auto& [name, value] : defines_) {
      if (used_.count(name) != 0) continue;
      std::vector<std::string> known(used_.begin(), used_.end());
      known.insert(known.end(), defaults_.begin(), defaults_.end());
      const std::string option = option_for(name);
      diagnostics_.unknown(
          {main_file_},
          fmt::format("-D {}={}: the scene does not use ${}{}; it has no effect{}", name, value, name,
                      did_you_mean(name, known), option.empty() ? "" : fmt::format(", --{} {} has", option, value)));
    }
  }

 private:
  /// around: what they come to lie in, once includes are replaced.
  void expand_children(XmlElement& element, const XmlElement& around) {
    XmlElement* given = std::exchange(element.first_child, nullptr);
    XmlElement** end = &element.first_child;
    while (given != nullptr) {
      XmlElement& child = *std::exchange(given, given->next_sibling);
      child.next_sibling = nullptr;
      if (!substitute_attributes(child)) continue;  // Reported; what lacks its value is left out.
      if (child.tag == "default") {
        add_default(child);
      } else if (child.tag == "include") {
        *end = include(child, around);
      } else if (child.tag == "path") {
        add_folder(child);
      } else {
        expand_children(child, child);
        *end = &child;
      }
      while (*end != nullptr) end = &(*end)->next_sibling;
    }
  }

  void add_default(const XmlElement& element) {
    check_expanded(element, diagnostics_);
    const std::optional<std::string_view> name = element.attribute("name");
    const std::optional<std::string_view> value = element.attribute("value");
    if (!name || !value || name->empty()) {
      diagnostics_.error(element.where, "<default> needs the attributes name and value");
      return;
    }
    defaults_.emplace(*name);
    values_.emplace(*name, *value);
  }

  void add_folder(const XmlElement& element) {
    check_expanded(element, diagnostics_);
    const std::optional<std::string_view> folder = element.attribute("value");
    if (!folder) return diagnostics_.error(element.where, "<path> needs the attribute value");
    const std::string path = search_path_.find(*folder, *element.where.file);
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return search_path_.prepend(path);
    diagnostics_.unknown(element.where, fmt::format("\"{}\" is no folder; <path> is ignored", path));
  }

  /// The first of those that take the place of an <include> within parent; null where none do.
  [[nodiscard]] XmlElement* include(const XmlElement& element, const XmlElement& parent) {
    check_expanded(element, diagnostics_);
    const std::optional<std::string_view> name = element.attribute("filename");
    if (!name) {
      diagnostics_.error(element.where, "<include> needs the attribute filename");
      return nullptr;
    }
    if (++includes_ > most_includes) {
      if (includes_ == most_includes + 1)
        diagnostics_.error(element.where, fmt::format("more than {} includes", most_includes));
      return nullptr;
    }
    XmlElement* root = read(search_path_.find(*name, *element.where.file), element.where, &parent);
    if (root == nullptr) return nullptr;
    if (root->tag == "scene") return root->first_child;
    take_place(*root, element, parent);
    return root;
  }

  /// The root of a file that holds one object becomes a part of the scene: its version has been obeyed, and it has the
  /// name that the <include> gives it.
  void take_place(XmlElement& root, const XmlElement& include, const XmlElement& parent) {
    const std::optional<std::string_view> name = include.attribute("name");
    const bool is_renamed = name && is_of_0x(version_) && !has_own_name(root, &parent);
    const std::span<XmlAttribute> all = pool_.row<XmlAttribute>(root.attributes.size() + 1);
    std::size_t count = 0;
    for (const XmlAttribute& attribute : root.attributes) {
      const std::string_view key = attribute.name;
      if (key != "version" && !(name && key == "name")) all[count++] = attribute;
    }
    if (name) all[count++] = {"name", is_renamed ? pool_.keep(snake_case(*name)).c_str() : name->data()};
    root.attributes = all.first(count);
  }

  [[nodiscard]] bool substitute_attributes(XmlElement& element) {
    bool ok = true;
    for (XmlAttribute& attribute : element.attributes)
      if (std::strchr(attribute.value, '$') != nullptr) ok = substitute(attribute, element.where) && ok;
    return ok;
  }

  [[nodiscard]] bool substitute(XmlAttribute& attribute, const XmlPlace& where) {
    const std::string_view text = attribute.value;
    std::string result;
    bool ok = true;
    for (std::size_t i = 0; i < text.size();) {
      if (text.substr(i, 2) == "\\$") {
        result += '$';
        i += 2;
        continue;
      }
      if (text[i] != '$') {
        result += text[i++];
        continue;
      }
      const std::size_t begin = i + 1;
      for (i = begin; i < text.size() && is_name_char(text[i]);) ++i;
      const std::string name(text.substr(begin, i - begin));
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
    if (!may_grow(text.size(), result.size(), where)) return false;
    attribute.value = pool_.keep(std::move(result)).c_str();
    return ok;
  }

  /// Whether a text of so many bytes may become one of that many; told once.
  [[nodiscard]] bool may_grow(std::size_t from, std::size_t to, const XmlPlace& where) {
    const bool was_within = growth_ <= most_growth;
    growth_ += to - std::min(from, to);
    if (growth_ <= most_growth) return true;
    if (was_within)
      diagnostics_.error(
          where, fmt::format("the values of $names make the scene longer by more than {} bytes; give them shorter ones",
                             most_growth));
    return false;
  }

  void report_undefined(const std::string& name, const XmlPlace& where) {
    diagnostics_.error(
        where, fmt::format("${} is not defined{}; give it a <default name=\"{}\"> before this place or -D {}=...", name,
                           suggestions_(name, values_.size(), [this] { return names_of(values_); }), name, name));
  }

  std::string main_file_;
  const std::map<std::string, std::string>& defines_;
  std::map<std::string, std::string> values_;
  std::set<std::string> used_;
  std::set<std::string> defaults_;
  std::vector<std::string> open_;  ///< Canonical paths of the files being expanded, outermost first.
  int version_ = 3;                ///< Major, of the innermost of them.
  int includes_ = 0;
  Suggestions suggestions_;  ///< For undefined names.
  std::size_t growth_ = 0;
  SearchPath& search_path_;
  XmlPool& pool_;
  Diagnostics& diagnostics_;
};

void find_spectra(XmlElement& element, const SearchPath& search_path, XmlPool& pool) {
  for (XmlAttribute& attribute : element.attributes)
    if (element.tag == "spectrum" && attribute.name == std::string_view("filename"))
      attribute.value = pool.keep(search_path.find(attribute.value, *element.where.file)).c_str();
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling)
    find_spectra(*child, search_path, pool);
}

}  // namespace

XmlElement* read_expanded_xml(const std::string& path, const std::map<std::string, std::string>& defines,
                              SearchPath& search_path, XmlPool& pool, Diagnostics& diagnostics) {
  Expander expander(path, defines, search_path, pool, diagnostics);
  XmlElement* root = expander.read(path, {}, nullptr);
  if (root == nullptr) return nullptr;
  expander.report_unused_defines();
  find_spectra(*root, search_path, pool);
  return root;
}

}  // namespace strahl

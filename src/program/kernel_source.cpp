// SPDX-License-Identifier: MIT
// The include expander: recursive descent over lines, with `#line` wherever the file changes.
#include "program/kernel_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <stdexcept>

#include "program/kernel_lines.h"
#include "program/lane_table.h"

namespace strahl {

namespace {

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

std::string list_of(const std::string& folder) {
  return fmt::format("{}/{}.def", folder, folder.substr(folder.rfind('/') + 1));
}

bool is_list(const std::string& path) { return !folder_of(path).empty() && path == list_of(folder_of(path)); }

[[noreturn]] void fail(const std::string& path, std::size_t line, const std::string& what) {
  throw std::logic_error(fmt::format("{}:{}: {}", path, line, what));
}

/// "sphere" of `SHAPE(sphere, ...)`; empty for a line without code.
std::string entry_name(const std::string& path, std::size_t line, const std::string& bare) {
  static const std::regex entry(R"([A-Za-z_]\w*\s*\(\s*([A-Za-z_]\w*)\s*(?:,.*)?\))");
  if (bare.empty()) return {};
  std::smatch match;
  if (!std::regex_match(bare, match, entry)) {
    fail(path, line, "a list holds comments and entries NAME(entry, ...) only");
  }
  return match[1];
}

/// Its lines stand in a text as far as the text uses their names.
const std::string lane_table = "lanes/lane_table.h";

class Expander {
 public:
  Expander(const KernelFiles& files, const ActiveEntries& active, const ActiveFeatures& features)
      : files_(files), active_(active), features_(features.begin(), features.end()) {
    for (const std::string& folder : list_folders(files)) {
      const std::vector<std::string> entries = list_entries(files, folder);
      entries_[folder] = {entries.begin(), entries.end()};
    }
    for (const auto& [folder, names] : active) {
      if (!entries_.contains(folder)) throw std::logic_error(fmt::format("there is no list {}", list_of(folder)));
      for (const std::string& name : names) {
        if (!entries_[folder].contains(name)) {
          throw std::logic_error(fmt::format("{} has no entry \"{}\"", list_of(folder), name));
        }
      }
    }
  }

  std::string expand(const std::string& root) {
    if (!files_.contains(root)) throw std::logic_error(fmt::format("there is no kernel file \"{}\"", root));
    add_file(root);
    if (table_at_) text_.insert(*table_at_, used_lane_names(files_.at(lane_table), text_));
    return std::move(text_);
  }

 private:
  void add_file(const std::string& path) {
    std::vector<KernelLine> lines = kernel_lines(files_.at(path));
    const std::string guard = include_guard(lines);
    if (!guard.empty() && conditionals_ == 0) present_.insert(path);
    open_.push_back(path);
    if (!guard.empty()) --conditionals_;  // its own #ifndef is true where the file is not present yet
    const std::string name = path.substr(path.rfind('/') + 1);
    const bool is_include_list = name == "all.h" || name == "all_lanes.h" || name == "all_surfaces_lanes.h";
    if (is_include_list || entry_of(path)) settle_sections(path, lines);
    if (path.ends_with(".def")) {
      add_def(path, lines);
    } else if (is_include_list) {
      add_include_list(path, lines, guard);
    } else {
      add_code(path, lines);
    }
    if (!guard.empty()) ++conditionals_;
    open_.pop_back();
  }

  /// Of `#if HAS_X` ... `#endif` empties these two lines, and what is between them where the feature is off. Empty
  /// lines at the end go, so that a program without the feature has the text as if there were no section.
  void settle_sections(const std::string& path, std::vector<KernelLine>& lines) const {
    int depth = 0;
    bool is_on = true;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto [word, macro] = directive(lines[i].bare);
      const bool begins = depth == 0 && macro.starts_with("HAS_") && lines[i].bare == "#if " + macro;
      if (depth == 0 && !begins) continue;
      if (depth == 1 && (word == "else" || word == "elif")) fail(path, i + 1, "a feature's section has no #" + word);
      depth += conditional_step(lines[i].bare);
      if (begins) {
        const auto feature = features_.find(macro.substr(std::string("HAS_").size()));
        is_on = feature == features_.end() || feature->second;
      }
      if (begins || depth == 0 || !is_on) lines[i] = {};
    }
    if (depth > 0) fail(path, lines.size(), "a feature's section has no #endif");
    while (!lines.empty() && lines.back().text.empty()) lines.pop_back();
  }

  void add_code(const std::string& path, const std::vector<KernelLine>& lines) {
    add_line_directive(path, 1);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string include = included_path(lines[i].bare);
      conditionals_ += conditional_step(lines[i].bare);
      if (directive(lines[i].bare) == std::pair<std::string, std::string>("pragma", "once")) {
        fail(path, i + 1, "kernel files use an include guard (#ifndef), not #pragma once");
      }
      if (include.empty()) {
        text_ += lines[i].text + '\n';
      } else if (is_wanted(path, i + 1, include)) {
        if (include == lane_table)
          table_at_ = text_.size();
        else
          add_file(include);
        add_line_directive(path, i + 2);
      } else {
        text_ += '\n';
      }
    }
  }

  /// Comments stay out, so that a list may be annotated without a program's text changing.
  void add_def(const std::string& path, const std::vector<KernelLine>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].bare.empty()) continue;
      if (is_list(path) && !is_active(folder_of(path), entry_name(path, i + 1, lines[i].bare))) continue;
      text_ += lines[i].bare + '\n';
    }
  }

  void add_include_list(const std::string& path, const std::vector<KernelLine>& lines, const std::string& guard) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].bare.empty()) continue;
      const std::string include = included_path(lines[i].bare);
      const int step = conditional_step(lines[i].bare);
      conditionals_ += step;
      if (!include.empty()) {
        if (is_shared_wanted(path, i + 1, lines[i].text) && is_wanted(path, i + 1, include)) add_file(include);
      } else if (!guard.empty() && (step != 0 || lines[i].bare.ends_with(guard))) {
        text_ += lines[i].bare + '\n';
      } else {
        fail(path, i + 1, "a list file holds comments and includes only");
      }
    }
  }

  bool is_active(const std::string& folder, const std::string& entry) const {
    const auto names = active_.find(folder);
    return names == active_.end() || names->second.contains(entry);
  }

  /// Of `#include "x.h"  // of sphere, disk`: whether one of these entries of the list is active; of `// not of box`,
  /// whether one of the others is.
  bool is_shared_wanted(const std::string& path, std::size_t line, const std::string& text) const {
    static const std::regex owners(R"(.*"\s*// (not )?of ([\w, ]+)$)"), word(R"(\w+)");
    std::smatch match;
    if (!std::regex_match(text, match, owners)) return true;
    const std::string folder = folder_of(path), listed = match[2];
    const std::set<std::string>& all = entries_.at(folder);
    std::set<std::string> named;
    for (std::sregex_iterator name(listed.begin(), listed.end(), word), end; name != end; ++name) {
      if (!all.contains(name->str()))
        fail(path, line, fmt::format("{} has no entry \"{}\"", list_of(folder), name->str()));
      named.insert(name->str());
    }
    return std::any_of(all.begin(), all.end(), [&](const std::string& entry) {
      return named.contains(entry) != match[1].matched && is_active(folder, entry);
    });
  }

  /// Whether an include puts anything into the text; throws where it cannot be followed.
  bool is_wanted(const std::string& path, std::size_t line, const std::string& include) const {
    if (!files_.contains(include)) {
      fail(path, line, fmt::format("includes \"{}\", which is not below cl/ (includes are relative to cl/)", include));
    }
    if (std::find(open_.begin(), open_.end(), include) != open_.end()) {
      fail(path, line, fmt::format("includes \"{}\", which is being included: {}", include, fmt::join(open_, " > ")));
    }
    if (present_.contains(include)) return false;
    const auto entry = entry_of(include);
    return !entry || is_active(entry->first, entry->second);
  }

  /// List and name of the entry whose own file this is: shapes/sphere/sphere.h as well as materials/diffuse.h.
  std::optional<std::pair<std::string, std::string>> entry_of(const std::string& path) const {
    const std::string folder = folder_of(path), parent = folder_of(folder);
    for (const std::string ending : {"_surfaces_lanes.h", "_body_lanes.h", "_lanes.h", ".h"}) {
      if (!path.ends_with(ending)) continue;
      const std::string entry = path.substr(folder.size() + 1, path.size() - folder.size() - 1 - ending.size());
      const std::string owner = folder == parent + '/' + entry ? parent : folder;
      const auto list = entries_.find(owner);
      if (list != entries_.end() && list->second.contains(entry)) return std::pair(owner, entry);
    }
    return std::nullopt;
  }

  void add_line_directive(const std::string& path, std::size_t line) {
    text_ += fmt::format("#line {} \"{}\"\n", line, path);
  }

  const KernelFiles& files_;
  const ActiveEntries& active_;
  const std::map<std::string, bool> features_;
  std::map<std::string, std::set<std::string>> entries_;
  std::set<std::string> present_;        ///< Guarded files that stand in the text outside every #if.
  std::vector<std::string> open_;        ///< From the root to the file being expanded.
  std::optional<std::size_t> table_at_;  ///< Where the names that depend on the width go.
  int conditionals_ = 0;                 ///< #ifs open around the current line, guards of open files not counted.
  std::string text_;
};

}  // namespace

std::vector<std::string> list_entries(const KernelFiles& files, const std::string& folder) {
  const std::string path = list_of(folder);
  const auto list = files.find(path);
  if (list == files.end()) throw std::logic_error(fmt::format("there is no list {}", path));
  std::vector<std::string> names;
  std::size_t number = 0;
  for (const KernelLine& line : kernel_lines(list->second)) {
    const std::string name = entry_name(path, ++number, line.bare);
    if (!name.empty()) names.push_back(name);
  }
  return names;
}

std::vector<std::pair<std::string, std::string>> list_features(const KernelFiles& files) {
  static const std::regex feature(R"(FEATURE\(\s*(\w+)\s*,\s*\"([^\"\\]*)\"\s*\))");
  const std::string path = "features.def";
  const auto list = files.find(path);
  if (list == files.end()) throw std::logic_error(fmt::format("there is no list {}", path));
  std::vector<std::pair<std::string, std::string>> features;
  std::size_t number = 0;
  for (const KernelLine& line : kernel_lines(list->second)) {
    ++number;
    if (line.bare.empty()) continue;
    std::smatch match;
    if (!std::regex_match(line.bare, match, feature)) fail(path, number, "expected FEATURE(NAME, \"why\")");
    features.emplace_back(match[1], match[2]);
  }
  return features;
}

std::vector<std::string> list_folders(const KernelFiles& files) {
  std::vector<std::string> folders;
  for (const auto& [path, text] : files) {
    if (is_list(path)) folders.push_back(folder_of(path));
  }
  return folders;
}

std::string expand_kernel(const KernelFiles& files, const std::string& root, const ActiveEntries& active,
                          const ActiveFeatures& features) {
  return Expander(files, active, features).expand(root);
}

/// Packing a scene and checking what was packed ask for hundreds of entries.
std::vector<std::string> list_entries(const std::string& folder) {
  if (are_kernels_on_disk()) return list_entries(kernel_files(), folder);
  static const std::map<std::string, std::vector<std::string>> lists = [] {
    const KernelFiles files = kernel_files();
    std::map<std::string, std::vector<std::string>> all;
    for (const std::string& name : list_folders(files)) all[name] = list_entries(files, name);
    return all;
  }();
  const auto found = lists.find(folder);
  if (found == lists.end()) throw std::logic_error(fmt::format("there is no list {}", list_of(folder)));
  return found->second;
}
std::vector<std::pair<std::string, std::string>> list_features() { return list_features(kernel_files()); }
std::vector<std::string> list_folders() { return list_folders(kernel_files()); }
std::string expand_kernel(const std::string& root, const ActiveEntries& active, const ActiveFeatures& features) {
  return expand_kernel(kernel_files(), root, active, features);
}

}  // namespace strahl

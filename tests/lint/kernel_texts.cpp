// SPDX-License-Identifier: MIT
// kernel_texts FOLDER [NAME | --few]: writes every kernel x precision x {all, no, each single} effect as
// FOLDER/NAME.cl, for clang to type-check. All, none and all of a scene without a tree at every width of lanes, fast
// and stable, whose texts are robust's but for shapes, at one lane and the widest; single effects at the widest: shapes
// in every tier, the others, which are the same for every tier, in the robust one alone. Of the kernels that begin on
// lights one has single effects, of those that intersect one, and that has shapes and flags. All of the robust tier
// also as devices with doubles have it. A text that stands already but for names that it never asks for is not written
// again. NAME: that text alone. --few: in the other tiers all and none alone, at the widest; no single effects of
// `bidirectional`; doubles at the widest.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <unordered_set>

#include "program/kernel_source.h"
#include "program/program_text.h"

using namespace strahl;

namespace {

Features read_every(bool on) {
  Features features;
  for (const std::string& list : list_folders()) {
    features.entries[list];
    if (!on) continue;
    for (const std::string& entry : list_entries(list)) features.entries[list].insert(entry);
  }
  for (const auto& [name, why] : list_features()) features.flags.emplace_back(name, on);
  features.is_generic = on;
  return features;
}

/// All of them, or none. The lists are files: they are read once.
const Features& every(bool on) {
  static const Features all = read_every(true), none = read_every(false);
  return on ? all : none;
}

/// name -> features, one effect alone. What effects do with numbers they do in robust as in every tier; shapes do not.
std::vector<std::pair<std::string, Features>> singles(const std::string& kernel, Precision precision) {
  std::vector<std::pair<std::string, Features>> sets;
  if (kernel.starts_with("intersect_") || kernel == "probe" || kernel == "light_tracing" || kernel == "share_samples")
    return sets;
  const bool is_robust = precision == Precision::robust;
  if (kernel == "bidirectional" && !is_robust) return sets;
  const bool has_all = is_robust && kernel != "intersect";
  for (const std::string& list : list_folders())
    for (const std::string& entry : list_entries(list)) {
      if (!has_all && list != "shapes") continue;
      sets.emplace_back(list + "-" + entry, every(false));
      sets.back().second.entries[list].insert(entry);
    }
  if (!is_robust) return sets;
  for (std::size_t i = 0; i < list_features().size(); ++i) {
    const std::string name = list_features()[i].first;
    sets.emplace_back(name, every(false));
    Features& features = sets.back().second;
    features.flags[i].second = true;
    // Its files are those of the list's entries; a program has both or neither.
    if (name == "MEDIA" || name == "PANE") features.entries["media"] = every(true).entries.at("media");
    // Panes are a material's, and media look through them.
    if (name == "PANE") {
      features.entries["materials"] = {"thindielectric"};
      for (auto& [flag, on] : features.flags) on = on || flag == "MEDIA";
    }
  }
  return sets;
}

/// Without the first line, which says what the text is, and features that it defines and never asks for.
std::string essence(const std::string& text) {
  std::string kept;
  const std::string define = "#define HAS_";
  std::size_t line = text.find('\n') + 1;
  for (std::size_t next; line < text.size(); line = next) {
    next = std::min(text.find('\n', line), text.size() - 1) + 1;
    if (text.compare(line, define.size(), define) == 0) {
      const std::size_t name = line + std::string("#define ").size();
      const std::string word = text.substr(name, text.find(' ', name) - name);
      if (text.find(word, next) == std::string::npos) continue;
    }
    kept.append(text, line, next - line);
  }
  return kept;
}

/// Where, and which one: all where that is empty.
struct Wanted {
  std::filesystem::path folder;
  std::string name;
};

/// Programs of light paths have an integrator of them whatever else they have.
Features completed(const std::string& kernel, Features features) {
  const bool has_both_ends = kernel == "bidirectional" || features.has("integrators", "bdpt");
  const bool has_paths = kernel == "light_tracing" || has_both_ends || features.has("integrators", "ptracer") ||
                         features.flag("LIGHT_PATHS");
  for (auto& [name, on] : features.flags) on = on || (name == "LIGHT_PATHS" && has_paths);
  if (has_paths)
    features.entries["integrators"].insert(has_both_ends && kernel != "light_tracing" ? "bdpt" : "ptracer");
  return features;
}

void write(const Wanted& wanted, const std::string& kernel, const std::string& set, const Features& features,
           Precision precision, int lanes, bool has_tree = true, int path_lanes = 1) {
  static std::unordered_set<std::string> written;
  const std::string name = fmt::format("{}-{}-{}-{}.cl", kernel, precision_name(precision), lanes, set);
  if (!wanted.name.empty() && name != wanted.name) return;
  // It is about paths alone, and has their lanes.
  if (kernel == "share_samples") path_lanes = lanes;
  const std::string text = program_source("kernels/" + kernel + ".cl", completed(kernel, features), precision, lanes, 0,
                                          has_tree, path_lanes)
                               .text;
  if (set != "doubles" && !written.insert(essence(text)).second) return;
  std::ofstream file(wanted.folder / name);
  file << (set == "doubles" ? "#define WIDE_IS_DOUBLE 1\n" : "") << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + name);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2 && count != 3) return 2;
  const bool few = count == 3 && std::string(arguments[2]) == "--few";
  const Wanted wanted{arguments[1], count == 3 && !few ? arguments[2] : ""};
  for (const std::string kernel :
       {"render", "light_tracing", "bidirectional", "intersect", "intersect_packets", "intersect_any",
        "intersect_any_packets", "probe", "canary", "bandwidth", "share_samples"})
    for (const Precision precision : {Precision::fast, Precision::stable, Precision::robust, Precision::fp64}) {
      if (!wanted.name.empty() && !wanted.name.starts_with(kernel + "-" + precision_name(precision) + "-")) continue;
      const int widest = default_lanes(16, precision);
      const bool is_robust = precision == Precision::robust;
      for (int lanes : {1, 8, 16}) {
        if (kernel.ends_with("_packets") && lanes == 1) continue;
        if (lanes > widest) continue;
        const bool is_like_robust = precision == Precision::fast || precision == Precision::stable;
        if (is_like_robust && lanes > 1 && lanes < widest) continue;
        if (few && !is_robust && lanes < widest) continue;
        write(wanted, kernel, "all", every(true), precision, lanes);
        if (is_robust && !(few && lanes < widest)) write(wanted, kernel, "doubles", every(true), precision, lanes);
        write(wanted, kernel, "none", every(false), precision, lanes);
        Features flat = every(true);
        for (auto& [name, on] : flat.flags) on = on && name != "INSTANCES";
        const bool has_lists = is_robust || !few;
        if (has_lists) write(wanted, kernel, "lists", flat, precision, lanes, false);
        const bool makes_pictures = kernel == "render" || kernel == "light_tracing" || kernel == "bidirectional";
        if (!makes_pictures) continue;
        write(wanted, kernel, "all-paths", every(true), precision, lanes, true, lanes);
        write(wanted, kernel, "none-paths", every(false), precision, lanes, true, lanes);
        if (has_lists) write(wanted, kernel, "lists-paths", flat, precision, lanes, false, lanes);
      }
      if (few && (!is_robust || kernel == "bidirectional")) continue;
      for (const auto& [name, features] : singles(kernel, precision))
        write(wanted, kernel, name, features, precision, widest);
    }
  return 0;
}

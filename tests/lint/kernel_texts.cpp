// SPDX-License-Identifier: MIT
// kernel_texts FOLDER: writes every kernel x precision x {all, no, each single} effect as FOLDER/NAME.cl, for clang to
// type-check. All, none and all of a scene without a tree at every width of lanes, single effects at the widest.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "device/kernel_source.h"
#include "device/program_text.h"

using namespace strahl;

namespace {

Features every(bool on) {
  Features features;
  for (const std::string& list : list_folders()) {
    features.entries[list];
    if (!on) continue;
    for (const std::string& entry : list_entries(list)) features.entries[list].insert(entry);
  }
  for (const auto& [name, why] : list_features()) features.flags.emplace_back(name, on);
  return features;
}

/// name -> features, one effect alone.
std::vector<std::pair<std::string, Features>> singles() {
  std::vector<std::pair<std::string, Features>> sets;
  for (const std::string& list : list_folders())
    for (const std::string& entry : list_entries(list)) {
      sets.emplace_back(list + "-" + entry, every(false));
      sets.back().second.entries[list].insert(entry);
    }
  for (std::size_t i = 0; i < list_features().size(); ++i) {
    sets.emplace_back(list_features()[i].first, every(false));
    sets.back().second.flags[i].second = true;
  }
  return sets;
}

void write(const std::filesystem::path& folder, const std::string& kernel, const std::string& set,
           const Features& features, Precision precision, int lanes, bool has_tree = true, int path_lanes = 1) {
  const std::string name = fmt::format("{}-{}-{}-{}.cl", kernel, precision_name(precision), lanes, set);
  std::ofstream file(folder / name);
  file << program_source("kernels/" + kernel + ".cl", features, precision, lanes, 0, has_tree, path_lanes).text;
  if (!file.flush()) throw std::runtime_error("cannot write " + name);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  for (const std::string kernel : {"render", "intersect", "intersect_packets", "probe", "canary", "bandwidth"})
    for (const Precision precision : {Precision::fast, Precision::stable, Precision::robust, Precision::fp64}) {
      const int widest = default_lanes(16, precision);
      for (int lanes : {1, 8, 16}) {
        if (kernel == "intersect_packets" && lanes == 1) continue;
        if (lanes > widest) continue;
        write(folder, kernel, "all", every(true), precision, lanes);
        write(folder, kernel, "none", every(false), precision, lanes);
        Features flat = every(true);
        for (auto& [name, on] : flat.flags) on = on && name != "INSTANCES";
        write(folder, kernel, "lists", flat, precision, lanes, false);
        if (kernel != "render" || precision == Precision::fp64) continue;
        write(folder, kernel, "all-paths", every(true), precision, lanes, true, lanes);
        write(folder, kernel, "none-paths", every(false), precision, lanes, true, lanes);
        write(folder, kernel, "lists-paths", flat, precision, lanes, false, lanes);
      }
      for (const auto& [name, features] : singles()) write(folder, kernel, name, features, precision, widest);
    }
  return 0;
}

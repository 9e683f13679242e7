// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/traversal.h"
#include "errors.h"
#include "image/file_bytes.h"
#include "json_text.h"

namespace strahl::bench {

using Json = nlohmann::ordered_json;

std::string json(const Traversal& traversal) {
  Json races = Json::array();
  for (const Race& race : traversal.races) {
    Json entries = Json::array();
    for (const Entry& entry : race.entries)
      entries.push_back({{"program", entry.program},
                         {"variant", entry.variant},
                         {"seconds", entry.seconds},
                         {"build_seconds", entry.build_seconds},
                         {"hits", entry.hits},
                         {"differing", entry.differing}});
    races.push_back({{"scene", race.scene},
                     {"primitives", race.primitives},
                     {"kind", race.kind},
                     {"rays", race.rays},
                     {"entries", entries}});
  }
  Json trees = Json::array();
  for (const Tree& tree : traversal.trees)
    trees.push_back({{"scene", tree.scene},
                     {"primitives", tree.primitives},
                     {"program", tree.program},
                     {"seconds", tree.seconds},
                     {"sah_cost", tree.sah_cost}});
  return json_text(Json{{"device", traversal.device},
                        {"machine", traversal.machine},
                        {"strahl", traversal.version},
                        {"threads", traversal.threads},
                        {"rounds", traversal.rounds},
                        {"races", races},
                        {"trees", trees}});
}

Traversal traversal_of_json(const std::string& text) try {
  const Json all = Json::parse(text);
  Traversal traversal{
      all.at("device"), all.at("machine"), all.at("strahl"), all.at("threads"), all.at("rounds"), {}, {}};
  for (const Json& race : all.at("races")) {
    Race& one = traversal.races.emplace_back(
        Race{race.at("scene"), race.at("primitives"), race.at("kind"), race.at("rays"), {}});
    for (const Json& entry : race.at("entries"))
      one.entries.push_back({entry.at("program"), entry.at("variant"), entry.at("seconds"), entry.at("build_seconds"),
                             entry.at("hits"), entry.at("differing")});
  }
  // Those of committed files that are older than the measurement of trees.
  for (const Json& tree : all.value("trees", Json::array()))
    traversal.trees.push_back(
        {tree.at("scene"), tree.at("primitives"), tree.at("program"), tree.at("seconds"), tree.at("sah_cost")});
  return traversal;
} catch (const nlohmann::json::exception& error) {
  throw InputError(std::string("no measurements of strahl-bench traversal: ") + error.what());
}

Traversal traversal_of_files(const std::vector<std::string>& paths) {
  Traversal all;
  for (const std::string& path : paths) {
    Traversal one;
    try {
      one = traversal_of_json(read_file(path));
    } catch (const InputError& fault) {
      throw InputError(fmt::format("{}: {}", path, fault.what()));
    }
    if (path == paths.front()) {
      all = std::move(one);
      continue;
    }
    if (one.device != all.device || one.machine != all.machine)
      throw InputError(
          fmt::format("{} is of {} ({}), and {} is of {} ({}); a report is of one device: give each its own", path,
                      one.device, one.machine, paths.front(), all.device, all.machine));
    all.races.insert(all.races.end(), one.races.begin(), one.races.end());
    all.trees.insert(all.trees.end(), one.trees.begin(), one.trees.end());
  }
  return all;
}

}  // namespace strahl::bench

// SPDX-License-Identifier: MIT
#include "bench/traversal_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/plot.h"

namespace strahl::bench {
namespace {

const double no_sample = std::nan("");

double mrays(const Race& race, const Entry& entry) {
  return static_cast<double>(race.rays) / median(entry.seconds) / 1e6;
}

bool is_ours(const Entry& entry) { return entry.program == "strahl"; }

const Entry* find(const Race& race, bool ours, const std::string& variant) {
  const auto at = std::find_if(race.entries.begin(), race.entries.end(),
                               [&](const Entry& entry) { return is_ours(entry) == ours && entry.variant == variant; });
  return at == race.entries.end() ? nullptr : &*at;
}

/// The peer's fastest way to ask single rays: its spheres come in two kinds.
const Entry* fastest_single(const Race& race, bool robust) {
  const Entry* best = nullptr;
  for (const std::string variant : {"1", "1 points"})
    if (const Entry* entry = find(race, false, variant + (robust ? " robust" : "")))
      if (best == nullptr || median(entry->seconds) < median(best->seconds)) best = entry;
  return best;
}

double ratio(const Entry* a, const Entry* b) { return a != nullptr && b != nullptr ? speed_ratio(*a, *b) : no_sample; }

/// "1,002,528".
std::string grouped(std::size_t n) {
  std::string text = std::to_string(n);
  for (std::size_t i = text.size(); i > 3;) text.insert(i -= 3, ",");
  return text;
}

std::string race_table(const Race& race) {
  std::string header = "| Mrays/s |  | differ |", rule = "|---|--:|--:|", peers = "| |  |  |", rows,
              off = "| differ | | |";
  for (const Entry& entry : race.entries) {
    if (is_ours(entry)) continue;
    header += fmt::format(" {} {} |", entry.program, entry.variant);
    rule += "--:|";
    peers += fmt::format(" {:.2f} |", mrays(race, entry));
    off += fmt::format(" {} |", entry.differing);
  }
  for (const Entry& entry : race.entries) {
    if (!is_ours(entry)) continue;
    rows += fmt::format("| strahl {} | {:.2f} | {} |", entry.variant, mrays(race, entry), entry.differing);
    for (const Entry& peer : race.entries)
      if (!is_ours(peer)) rows += fmt::format(" × {:.2f} |", speed_ratio(entry, peer));
    rows += "\n";
  }
  const Entry& first = race.entries.front();
  return fmt::format("#### {} rays: {}, of which {:.0f} % hit\n\n{}\n{}\n{}\n{}{}\n\n", race.kind, grouped(race.rays),
                     100 * static_cast<double>(first.hits) / static_cast<double>(std::max<std::size_t>(race.rays, 1)),
                     header, rule, peers, rows, off);
}

/// The entry of `fast` that has the same width of the tree as this one of single rays: "fast 8 wide" of "robust 8
/// wide".
std::string fast_beside(const std::string& variant) {
  const std::size_t end = variant.find(' ');
  return "fast" + (end == std::string::npos ? std::string() : variant.substr(end));
}

/// strahl's variants of single rays that ran beside `fast` with the same width, `fast` first; none where no other did.
std::vector<std::string> tiers_of(const Traversal& traversal) {
  std::vector<std::string> tiers;
  bool are_compared = false;
  for (const std::string tier : {"fast", "stable", "robust", "double"})
    for (const Race& race : traversal.races)
      for (const Entry& entry : race.entries) {
        const std::string& variant = entry.variant;
        if (!is_ours(entry) || variant.substr(0, variant.find(' ')) != tier || variant.ends_with(" coherent")) continue;
        if (find(race, true, fast_beside(variant)) == nullptr) continue;
        if (std::find(tiers.begin(), tiers.end(), variant) == tiers.end()) tiers.push_back(variant);
        are_compared = are_compared || tier != "fast";
      }
  return are_compared ? tiers : std::vector<std::string>{};
}

/// How many times as long as `fast` of the same width.
double tier_cost(const Race& race, const std::string& tier) {
  return ratio(find(race, true, fast_beside(tier)), find(race, true, tier));
}

std::string tier_table(const Traversal& traversal, const std::vector<std::string>& tiers) {
  std::string text = "| time, `fast` = 1 |", rule = "|---|";
  for (const std::string& tier : tiers) {
    text += fmt::format(" {} |", tier);
    rule += "--:|";
  }
  text += "\n" + rule + "\n";
  for (const Race& race : traversal.races) {
    text += fmt::format("| {}, {} |", race.scene, race.kind);
    for (const std::string& tier : tiers) {
      const double cost = tier_cost(race, tier);
      text += std::isnan(cost) ? " – |" : fmt::format(" {:.2f} |", cost);
    }
    text += "\n";
  }
  return text + "\n";
}

/// SAH cost of a binary tree: 1 a node, 1 a block of as many primitives as the device has lanes.
std::string tree_table(const Traversal& traversal) {
  std::string text = "| scene | builder | seconds | million primitives/s | SAH cost |\n|---|---|--:|--:|--:|\n";
  for (const Tree& tree : traversal.trees) {
    const double seconds = median(tree.seconds);
    text += fmt::format("| {} | {} | {:.3f} | {:.2f} | {:.2f} |\n", tree.scene, tree.program, seconds,
                        static_cast<double>(tree.primitives) / seconds / 1e6, tree.sah_cost);
  }
  return text + "\n";
}

/// --threads is the peers' alone: strahl's are its device's.
std::string peers_text(const Traversal& traversal) {
  for (const Race& race : traversal.races)
    if (!std::all_of(race.entries.begin(), race.entries.end(), is_ours))
      return fmt::format(", the peers with {} threads", traversal.threads);
  return {};
}

std::string family(const std::string& scene) { return scene.substr(0, scene.rfind('-')); }

}  // namespace

std::map<std::string, std::string> traversal_plots(const Traversal& traversal) {
  std::map<std::string, std::string> plots;
  std::map<std::pair<std::string, std::string>, std::vector<const Race*>> scaling;
  for (const Race& race : traversal.races) scaling[{family(race.scene), race.kind}].push_back(&race);
  for (auto& [key, races] : scaling) {
    if (races.size() < 2) continue;
    std::sort(races.begin(), races.end(), [](const Race* a, const Race* b) { return a->primitives < b->primitives; });
    std::vector<Series> series;
    for (const Entry& entry : races.front()->entries) {
      Series& one = series.emplace_back(Series{entry.program + " " + entry.variant, {}, {}});
      for (const Race* race : races) {
        const Entry* there = find(*race, is_ours(entry), entry.variant);
        one.x.push_back(static_cast<double>(race->primitives));
        one.y.push_back(there != nullptr ? mrays(*race, *there) : no_sample);
      }
    }
    plots[fmt::format("{}-{}.svg", key.first, key.second)] =
        line_plot(fmt::format("{}, {} rays", key.first, key.second), "primitives", "Mrays/s", series);
  }

  std::vector<std::string> groups;
  std::vector<Series> peers{{"robust to Embree's robust flag", {}, {}}, {"fast to Embree's default", {}, {}}};
  std::vector<Series> tiers;
  for (const std::string& tier : tiers_of(traversal)) tiers.push_back({tier, {}, {}});
  for (const Race& race : traversal.races) {
    groups.push_back(race.scene + ", " + race.kind);
    peers[0].y.push_back(ratio(find(race, true, "robust"), fastest_single(race, true)));
    peers[1].y.push_back(ratio(find(race, true, "fast"), fastest_single(race, false)));
    for (Series& tier : tiers) tier.y.push_back(tier_cost(race, tier.name));
  }
  const auto is_seen = [](const Series& series) {
    return std::any_of(series.y.begin(), series.y.end(), [](double y) { return !std::isnan(y); });
  };
  if (is_seen(peers[0]) || is_seen(peers[1]))
    plots["peers.svg"] = bar_plot("Speed by single rays, as a multiple of Embree's", "×", groups, peers, 1);
  if (std::any_of(tiers.begin(), tiers.end(), is_seen))
    plots["tiers.svg"] = bar_plot("What each tier costs", "time, fast = 1", groups, tiers, 1);
  return plots;
}

std::string markdown(const Traversal& traversal, const std::map<std::string, std::string>& plots,
                     const std::string& plot_folder) {
  std::string text = fmt::format(
      "strahl {} on all of {}; {}{}; medians of {} rounds in turns. × n: strahl is n times as fast, the median of the "
      "rounds' ratios. differ: rays with another answer than the first tier's.\n\n",
      traversal.version, traversal.device, traversal.machine, peers_text(traversal), traversal.rounds);
  std::string scene;
  for (const Race& race : traversal.races) {
    if (race.scene != scene) {
      scene = race.scene;
      text += fmt::format("### {}: {} primitives\n\n", scene, grouped(race.primitives));
    }
    text += race_table(race);
  }
  if (!traversal.trees.empty()) text += "### Trees\n\n" + tree_table(traversal);
  const std::vector<std::string> tiers = tiers_of(traversal);
  if (!tiers.empty()) text += "### What each tier costs\n\n" + tier_table(traversal, tiers);
  for (const auto& [name, svg] : plots) text += fmt::format("![{}]({}{})\n", name, plot_folder, name);
  return text;
}

}  // namespace strahl::bench

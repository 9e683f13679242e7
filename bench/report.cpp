// SPDX-License-Identifier: MIT
#include "bench/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "json_text.h"

namespace strahl::bench {

std::string markdown(const Run& run, const std::vector<Timing>& timings) {
  std::string header = "| primitive | hit |", rule = "|---|---|", rows;
  std::string workload;
  bool is_first_row = true;
  for (const Timing& timing : timings) {
    const bool is_first_tier = timing.workload != workload;
    if (is_first_tier) {
      is_first_row = workload.empty();
      workload = timing.workload;
      rows +=
          fmt::format("{}| {} × {} | {:.0f} % |", rows.empty() ? "" : "\n", timing.shapes, workload, 100 * timing.hits);
    }
    if (is_first_row) {
      header += fmt::format(" {} |", precision_name(timing.precision));
      rule += "---|";
    }
    rows += is_first_tier ? fmt::format(" {:.0f} ns |", timing.nanoseconds)
                          : fmt::format(" {:.0f} ns, × {:.2f} |", timing.nanoseconds, timing.ratio);
  }
  return fmt::format("{}, {} lanes, {} rays, median of {} rounds in turns:\n\n{}\n{}\n{}\n", run.device,
                     timings.empty() ? 0 : timings.front().lanes, run.rays, run.rounds, header, rule, rows);
}

std::string json(const Run& run, const std::vector<Timing>& timings) {
  nlohmann::ordered_json all{{"device", run.device}, {"rays", run.rays}, {"rounds", run.rounds}};
  all["timings"] = nlohmann::ordered_json::array();
  for (const Timing& timing : timings)
    all["timings"].push_back({{"workload", timing.workload},
                              {"shapes", timing.shapes},
                              {"precision", precision_name(timing.precision)},
                              {"lanes", timing.lanes},
                              {"nanoseconds", timing.nanoseconds},
                              {"least", timing.least},
                              {"most", timing.most},
                              {"ratio", timing.ratio},
                              {"hits", timing.hits}});
  return json_text(all);
}

}  // namespace strahl::bench

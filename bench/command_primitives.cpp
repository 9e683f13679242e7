// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "bench/commands.h"
#include "bench/primitives.h"
#include "bench/report.h"
#include "image/atomic_file.h"

namespace strahl::bench {
namespace {

struct PrimitivesCommand {
  std::string device;
  std::string json;
  std::vector<std::string> primitives = primitive_names();
  std::size_t rays = 16384;
  int rounds = 9;
};

void run(const PrimitivesCommand& options) {
  const Device device = Device::open(options.device);
  std::vector<Precision> tiers{Precision::fast, Precision::stable, Precision::robust};
  if (device.info().fp64) tiers.push_back(Precision::fp64);
  std::vector<Timing> timings;
  for (const std::string& name : options.primitives) {
    fmt::print(stderr, "strahl-bench: {}\n", name);
    for (const Timing& timing : time_tiers(device, primitive_workload(name, options.rays), tiers, options.rounds))
      timings.push_back(timing);
  }
  const Run how{device.info().text(), options.rays, options.rounds};
  fmt::print("{}", markdown(how, timings));
  if (options.json.empty()) return;
  AtomicFile file(options.json);
  file.write(json(how, timings));
  file.commit();
}

}  // namespace

Command add_primitives(CLI::App& app) {
  const auto options = std::make_shared<PrimitivesCommand>();
  app.add_option("-d,--device", options->device, "As in strahl -d; default: the fastest GPU, else CPU");
  app.add_option("--json", options->json, "Write the timings for programs too")->type_name("FILE");
  app.add_option("--primitives", options->primitives, "Only these, comma-separated")->delimiter(',')->type_name("LIST");
  app.add_option("--rays", options->rays, "Rays a launch")->capture_default_str()->check(CLI::Range(1, 1 << 18));
  app.add_option("--rounds", options->rounds, "Timed launches of each tier")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  return [options] { run(*options); };
}

}  // namespace strahl::bench

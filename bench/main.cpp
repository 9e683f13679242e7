// SPDX-License-Identifier: MIT
// strahl-bench: the table of bench/README.md on standard output, JSON on request.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "bench/primitives.h"
#include "bench/report.h"
#include "image/atomic_file.h"

using namespace strahl;

namespace {

struct Options {
  std::string device;
  std::string json;
  std::vector<std::string> primitives = bench::primitive_names();
  std::size_t rays = 16384;
  int rounds = 9;
};

void run(const Options& options) {
  const Device device = Device::open(options.device);
  std::vector<Precision> tiers{Precision::fast, Precision::stable, Precision::robust};
  if (device.info().fp64) tiers.push_back(Precision::fp64);
  std::vector<bench::Timing> timings;
  for (const std::string& name : options.primitives) {
    fmt::print(stderr, "strahl-bench: {}\n", name);
    for (const bench::Timing& timing :
         bench::time_tiers(device, bench::primitive_workload(name, options.rays), tiers, options.rounds))
      timings.push_back(timing);
  }
  const bench::Run how{device.info().text(), options.rays, options.rounds};
  fmt::print("{}", bench::markdown(how, timings));
  if (options.json.empty()) return;
  AtomicFile file(options.json);
  file.write(bench::json(how, timings));
  file.commit();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"What each tier of precision costs a primitive: brute force, lanes as the device likes", "strahl-bench"};
  app.add_option("-d,--device", options.device, "As in strahl -d; default: the fastest GPU, else CPU");
  app.add_option("--json", options.json, "Write the timings for programs too")->type_name("FILE");
  app.add_option("--primitives", options.primitives, "Only these, comma-separated")->delimiter(',')->type_name("LIST");
  app.add_option("--rays", options.rays, "Rays a launch")->capture_default_str()->check(CLI::Range(1, 1 << 18));
  app.add_option("--rounds", options.rounds, "Timed launches of each tier")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const Error& error) {
    fmt::print(stderr, "strahl-bench: {}\n", error.what());
    return static_cast<int>(error.exit_code());
  }
  return 0;
}

// SPDX-License-Identifier: MIT
// strahl-bench-loaders: how fast mesh files are read. Each kind of file is written into a folder of its own, read once
// for the caches and then `rounds` times; the time is that of the processor, which other programs do not disturb.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <filesystem>

#include "bench/mesh_files.h"
#include "bench/race.h"
#include "scene/mesh_file.h"

using namespace strahl;

namespace {

struct Options {
  std::vector<std::string> kinds = bench::mesh_kinds();
  std::uint64_t triangles = 500'000;
  int rounds = 5;
  std::string write;
};

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void time_kind(const std::string& kind, const Options& options, const std::filesystem::path& folder) {
  const std::string path = (folder / (kind + bench::extension_of(kind))).string();
  bench::write_mesh_file(path, kind, options.triangles);
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  std::vector<double> seconds;
  std::size_t triangles = 0, vertices = 0;
  for (int round = 0; round <= options.rounds; ++round) {
    const double begin = processor_seconds();
    const MeshFile file = read_mesh(path);
    if (round > 0) seconds.push_back(processor_seconds() - begin);
    triangles = file.mesh.triangles.size(), vertices = file.mesh.positions.size();
  }
  std::filesystem::remove(path);
  if (triangles < options.triangles) throw Error(fmt::format("{}: {} triangles came back", kind, triangles));
  const double median = bench::median(seconds);
  fmt::print("| {} | {:.1f} | {} | {} | {:.3f} | {:.0f} | {:.1f} |\n", kind, megabytes, triangles, vertices, median,
             megabytes / median, static_cast<double>(triangles) / 1e6 / median);
}

void run(const Options& options) {
  if (!options.write.empty()) {
    const std::string kind = options.kinds.size() == 1 ? options.kinds[0] : "ply";
    return bench::write_mesh_file(options.write, kind, options.triangles);
  }
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("strahl-loaders-{}", std::time(nullptr));
  std::filesystem::create_directories(folder);
  fmt::print("| file | MB | triangles | vertices | s | MB/s | Mtriangles/s |\n|---|---|---|---|---|---|---|\n");
  for (const std::string& kind : options.kinds) time_kind(kind, options, folder);
  std::filesystem::remove_all(folder);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"How fast mesh files are read, in megabytes and triangles a second", "strahl-bench-loaders"};
  app.add_option("--kinds", options.kinds, "Only these, comma-separated")->delimiter(',')->type_name("LIST");
  app.add_option("--triangles", options.triangles, "Of each file")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--rounds", options.rounds, "Timed readings of each file")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--write", options.write, "Only write the mesh (--kinds, default ply) to this file")
      ->type_name("FILE");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "strahl-bench-loaders: {}\n", error.what());
    return 1;
  }
  return 0;
}

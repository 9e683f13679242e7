// SPDX-License-Identifier: MIT
// How fast mesh files are read. Times are the processor's, which other programs do not disturb.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <memory>

#include "bench/commands.h"
#include "bench/mesh_files.h"
#include "bench/race.h"
#include "scene/meshes/mesh_file.h"

namespace strahl::bench {
namespace {

struct LoaderOptions {
  std::vector<std::string> kinds = mesh_kinds();
  std::uint64_t triangles = 500'000;
  int rounds = 5;
};

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void time_kind(const std::string& kind, const LoaderOptions& options) {
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("strahl-{}-{}{}", getpid(), kind, extension_of(kind)))
          .string();
  write_mesh_file(path, kind, options.triangles);
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  std::vector<double> seconds;
  std::size_t triangles = 0, vertices = 0;
  for (int round = 0; round <= options.rounds; ++round) {  // the first warms up
    const double begin = processor_seconds();
    const MeshFile file = read_mesh(path);
    if (round > 0) seconds.push_back(processor_seconds() - begin);
    triangles = file.mesh.triangles.size(), vertices = file.mesh.positions.size();
  }
  std::filesystem::remove(path);
  if (triangles < options.triangles) throw Error(fmt::format("{}: {} triangles came back", kind, triangles));
  const double middle = median(seconds);
  fmt::print("| {} | {:.1f} | {} | {} | {:.3f} | {:.0f} | {:.1f} |\n", kind, megabytes, triangles, vertices, middle,
             megabytes / middle, static_cast<double>(triangles) / 1e6 / middle);
}

}  // namespace

Command add_loaders(CLI::App& app) {
  const auto options = std::make_shared<LoaderOptions>();
  app.add_option("--kinds", options->kinds, "Only these, comma-separated")->delimiter(',')->type_name("LIST");
  app.add_option("--triangles", options->triangles, "Of each file")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--rounds", options->rounds, "Timed readings of each file")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  return [options] {
    fmt::print("| file | MB | triangles | vertices | s | MB/s | Mtriangles/s |\n|---|---|---|---|---|---|---|\n");
    for (const std::string& kind : options->kinds) time_kind(kind, *options);
  };
}

Command add_mesh(CLI::App& app) {
  const auto kind = std::make_shared<std::string>();
  const auto path = std::make_shared<std::string>();
  const auto triangles = std::make_shared<std::uint64_t>(10'000'000);
  app.add_option("KIND", *kind, fmt::format("{}", fmt::join(mesh_kinds(), ", ")))->required();
  app.add_option("FILE", *path)->required();
  app.add_option("--triangles", *triangles, "At least so many")->capture_default_str()->check(CLI::PositiveNumber);
  return [kind, path, triangles] { write_mesh_file(*path, *kind, *triangles); };
}

}  // namespace strahl::bench

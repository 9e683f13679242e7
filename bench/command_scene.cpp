// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "bench/commands.h"
#include "bench/scene_files.h"
#include "study/generated/scenes.h"

namespace strahl::bench {

Command add_scene(CLI::App& app) {
  const auto name = std::make_shared<std::string>();
  const auto paths = std::make_shared<std::vector<std::string>>();
  app.add_option("SCENE", *name, fmt::format("{}", fmt::join(generated_scene_forms(), ", ")))->required();
  app.add_option("FILES", *paths, "By suffix: .xml (strahl, Mitsuba), .pov (POV-Ray), .dat (Tachyon)")->required();
  const auto cloud = std::make_shared<bool>(false);
  app.add_flag("--cloud", *cloud, "In .xml: the spheres in a PLY file beside it");
  return [name, paths, cloud] {
    const Scene scene = generated_scene(*name);
    for (const std::string& path : *paths)
      *cloud&& path.ends_with(".xml") ? write_scene_with_cloud(scene, path) : write_scene(scene, path);
  };
}

}  // namespace strahl::bench

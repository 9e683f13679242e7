// SPDX-License-Identifier: MIT
// Options that take the place of what the scene says: integrator, sampler, film.
#pragma once

#include <optional>
#include <string>

#include "scene/model/scene.h"

namespace CLI {
class App;
}

namespace strahl::cli {

struct SceneOverrides {
  std::optional<std::string> integrator;
  std::optional<int> max_depth;
  std::optional<int> spp;
  std::optional<int> seed;
  std::optional<std::string> sampler;  ///< "sobol", "independent", "centre"
  std::optional<int> width, height;    ///< One alone: the other follows, so that the aspect ratio stays.
  std::optional<std::string> crop;     ///< "x0,y0,x1,y1"
  std::optional<std::string> pixel;    ///< "x,y"
};

void add_scene_overrides(CLI::App& app, SceneOverrides& overrides);

/// Throws UsageError for an unknown integrator, for a crop window outside the picture, and for a side that would be too
/// long.
void apply(const SceneOverrides& overrides, Scene& scene);

/// For studies at a size of their own: without the scene's crop window, whose pixels would be others there; warns of
/// it.
void show_whole_picture(Film& film);

}  // namespace strahl::cli

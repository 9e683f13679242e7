// SPDX-License-Identifier: MIT
// Options that take the place of what the scene says, applied to the loaded scene before anything is built from it.
#include "cli/scene_overrides.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "cli/console.h"
#include "cli/number_options.h"
#include "did_you_mean.h"
#include "kinds/integrators.h"
#include "program/kernel_source.h"
#include "scene/auto_integrator.h"
#include "settings/sampler_name.h"
#include "settings/sampling.h"

namespace strahl::cli {
namespace {

constexpr int max_size = 65536;  // As validate.h.

std::vector<int> integers(const std::string& option, const std::string& text, std::size_t count, const char* form) {
  std::vector<int> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (values.size() < count) {
    int value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) break;
    values.push_back(value);
    at = next;
    if (at == end || *at != ',') break;
    ++at;
  }
  if (values.size() != count || at != end)
    throw UsageError(fmt::format("{} takes {} (whole numbers of pixels), not \"{}\"", option, form, text));
  return values;
}

/// Of the side that no option states. A picture that is so narrow has a pixel all the same.
int scaled(int length, int numerator, int denominator, const char* side) {
  const double exact = std::round(static_cast<double>(length) * numerator / denominator);
  if (exact > max_size)
    throw UsageError(
        fmt::format("at the scene's aspect ratio the {} would be {:.0f} pixels, more than {}; ask for fewer", side,
                    exact, max_size));
  return std::max(static_cast<int>(exact), 1);
}

void resize(const SceneOverrides& overrides, Film& film) {
  const int width = film.width;
  const int height = film.height;
  if (overrides.width) film.width = *overrides.width;
  if (overrides.height) film.height = *overrides.height;
  if (overrides.width && !overrides.height) film.height = scaled(height, film.width, width, "height");
  if (overrides.height && !overrides.width) film.width = scaled(width, film.height, height, "width");
}

void require_inside(const Window& window, const Film& film, const std::string& whose) {
  if (window.x0 < 0 || window.y0 < 0 || window.x1 > film.width || window.y1 > film.height)
    throw UsageError(fmt::format("{} {},{},{},{} reaches outside the picture of {} x {} pixels", whose, window.x0,
                                 window.y0, window.x1, window.y1, film.width, film.height));
  if (window.width() < 1 || window.height() < 1)
    throw UsageError(fmt::format("{} {},{},{},{} is empty: it holds the pixels x0 <= x < x1, y0 <= y < y1", whose,
                                 window.x0, window.y0, window.x1, window.y1));
}

void crop(const SceneOverrides& overrides, Film& film) {
  if (overrides.crop) {
    const std::vector<int> c = integers("--crop", *overrides.crop, 4, "x0,y0,x1,y1");
    film.crop = Window{c[0], c[1], c[2], c[3]};
    require_inside(*film.crop, film, "--crop");
  } else if (overrides.pixel) {
    const std::vector<int> p = integers("--pixel", *overrides.pixel, 2, "x,y");
    if (p[0] < 0 || p[1] < 0 || p[0] >= film.width || p[1] >= film.height)
      throw UsageError(
          fmt::format("--pixel {},{} lies outside the picture of {} x {} pixels", p[0], p[1], film.width, film.height));
    film.crop = Window{p[0], p[1], p[0] + 1, p[1] + 1};
  } else if (film.crop && (overrides.width || overrides.height)) {
    require_inside(*film.crop, film, "state --crop: the scene's crop window");
  }
}

/// Paths from lights end anywhere in the picture, so that --pixel takes none, as rays through the pixels' middles do
/// not.
void choose(const SceneOverrides& overrides, Scene& scene) {
  const std::optional<SamplerKind> kind = scene.sampler.kind;
  if (overrides.pixel) scene.sampler.kind = SamplerKind::centre;
  choose_integrator(scene);
  scene.sampler.kind = kind;
}

}  // namespace

void add_scene_overrides(CLI::App& app, SceneOverrides& overrides) {
  const std::string group = "Instead of what the scene says";
  app.add_option("--integrator", overrides.integrator,
                 fmt::format("auto, {}", fmt::join(list_entries("integrators"), ", ")))
      ->type_name("NAME")
      ->group(group);
  require_whole(
      app.add_option("--max-depth", overrides.max_depth, "1: emission only, 2: one bounce, ...; -1: no limit"))
      ->type_name("N")
      ->check(CLI::Range(-1, std::numeric_limits<int>::max()).description(""))
      ->group(group);
  require_whole(app.add_option("--spp", overrides.spp, "Samples per pixel"))
      ->type_name("N")
      ->check(CLI::Range(1, max_spp).description(""))
      ->group(group);
  require_whole(
      app.add_option("--seed", overrides.seed, "Another seed gives other noise, the same one the same picture"))
      ->type_name("N")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()).description(""))
      ->group(group);
  app.add_option("--sampler", overrides.sampler,
                 "sobol (spread evenly), independent (random), or centre: rays through the pixels' middles")
      ->type_name("NAME")
      ->check(CLI::IsMember({"sobol", "independent", "centre"}))
      ->group(group);
  require_whole(app.add_option("--width", overrides.width, "Pixels; without --height the aspect ratio stays"))
      ->type_name("N")
      ->check(CLI::Range(1, max_size).description(""))
      ->group(group);
  require_whole(app.add_option("--height", overrides.height, "Pixels; without --width the aspect ratio stays"))
      ->type_name("N")
      ->check(CLI::Range(1, max_size).description(""))
      ->group(group);
  CLI::Option* crop_option =
      app.add_option("--crop", overrides.crop, "Only the pixels x0 <= x < x1, y0 <= y < y1; the picture is that large")
          ->type_name("x0,y0,x1,y1")
          ->group(group);
  app.add_option("--pixel", overrides.pixel,
                 "Only this pixel; `render` prints its linear R G B, and writes a picture only with -o")
      ->type_name("x,y")
      ->excludes(crop_option)
      ->group(group);
}

void apply(const SceneOverrides& overrides, Scene& scene) {
  if (overrides.sampler) scene.sampler.kind = sampler_from_name(*overrides.sampler);
  const bool is_auto = overrides.integrator ? overrides.integrator == "auto" : !scene.integrator.why.empty();
  if (is_auto) {
    scene.integrator.max_depth = overrides.max_depth.value_or(scene.integrator.max_depth);
    choose(overrides, scene);
  } else if (overrides.integrator) {
    std::vector<std::string> known = list_entries("integrators");
    known.emplace_back("auto");
    const std::string name =
        *overrides.integrator == "particle" ? "ptracer" : *overrides.integrator;  // Mitsuba's alias.
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UsageError(fmt::format("unknown integrator \"{}\"{}; known: {}", name, did_you_mean(name, known),
                                   fmt::join(known, ", ")));
    scene.integrator.name = name;
    scene.integrator.why.clear();
  }
  if (overrides.max_depth) scene.integrator.max_depth = *overrides.max_depth;
  if (overrides.spp) scene.sampler.sample_count = *overrides.spp;
  if (overrides.seed) scene.sampler.seed = *overrides.seed;
  resize(overrides, scene.film);
  crop(overrides, scene.film);
  if (overrides.pixel && kinds::integrator(scene.integrator.name).from_lights)
    throw UsageError(
        fmt::format("--pixel: integrator {} begins its paths on lights, and of those of one pixel hardly "
                    "any ends there; take integrator path, or --crop for a part of the picture",
                    scene.integrator.name));
}

void show_whole_picture(Film& film) {
  if (film.crop) say("strahl: warning: the scene's crop window is not taken: the study is of the whole picture");
  film.crop.reset();
}

}  // namespace strahl::cli

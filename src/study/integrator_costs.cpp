// SPDX-License-Identifier: MIT
#include "study/integrator_costs.h"

#include <algorithm>
#include <cmath>

#include "errors.h"
#include "kinds/integrators.h"
#include "render/pilot.h"
#include "render/renderer.h"
#include "scene/auto_integrator.h"
#include "scene/empty_media.h"
#include "scene/integrator_advice.h"
#include "settings/sampling.h"

namespace strahl {
namespace {

constexpr int most_pixels = 128;  ///< Of a pilot's longer side.

/// As the scene's picture, all of it or its crop window, with fewer pixels.
Scene pilot_scene(Scene scene) {
  const Window window = scene.film.window();
  const int longer = std::max(window.width(), window.height());
  if (longer <= most_pixels) return scene;
  const double factor = static_cast<double>(most_pixels) / longer;
  const auto fewer = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(factor * pixels))); };
  Film& film = scene.film;
  const double across = static_cast<double>(fewer(film.width)) / film.width;
  const double down = static_cast<double>(fewer(film.height)) / film.height;
  film.width = fewer(film.width);
  film.height = fewer(film.height);
  if (!film.crop) return scene;
  Window& crop = *film.crop;
  const auto scaled = [](int at, double by, int most) {
    return std::clamp(static_cast<int>(std::lround(by * at)), 0, most);
  };
  crop.x0 = scaled(crop.x0, across, film.width - 1);
  crop.y0 = scaled(crop.y0, down, film.height - 1);
  crop.x1 = std::max(crop.x0 + 1, scaled(crop.x1, across, film.width));
  crop.y1 = std::max(crop.y0 + 1, scaled(crop.y1, down, film.height));
  return scene;
}

double pixels_of(const Scene& scene) {
  const Window window = scene.film.window();
  return static_cast<double>(window.width()) * window.height();
}

/// Of one integrator, before the error to reach is known.
struct Piloted {
  IntegratorCost cost;
  Pilot pilot;
};

Piloted piloted(const Device& device, const Scene& scene, const RenderSettings& settings, double seconds) {
  Piloted found;
  try {
    Renderer renderer(device, scene, settings);
    RenderGoal first;
    first.spp = 1;
    static_cast<void>(renderer.render({}, first));  // The driver's part of building comes with the first launch.
    found.pilot = run_pilot(renderer, renderer.most_samples(), [&](const Pilot&) { return seconds; });
    found.cost.build_seconds = renderer.build_seconds();
    found.cost.mean = found.pilot.mean;
    found.cost.has_finite_samples = found.pilot.not_finite == 0;
    const PassCost& last = found.pilot.passes.back();
    found.cost.sample_seconds = last.seconds / last.samples;
  } catch (const SceneError& error) {
    found.cost.refused = error.diagnostics().empty() ? error.what() : error.diagnostics().front().message;
  } catch (const UsageError& error) {
    found.cost.refused = error.what();
  }
  return found;
}

/// A pilot alone says little about how the error goes on falling. Of independent samples its square does as 1 / n, of
/// even ones a little faster.
void weigh_exponent(bool is_independent, ErrorTrend& law) {
  const double usual = is_independent ? 1 : 1.1, spread = is_independent ? 0.01 : 0.1;
  const double known = 1 / (spread * spread), measured = 1 / std::max(1e-6, law.exponent_spread * law.exponent_spread);
  law.exponent = (known * usual + measured * law.exponent) / (known + measured);
  law.exponent_spread = 1 / std::sqrt(known + measured);
}

/// factor: of the scene's pixels to the pilot's; most: samples that the film of the scene's picture holds.
void set_prediction(const Pilot& pilot, bool is_independent, double rmse, double factor, int most,
                    IntegratorCost& cost) {
  if (pilot.not_finite > 0 || pilot.looks.empty() || !(pilot.looks.back().mse > 0) || !(rmse > 0)) return;
  RunCosts costs;
  costs.passes = pilot.passes;
  for (PassCost& pass : costs.passes) pass.seconds *= factor;
  costs.spread = pilot.spread;
  costs.look = factor * pilot.look_seconds;
  PredictedGoal goal;
  goal.spp = most;
  goal.max_error = rmse;
  ErrorTrend law = error_trend(pilot.looks, pilot.common_spread);
  weigh_exponent(is_independent, law);
  const Prediction found = predict(law, costs, goal);
  cost.seconds = found.seconds;
  cost.spp = found.spp;
  cost.is_beyond_film = found.spp.middle >= most;
}

int most_samples(const Film& film, const RenderSettings& settings, const std::string& integrator) {
  Scene picture;
  picture.film = film;
  picture.integrator.name = integrator;
  return Renderer::most_samples(picture, settings);
}

std::string simplified(Scene scene, const std::string& name) {
  scene.integrator.name = name;
  simplify_integrator(scene);
  return scene.integrator.name;
}

/// That the scene's paths could be followed by, each program once, unless it is asked for by name.
std::vector<std::string> names_for(const Scene& scene, const std::set<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : light_transport_names())
    if (names.empty() ? simplified(scene, name) == name : names.contains(name)) found.push_back(name);
  return found;
}

/// seconds: of the pilot.
Piloted measured(const Device& device, Scene scene, const RenderSettings& settings, double seconds,
                 const std::string& name) {
  Piloted found;
  if (const std::string same = simplified(scene, name); same != name) {
    found.cost.refused = "without media, masks and panes of thin glass it is " + same + ": name that one";
  } else {
    scene.integrator.name = name;
    const std::vector<std::string> misses = integrator_misses(scene);
    leave_out_empty_media(scene);
    found = piloted(device, scene, settings, seconds);
    found.cost.misses = misses;
  }
  found.cost.integrator = name;
  return found;
}

}  // namespace

std::vector<std::string> light_transport_names() {
  std::vector<std::string> found;
  for (const std::string& name : kinds::integrator_names())
    if (kinds::integrator(name).is_lit()) found.push_back(name);
  return found;
}

IntegratorCosts measure_integrators(const Device& device, const Scene& scene, const RenderSettings& settings,
                                    double pilot_seconds, double share, const StudyProgress& progress,
                                    const std::set<std::string>& names) {
  const Scene small = pilot_scene(scene);
  RenderSettings plain = settings;
  plain.estimate_error = true;
  plain.aovs.clear();
  const double factor = pixels_of(scene) / pixels_of(small);
  IntegratorCosts costs;
  costs.width = small.film.window().width();
  costs.height = small.film.window().height();
  costs.pilot_seconds = pilot_seconds;
  costs.share = share;
  std::vector<Piloted> all;
  double own = 0, brightest = 0;
  const std::string own_name = simplified(scene, scene.integrator.name);
  const std::vector<std::string> asked = names_for(scene, names);
  const bool is_own_alone = kinds::integrator(own_name).is_lit() && std::ranges::find(asked, own_name) == asked.end();
  const auto pilots = static_cast<double>(asked.size() + (is_own_alone ? 1 : 0));
  for (const std::string& name : asked) {
    if (progress) progress(static_cast<double>(all.size()) / pilots);
    all.push_back(measured(device, small, plain, pilot_seconds, name));
    IntegratorCost& cost = all.back().cost;
    cost.sample_seconds *= factor;
    if (name == own_name) own = cost.mean;
    brightest = std::max(brightest, cost.mean);
  }
  // The error is that of the scene's picture, whichever integrators are compared.
  if (is_own_alone) {
    if (progress) progress(static_cast<double>(all.size()) / pilots);
    own = measured(device, small, plain, pilot_seconds, own_name).cost.mean;
  }
  const bool is_independent = resolve_sampling(scene).kind == SamplerKind::independent;
  costs.rmse = share * (own > 0 ? own : brightest);
  for (Piloted& one : all) {
    if (one.cost.refused.empty())
      set_prediction(one.pilot, is_independent, costs.rmse, factor,
                     most_samples(scene.film, plain, one.cost.integrator), one.cost);
    costs.integrators.push_back(std::move(one.cost));
  }
  if (progress) progress(1);
  return costs;
}

}  // namespace strahl

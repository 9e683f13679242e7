// SPDX-License-Identifier: MIT
// Checks every entry of cl/integrators/integrators.def against light that is known in closed form, in every tier: a
// ball that reflects half of a white sky, and a hollow ball that emits one half and reflects the other (a furnace).
// Every width has the bits of one lane, sample by sample. A new entry needs one row in `integrator_rows`.
#include "kinds/integrators.h"
#include "physics/rows.h"
#include "physics/transport_scenes.h"
#include "render/film_sum.h"
#include "scene/model/build.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct IntegratorRow {
  std::string entry;  ///< Of integrators.def.
  Triad ball, sky;    ///< Along a ray that meets the ball's nearest point, and past it.
  Triad furnace;      ///< From the hollow ball's middle along x.
};

std::vector<IntegratorRow> integrator_rows() {
  const Triad none{0, 0, 0}, half{0.5, 0.5, 0.5}, white{1, 1, 1}, once{0.75, 0.75, 0.75};
  return {{"emission", none, white, half},
          {"depth", {2, 2, 2}, none, {2, 2, 2}},
          {"normals", {0.5, 0.5, 1}, none, {0, 0.5, 0.5}},
          {"direct", half, white, once},
          {"whitted", half, white, once},
          {"path", half, white, white},
          {"volpath", half, white, white},
          {"ao", white, none, none},
          {"ptracer", half, white, white},
          {"bdpt", half, white, white}};
}

const std::vector<std::string> integrator_entries = {
#define INTEGRATOR(name) #name,
#include "../../cl/integrators/integrators.def"
#undef INTEGRATOR
};

/// Of radius 2: places on it are no normals.
Scene ball(const std::string& integrator) {
  Scene scene = empty_scene();
  scene.integrator.name = integrator;
  scene.shapes.emplace_back().geometry = Sphere{{0, 0, 0}, 2};
  return scene;
}

Scene ball_under_sky(const std::string& integrator) {
  Scene scene = ball(integrator);
  scene.lights.emplace_back().emitter = ConstantLight{{1, 1, 1}};
  return scene;
}

Scene furnace(const std::string& integrator) {
  Scene scene = ball(integrator);
  scene.shapes.front().flip_normals = true;
  scene.shapes.front().radiance = Rgb{0.5, 0.5, 0.5};
  return scene;
}

const double far_off = 1e30;
const GivenRay at_ball{{0, 0, 4}, {0, 0, -1}, 0, far_off}, past_ball{{0, 0, 4}, {1, 0, 0}, 0, far_off},
    from_middle{{0, 0, 0}, {1, 0, 0}, 0, far_off};
constexpr std::uint32_t samples = 2048;

void hold_radiance(const char* what, const TransportTier& tier, const Scene& scene, const GivenRay& ray,
                   const Triad& expected) {
  INFO(what);
  const std::vector<Triad> found = tier.radiance(TierScene(scene, tier).buffers(), ray, samples);
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const Triad& one : found) values.push_back(one[k]);
    const Mean mean = mean_of(values);
    CHECK(mean.value == Approx(expected[k]).margin(5 * mean.noise + 1000 * roundoff(tier)));
    // A large error fails even if the noise is large.
    CHECK(mean.noise < 0.05);
  }
}

/// A picture of one pixel, of what is seen along the ray and beside it.
Scene seen_along(Scene scene, const GivenRay& ray) {
  scene.film.width = scene.film.height = 1;
  scene.film.filter = {FilterKind::box, 0.5, 0.5};
  scene.camera = perspective_camera(vec(ray.o), vec(ray.o) + vec(ray.d), {0, 1, 0}, 40);
  return scene;
}

constexpr std::uint32_t light_paths = 40'000;

std::vector<std::int64_t> splats_of(const TransportTier& tier, const Scene& scene) {
  return tier.splats(TierScene(scene, tier).buffers(), light_paths);
}

/// By paths from the lights.
void hold_splats(const char* what, const TransportTier& tier, const Scene& scene, const Triad& expected) {
  INFO(what);
  const std::vector<std::int64_t> words = splats_of(tier, scene);
  constexpr std::size_t sums = layout::FILM_SUBSUMS * layout::FILM_CHANNELS;
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (std::size_t at = k; at < sums; at += layout::FILM_CHANNELS) {
      const std::int64_t* own = &words[sums * layout::SPLAT_WORDS + at * layout::FILM_SUM_WORDS];
      sum += value_of_splats(&words[at * layout::SPLAT_WORDS]) + value_of(film_bins(own[0], own[1]));
    }
    // The largest standard error of the three is 0.008.
    CHECK(sum / light_paths == Approx(expected[k]).margin(0.03));
  }
}

TEST_CASE("every integrator has a row") {
  hold_rows("integrators.def", integrator_entries, integrator_rows(), [](const IntegratorRow& row) {
    return TierScene(ball_under_sky(row.entry), true, 1).index(layout::HEADER_INTEGRATOR);
  });
}

TEST_CASE("integrators make of a white sky and of a furnace what the closed form does") {
  for (const IntegratorRow& row : integrator_rows())
    for (const TransportTier& tier : asked_widths(transport_tiers())) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << row.entry);
      if (kinds::integrator(row.entry).from_lights) {
        hold_splats("ball", tier, seen_along(ball_under_sky(row.entry), at_ball), row.ball);
        hold_splats("sky", tier, seen_along(ball_under_sky(row.entry), past_ball), row.sky);
        hold_splats("furnace", tier, seen_along(furnace(row.entry), from_middle), row.furnace);
        continue;
      }
      hold_radiance("ball", tier, ball_under_sky(row.entry), at_ball, row.ball);
      hold_radiance("sky", tier, ball_under_sky(row.entry), past_ball, row.sky);
      hold_radiance("furnace", tier, furnace(row.entry), from_middle, row.furnace);
    }
}

/// A floor of reflectance 1/2, 1 below the camera, whose pixel sees it 2 tan 20 degrees wide.
Scene floor_seen_from_above(const std::string& integrator) {
  Scene scene = empty_scene();
  scene.integrator.name = integrator;
  scene.shapes.emplace_back().geometry = Rectangle{{-3, -3, 0}, {6, 0, 0}, {0, 6, 0}};
  scene = seen_along(scene, {{0, 0, 1}, {0, 0, -1}, 0, far_off});
  return scene;
}

// A floor under light of irradiance E has the radiance E / (2 pi), and a beam that ends in a pixel is seen with all of
// its power.
TEST_CASE("beams light what they end on with all of their power, and nothing else") {
  const double pi = std::numbers::pi, side = 2 * std::tan(20 * pi / 180);
  for (const std::string integrator : {"ptracer", "bdpt"})
    for (const TransportTier& tier : asked_widths(transport_tiers())) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << integrator);
      Scene sheet = floor_seen_from_above(integrator), tilted = sheet, beam = sheet, beside = sheet;
      const auto shine = [&](Scene& scene, const Rectangle& lamp) {
        scene.shapes.emplace_back().geometry = lamp;
        scene.shapes.back().exitance = Rgb{2 * pi, pi, 0};
        scene.materials.push_back({});
        scene.materials.back().bsdf = Diffuse{{{0, 0, 0}}};
        scene.shapes.back().material = 1;
      };
      shine(sheet, {{-0.75, -0.5, 2}, {0, 1, 0}, {1.5, 0, 0}});
      hold_splats("sheet", tier, sheet, {1, 0.5, 0});
      // From 60 degrees off the floor's normal; twice as long on the floor as it is wide.
      shine(tilted,
            {{2 * std::sqrt(3.0) - 0.25, -0.5, 2 + 0.25 * std::sqrt(3.0)}, {0, 1, 0}, {0.5, 0, -0.5 * std::sqrt(3.0)}});
      hold_splats("tilted", tier, tilted, {0.5, 0.25, 0});
      const double power = 2 * pi * side * side;
      beam.lights.emplace_back().emitter = CollimatedLight{{3, 0.2, 3}, {-2.9, 0, -3}, {power, power / 2, 0}};
      hold_splats("beam", tier, beam, {1, 0.5, 0});
      beside.lights.emplace_back().emitter = CollimatedLight{{3, 0.2, 3}, {-2, 0, -3}, {power, power, power}};
      hold_splats("beside", tier, beside, {0, 0, 0});
    }
}

TEST_CASE("every width makes of a sample what one lane does, to the bit") {
  std::map<std::string, TransportTier> narrow;
  for (const TransportTier& tier : transport_tiers())
    if (tier.lanes == 1) narrow.emplace(tier.name, tier);
  for (const IntegratorRow& row : integrator_rows())
    for (const TransportTier& tier : transport_tiers()) {
      if (tier.lanes == 1) continue;
      INFO(tier.name << ", " << tier.lanes << " lanes, " << row.entry);
      const TransportTier& one = narrow.at(tier.name);
      if (kinds::integrator(row.entry).from_lights) {
        const Scene scene = seen_along(furnace(row.entry), from_middle);
        CHECK(splats_of(tier, scene) == splats_of(one, scene));
        continue;
      }
      for (const Scene& scene : {ball_under_sky(row.entry), furnace(row.entry)})
        CHECK(tier.radiance(TierScene(scene, tier).buffers(), at_ball, 99) ==
              one.radiance(TierScene(scene, one).buffers(), at_ball, 99));
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// One surface of a path: dispatch over the active integrators, then light from lights and the way on, each in one place
// for all integrators, so that a program holds one traversal for shadows and one for everything else.
// One width; no guard.
#include "core/counters.h"
#include "core/departure.h"
#include "core/footprint.h"
#include "core/openness.h"
#include "core/path.h"
#include "lights/light.h"
#include "materials/material.h"
#include "samplers/sampler.h"

enum {
  STEP_LIGHTS = 1,    ///< Add what the lights throw on the surface.
  STEP_MIRROR = 2,    ///< Follow the mirrored ray.
  STEP_SCATTER = 4,   ///< Follow a way that the material draws; drawn lights then share their work with it.
  STEP_ROULETTE = 8,  ///< Perhaps not.
  STEP_OPENNESS = 16  ///< Add white if a way into the open meets nothing.
};

/// What comes along the path's ray by itself: the surface's emission, or the background where nothing is hit.
FN real3 radiance_along(const Scene* scene, int hit, const Surface* s) {
  return hit ? emitted_radiance(scene, s) : background_radiance(scene);
}

/// hide_emitters hides from the camera alone.
FN int is_light_shown(const Scene* scene, const Path* path) { return path->depth > 0 || !hides_emitters(scene); }

FN int lights_drawn_from(const Scene* scene) {
  return scene->index[HEADER_LIGHT_COUNT] - scene->index[HEADER_LIGHTS_TAKEN];
}

/// Of a direction that was drawn with `density` and could have been with `other`.
FN real balance(real density, real other) {
  real ratio = other / density;
  return R(1.0) / real_fma(ratio, ratio, R(1.0));
}

/// radiance_along, weighted against its chance to be drawn as a light where the path was.
FN void path_add_light(const Scene* scene, Path* path, int hit, const Surface* s) {
  real3 radiance = radiance_along(scene, hit, s);
  if (LIGHT_COUNT > 0 && path->density > R(0.0) && max3(radiance) > R(0.0)) {
    int light = hit ? scene_part(scene, s->part)[PART_LIGHT] : scene->index[HEADER_BACKGROUND];
    if (light >= 0) {
      real density = light_density(scene, light, path->from, s, path->ray.d) / (real)lights_drawn_from(scene);
      radiance = scale3(balance(path->density, density), radiance);
    }
  }
  path_add(path, radiance);
}

#include "integrators/all.h"

/// One light of those that are taken, or one drawn of the others; is_shared: with ways that the material draws.
FN real3 light_gain(const Scene* scene, const Path* path, const Surface* s, const Material* m, int i, int is_shared,
                    LightSample* light) {
  int taken = scene->index[HEADER_LIGHTS_TAKEN];
  Random2 numbers;
  numbers.x = numbers.y = 0u;
  real share = R(1.0);
  if (i >= taken) {
    uint count = (uint)lights_drawn_from(scene);
    numbers = sample_pair(scene, &path->sample, set_at(path->depth, SET_LIGHT));
    i = taken + (int)high_product(numbers.x, count);
    numbers.x *= count;
    share = (real)count;
  }
  *light = light_sample(scene, i, s->position, numbers);
  if (!(max3(light->irradiance) > R(0.0))) return black3();
  real density;
  real3 reflected = mul3(material_eval(m, unit3(light->towards), &density), light->irradiance);
  if (light->density > R(0.0)) {
    if (is_shared) share *= balance(light->density, share * density);
    reflected = scale3(share, reflected);
  } else if (share > R(1.0)) {
    reflected = scale3(share, reflected);
  }
  return reflected;
}

/// What shadow rays let through: one for each light that is taken and one for those that are drawn from; or one into
/// the open.
FN void LANED(add_lights)(const Scene* scene, Path* path, const Surface* s, const Departure* departure, int id,
                          const Material* m, real3 wo, int next) {
  int is_open = HAS_OPENNESS && (next & STEP_OPENNESS) != 0;
  int count = LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHT_COUNT];
  int taken = LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHTS_TAKEN];
  int rays = count > taken ? taken + 1 : taken;
  if (is_open) rays = 1;
  for (int i = 0; i < rays; ++i) {
    LightSample light;
    real3 reflected;
    if (is_open) {
      light = sky_sample(scene, path, s, wo);
      reflected = light.irradiance;
    } else {
      reflected = light_gain(scene, path, s, m, i, next & STEP_SCATTER, &light);
    }
    if (!(max3(reflected) > R(0.0))) continue;
    Ray shadow = ray_leaving(s, departure, id, light.towards, light.t_max);
    shadow.aim = light.aim;
    if (HAS_COUNT_RAYS) count_event(scene, COUNT_SHADOW);
    if (!LANED(any_hit)(scene, &shadow)) path_add(path, reflected);
  }
}

/// The way on; 0: all light that it could bring is lost.
FN int path_mirror(Path* path, const Surface* s, const Material* m, real3 wo, real3* on) {
  path->throughput = mul3(path->throughput, material_mirror(m));
  path->density = R(0.0);
  // Normalised anew each time: the length does not drift however many mirrors follow.
  *on = normalize3(fma3(R(2.0) * dot3(s->shading, wo), s->shading, negate3(wo)));
  return max3(path->throughput) > R(0.0);
}

/// The way on; 0: the path ends.
FN int path_scatter(const Scene* scene, Path* path, const Surface* s, const Material* m, int is_roulette, real3* on) {
  Random2 numbers = sample_pair(scene, &path->sample, set_at(path->depth, SET_WAY));
  MaterialSample way = material_sample(m, random_between(numbers.x), random_between(numbers.y));
  path->throughput = mul3(path->throughput, way.weight);
  real most = max3(path->throughput);
  if (!(most > R(0.0))) return 0;
  if (is_roulette && path->depth + 1 >= scene->index[HEADER_RR_DEPTH]) {
    real chance = most < R(0.95) ? most : R(0.95);
    if (random_between(roulette_number(&path->sample, path->depth)) >= chance) return 0;
    path->throughput = scale3(R(1.0) / chance, path->throughput);
  }
  path->from = s->position;
  path->density = way.density;
  *on = way.wi;
  return 1;
}

/// An emitter that the camera looks through.
FN int is_hidden(const Scene* scene, const Path* path, const Surface* s) {
  return HAS_EMISSION && path->depth == 0 && hides_emitters(scene) && scene_part(scene, s->part)[PART_RADIANCE] >= 0;
}

/// Takes the path over one surface, found at t and with id scene-wide; 1: to be followed along its new ray.
FN int LANED(surface_step)(const Scene* scene, Path* path, int hit, Surface* s, int id, real t) {
  int next = 0;
  if (TEXTURE_COUNT > 0 && hit) {
    path->travelled += length3(sub3(s->position, path->ray.o));
    s->footprint = pixel_footprint(scene, path->travelled, s, path->ray.d);
  }
  switch (scene->index[HEADER_INTEGRATOR]) {
#define INTEGRATOR(name)                     \
  case INTEGRATOR_##name:                    \
    next = name##_step(scene, path, hit, s); \
    break;
#include "integrators/integrators.def"
#undef INTEGRATOR
    default:
      break;
  }
  if (next == 0) return 0;
  Departure departure = departure_of(s);
  real3 on = path->ray.d;
  real t_max = path->ray.t_max - t;
  if (!is_hidden(scene, path, s)) {
    real3 wo = unit3(negate3(on));
    Material m = material_at(scene, s, wo);
    if ((next & (STEP_LIGHTS | STEP_OPENNESS)) != 0) LANED(add_lights)(scene, path, s, &departure, id, &m, wo, next);
    int is_on = 0;
    if ((next & STEP_MIRROR) != 0) is_on = path_mirror(path, s, &m, wo, &on);
    if ((next & STEP_SCATTER) != 0) is_on = path_scatter(scene, path, s, &m, next & STEP_ROULETTE, &on);
    if (!is_on) return 0;
    if (HAS_COUNT_RAYS) count_event(scene, COUNT_BOUNCE);
    t_max = REAL_MAX;
    ++path->depth;
  }
  path->ray = ray_leaving(s, &departure, id, on, t_max);
  return 1;
}

// SPDX-License-Identifier: MIT
// One surface of each of LANES paths: dispatch over the active integrators, then light from lights and the way on, each
// in one place for all integrators, so that a program holds one traversal for shadows and one for everything else.
// core/find_lanes.h says what rays meet. One width; no guard.
#include "core/counters.h"
#include "lights/light_lanes.h"
#include "materials/material_lanes.h"
#include "core/openness_lanes.h"

enum {
  STEP_LIGHTS = 1,    ///< Add what the lights throw on the surface.
  STEP_MIRROR = 2,    ///< Follow the mirrored ray.
  STEP_SCATTER = 4,   ///< Follow a way that the material draws; drawn lights then share their work with it.
  STEP_ROULETTE = 8,  ///< Perhaps not.
  STEP_OPENNESS = 16  ///< Add white if a way into the open meets nothing.
};

#include "integrators/direct_light_lanes.h"
#include "integrators/all_lanes.h"

/// The ways on, and the lanes of `which` that take them: elsewhere all light that it could bring is lost.
FN maskw LANED(path_mirror)(LANED(Paths) * path, const LANED(Surfaces) * s, const LANED(Material) * m, real3w wo,
                            maskw which, real3w* on) {
  path->throughput = sel3_w(which, mul3_w(path->throughput, LANED(material_mirror)(m)), path->throughput);
  path->density = sel_w(which, splat_w(R(0.0)), path->density);
  // Normalised anew each time: the length does not drift however many mirrors follow.
  *on = normalize3_w(fma3_w(splat_w(R(2.0)) * dot3_w(s->shading, wo), s->shading, negate3_w(wo)));
  return which & lt_w(splat_w(R(0.0)), max3_w(path->throughput));
}

/// The ways on, and the lanes of `which` that take them: the other paths end.
FN maskw LANED(path_scatter)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s,
                             const LANED(Material) * m, maskw which, int is_roulette, real3w* on) {
  LANED(Random2) numbers = LANED(vertex_pair)(scene, &path->sample, path->depth, USE_WAY);
  realw u = LANED(random_between)(numbers.x), v = LANED(random_between)(numbers.y), one = splat_w(R(1.0));
  LANED(MaterialSample) way = LANED(material_sample)(m, u, v);
  real3w throughput = mul3_w(path->throughput, way.weight);
  realw most = max3_w(throughput);
  which = which & lt_w(splat_w(R(0.0)), most);
  maskw is_risked = which & lt_int_w(splat_int_w(scene->index[HEADER_RR_DEPTH] - 2), path->depth);
  if (is_roulette && any_w(is_risked)) {
    realw limit = splat_w(R(0.95)), chance = sel_w(lt_w(most, limit), most, limit);
    realw number = LANED(random_between)(LANED(vertex_number)(scene, &path->sample, path->depth, USE_ROULETTE));
    which = which & ~(is_risked & le_w(chance, number));
    throughput = sel3_w(is_risked, scale3_w(one / chance, throughput), throughput);
  }
  path->throughput = sel3_w(which, throughput, path->throughput);
  path->from = sel3_w(which, s->position, path->from);
  path->density = sel_w(which, way.density, path->density);
  *on = way.wi;
  return which;
}

/// Emitters that the camera looks through.
FN maskw LANED(is_hidden)(const Scene* scene, const LANED(Paths) * path, const LANED(Surfaces) * s) {
  maskw is_glowing = ~lt_int_w(LANED(part_entry)(scene, s, PART_RADIANCE), splat_int_w(0));
  return path->alive & lt_int_w(path->depth, splat_int_w(1)) & is_glowing;
}

/// Whatever an active integrator may ask for: a program holds nothing else.
enum {
  LANED(STEPS) = 0
#define INTEGRATOR(name) | (int)LANED(name##_STEPS)
#include "integrators/integrators.def"
#undef INTEGRATOR
};

/// Takes the paths that are alive over one surface each; those that are alive then are to be followed along their new
/// rays.
FN void LANED(surface_step)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s) {
  int next = 0;
  maskw on = none_w();
  switch (scene->index[HEADER_INTEGRATOR]) {
#define INTEGRATOR(name)                            \
  case INTEGRATOR_##name:                           \
    on = LANED(name##_step)(scene, path, s, &next); \
    break;
#include "integrators/integrators.def"
#undef INTEGRATOR
    default:
      break;
  }
  path->alive = on;
  if (!LANED(STEPS)) return;
  if (next == 0 || !any_w(on)) return;
  real3w d = LANED(real3_at)(path->rays.planes + RAY_PLANE_D), way = d;
  realw t_max = path->rays.planes[RAY_PLANE_T_MAX] - s->t;
  maskw hidden = none_w();
  if (HAS_EMISSION && hides_emitters(scene)) hidden = on & LANED(is_hidden)(scene, path, s);
  on = on & ~hidden;
  if (any_w(on)) {
    real3w wo = unit3_w(negate3_w(d));
    LANED(Material) m = LANED(material_at)(scene, s, wo);
    if ((LANED(STEPS) & (STEP_LIGHTS | STEP_OPENNESS)) && (next & (STEP_LIGHTS | STEP_OPENNESS)) != 0)
      LANED(add_lights)(scene, path, s, &m, wo, on, next);
    if ((LANED(STEPS) & STEP_MIRROR) && (next & STEP_MIRROR) != 0)
      on = LANED(path_mirror)(path, s, &m, wo, on, &way);
    else if ((LANED(STEPS) & STEP_SCATTER) && (next & STEP_SCATTER) != 0)
      on = LANED(path_scatter)(scene, path, s, &m, on, next & STEP_ROULETTE, &way);
    else
      on = none_w();
    if (HAS_COUNT_RAYS) count_events(scene, COUNT_BOUNCE, lanes_among(bits_w(on)));
    way = sel3_w(on, way, d);
    t_max = sel_w(on, splat_w(REAL_MAX), t_max);
    path->depth = sel_int_w(on, path->depth + splat_int_w(1), path->depth);
  }
  path->alive = on | hidden;
  if (any_w(path->alive)) LANED(rays_leaving)(s, path->alive, way, t_max, &path->rays);
}

// SPDX-License-Identifier: MIT
// One surface of each of LANES paths: dispatch over the active integrators, then direct light and scattering. All
// integrators share the code for both, so that a program holds one traversal for shadows and one for all other rays.
// hits/find_lanes.h finds the surfaces. One width; no guard.
#include "scene/counters.h"
#include "lights/light_lanes.h"
#include "materials/material_lanes.h"
#include "integrators/strict_normals_lanes.h"
#include "integrators/openness_lanes.h"
#include "integrators/pass_on_lanes.h"
#include "integrators/steps.h"
#include "integrators/visibility_lanes.h"
#if HAS_MEDIA
#include "media/all_lanes.h"
#endif

#include "integrators/direct_light_lanes.h"
#include "integrators/crossing_lanes.h"
#include "integrators/all_lanes.h"

/// The steps that an active integrator may ask for; the program holds no others.
enum {
  STEPS_w = 0
#define INTEGRATOR(name) | (int)name##_STEPS_w
#include "integrators/integrators.def"
#undef INTEGRATOR
};

#include "integrators/scatter_lanes.h"
#include "integrators/last_rays_lanes.h"
#include "integrators/branches_lanes.h"

/// Which part of a blend the paths meet. Where light goes through surfaces that count for nothing, several of them have
/// one depth: once a path has passed one, depth and the stream's place tell them apart.
FN uintw blend_number_w(const Scene* scene, const Paths_w* path, int next) {
  uintw number = met_number_w(scene, path, USE_BLEND);
#if HAS_MEDIA
  intw drawn = int_of_uint_w(path->draws - splat_uint_w(STREAM_BEGIN));
  maskw is_new = nonzero_w(drawn);
  if ((next & STEP_THROUGH) != 0 && any_w(is_new)) {
    uintw place = path->draws + (splat_uint_w(STREAM_BLENDS) + uint_of_int_w(path->depth) * STREAM_SHADOWS_STEP);
    if (HAS_PRIORITY) place = place + uint_of_int_w(path->within.ignored) * IGNORED_STEP;
    uintw other = stream_numbers_w(&path->sample, none_w(), &place).x;
    number = uint_of_int_w(sel_int_w(is_new, int_of_uint_w(other), int_of_uint_w(number)));
  }
#endif
  (void)next;
  return number;
}

/// As surface_step, without the waiting branches going on.
FN void surface_scatter_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, Branches_w* branches) {
  int next = 0;
  maskw on = none_w(), last = path->alive & at_surfaces_w(s);
  switch (scene->index[HEADER_INTEGRATOR]) {
#define INTEGRATOR(name)                       \
  case INTEGRATOR_##name:                      \
    on = name##_step_w(scene, path, s, &next); \
    break;
#include "integrators/integrators.def"
#undef INTEGRATOR
    default:
      break;
  }
  path->alive = on;
  if (!STEPS_w) return;
  // Lanes at their last depth, which pass surfaces that are ignored.
  last = HAS_PRIORITY ? last & ~on : none_w();
  if (next == 0 || !any_w(on | last)) return;
  real3w d = real3_at_w(path->rays.planes + RAY_PLANE_D), way = d;
  realw t_max = path->rays.planes[RAY_PLANE_T_MAX] - s->t;
  maskw at_surface = on & at_surfaces_w(s);
  // For openness alone materials and lights do not matter.
  int is_lit = (next & ~STEP_OPENNESS) != 0;
  maskw passed = none_w();
  if (is_lit) passed = passes_on_w(scene, path, s, at_surface);
  on = on & ~passed;
  real3w wo = unit3_w(negate3_w(d));
  realw number = splat_w(R(0.0));
  if (HAS_BLEND) number = random_between_w(blend_number_w(scene, path, next));
  MaterialRows_w at = rows_at_w(scene, s, on | last, wo, number);
  if (HAS_MASK && is_lit) {
    maskw open = none_w();
#if HAS_MEDIA
    if ((next & STEP_THROUGH) != 0)
      open = passes_openly_w(path, &at, at_surface & on);
    else
#endif
      open = passes_masks_w(scene, path, &at, on);
    if (HAS_PRIORITY) pass_holes_w(scene, path, s, &at, open, d);
    t_max = unclipped_w(open, t_max);
    passed = passed | open;
    on = on & ~open;
  }
  maskw reflects = none_w();
#if HAS_PANE
  if ((next & STEP_THROUGH) != 0) {
    maskw clear = passes_panes_w(scene, path, s, &at, at_surface & on, wo, &reflects);
    if (HAS_PRIORITY) pass_ranked_w(scene, path, s, clear, d);
    t_max = unclipped_w(clear, t_max);
    passed = passed | clear;
    on = on & ~clear;
  }
#endif
#if HAS_MEDIA
  if ((next & STEP_THROUGH) != 0) {
    maskw below = lt_int_w(path->depth, splat_int_w(scene->index[HEADER_MAX_DEPTH] - 1));
    if (HAS_PRIORITY) last = last | (at_surface & on & ~below);
    on = on & below;
  }
#endif
  if (HAS_PRIORITY && any_w(last)) passed = passed | pass_last_unreal_w(scene, path, s, &at, last);
  if (any_w(on)) {
    Bsdf_w b = bsdf_at_w(scene, s, &at, wo);
    if (HAS_PANE) b.reflects = reflects;
    Crossing_w crossing;
    if (HAS_PRIORITY) {
      crossing = crossing_of_w(scene, &path->within, s, &at, on & at_surface, &b);
      maskw unreal = pass_unreal_w(scene, path, &crossing);
      passed = passed | unreal;
      on = on & ~unreal;
    }
    if (HAS_STRICT_NORMALS && is_lit) on = on_one_side_w(scene, s, on, wo);
    maskw lit = on;
#if HAS_MEDIA
    lit = lit & ~are_unlit_w(scene, path, s);
#endif
    if ((STEPS_w & (STEP_LIGHTS | STEP_OPENNESS)) && (next & (STEP_LIGHTS | STEP_OPENNESS)) != 0 &&
        ((HAS_UNLIT_MEDIA == 0) | any_w(lit)))
      add_lights_w(scene, path, s, &b, wo, lit, next);
    if (HAS_BRANCHES && (next & STEP_DELTA) != 0)
      on = path_branch_w(scene, path, s, &b, on, &crossing, branches, &way);
    else if ((STEPS_w & (STEP_DELTA | STEP_SCATTER)) && (next & (STEP_DELTA | STEP_SCATTER)) != 0)
      on = path_scatter_w(scene, path, s, &b, on, next, &way);
    else
      on = none_w();
    if (HAS_COUNT_RAYS) count_events(scene, COUNT_BOUNCE, lanes_among(bits_w(on)));
    if (HAS_PRIORITY) cross_interface_w(scene, &crossing, on & goes_through_w(&crossing, s, way), &path->within);
    way = sel3_w(on, way, d);
    t_max = unclipped_w(on, t_max);
    path->depth = sel_int_w(on, path->depth + splat_int_w(1), path->depth);
  }
  path->alive = on | passed;
#if HAS_MEDIA
  media_enter_w(scene, path, s, on, way);
#endif
  if (!any_w(path->alive)) return;
  rays_passing_w(s, path->alive, passed, way, t_max, &path->rays);
  if ((STEPS_w & STEP_SCATTER) != 0) path->alive = path->alive & finds_more_w(scene, path);
}

/// Processes one surface of each path that is alive. The paths that are alive afterwards go on along their new rays.
FN void surface_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, Branches_w* branches) {
  maskw before = path->alive;
  surface_scatter_w(scene, path, s, branches);
  if (HAS_BRANCHES) branches_resume_w(scene, path, before, branches);
}

// SPDX-License-Identifier: MIT
// The albedo where a pixel's first sample meets a surface, beside what film/first_sample.h stores. Of a blend it is
// that of the material that the sample draws. One width; no guard.
#include "materials/albedo_lanes.h"

FN void store_albedo_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, const FirstSample* first) {
  if (first->lane < 0) return;
  real3w wo = unit3_w(negate3_w(real3_at_w(path->rays.planes + RAY_PLANE_D)));
  realw number = splat_w(R(0.0));
  if (HAS_BLEND) number = random_between_w(vertex_number_w(scene, &path->sample, path->depth, USE_BLEND));
  MaterialRows_w at = rows_at_w(scene, s, path->alive & s->hit, wo, number);
  real3w color = albedo_at_w(scene, s, path->alive & s->hit, &at);
  int lane = first->lane;
  store3(vec3(get_w(&color.x, lane), get_w(&color.y, lane), get_w(&color.z, lane)), first->reals + AOV_ALBEDO);
}

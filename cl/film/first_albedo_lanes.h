// SPDX-License-Identifier: MIT
// The albedo where pixels' first samples meet a surface, beside what film/first_sample.h stores. Of a blend it is
// that of the material that the sample draws. One width; no guard.
#include "materials/albedo_lanes.h"

FN void store_albedo_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, const FirstSamples* first) {
  if (first->lanes == 0u) return;
  real3w wo = unit3_w(negate3_w(real3_at_w(path->rays.planes + RAY_PLANE_D)));
  realw number = splat_w(R(0.0));
  if (HAS_BLEND) number = random_between_w(vertex_number_w(scene, &path->sample, path->depth, USE_BLEND));
  MaterialRows_w at = rows_at_w(scene, s, path->alive & s->hit, wo, number);
  real3w color = albedo_at_w(scene, s, path->alive & s->hit, &at);
  for (uint lanes = first->lanes; lanes != 0u; lanes &= lanes - 1u) {
    int lane = first_bit(lanes), pixel = get_int_w((PRIVATE const intw*)&path->sample.pixel, lane);
    store3(get3_w(&color, lane), first_reals(first, pixel) + AOV_ALBEDO);
  }
}

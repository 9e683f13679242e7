// SPDX-License-Identifier: MIT
// The way on from a surface, drawn by its material, and Russian roulette. A ray that has gone into denser matter
// carries less radiance, which it gets back when it comes out: roulette looks at what it would carry outside,
// throughput times eta^2. One width; no guard.

/// Through glass of equal indices rays go on as they came, to the bit: along d.
FN void LANED(keep_straight)(LANED(BsdfSample) * way, real3w d) {
  if (!HAS_TRANSMISSION) return;
  maskw is_delta = LANED(is_lobe)(way, LOBE_DELTA) & LANED(is_lobe)(way, LOBE_TRANSMIT);
  way->wi = sel3_w(is_delta & eq_w(way->eta, splat_w(R(1.0))), d, way->wi);
}

/// The ways on, and the lanes of `which` that take them: the other paths end. Along one of all lobes, or of the delta
/// lobes alone. on: the direction that the rays came along; there it gives back where they go.
FN maskw LANED(path_scatter)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s, const LANED(Bsdf) * b,
                             maskw which, int next, real3w* on) {
  int lobes = (LANED(STEPS) & STEP_SCATTER) && (next & STEP_SCATTER) != 0 ? LOBES_ALL : LOBES_DELTA;
  LANED(Random2) numbers = LANED(vertex_pair)(scene, &path->sample, path->depth, USE_WAY);
  realw u = LANED(random_between)(numbers.x), v = LANED(random_between)(numbers.y), one = splat_w(R(1.0));
  realw number = LANED(random_between)(LANED(vertex_number)(scene, &path->sample, path->depth, USE_LOBE));
  LANED(BsdfSample) way = LANED(bsdf_sample)(b, lobes, number, u, v);
  LANED(keep_straight)(&way, *on);
  real3w throughput = mul3_w(path->throughput, way.weight);
  realw most = max3_w(throughput), eta2 = path->eta2;
  which = which & lt_w(splat_w(R(0.0)), most);
  if (HAS_TRANSMISSION) {
    eta2 = eta2 * (way.eta * way.eta);
    most = most * eta2;
  }
  maskw is_risked = which & lt_int_w(splat_int_w(scene->index[HEADER_RR_DEPTH] - 2), path->depth);
  if ((LANED(STEPS) & STEP_ROULETTE) && (next & STEP_ROULETTE) != 0 && any_w(is_risked)) {
    realw limit = splat_w(R(0.95)), chance = sel_w(lt_w(most, limit), most, limit);
    realw drawn = LANED(random_between)(LANED(vertex_number)(scene, &path->sample, path->depth, USE_ROULETTE));
    which = which & ~(is_risked & le_w(chance, drawn));
    throughput = sel3_w(is_risked, scale3_w(one / chance, throughput), throughput);
  }
  path->throughput = sel3_w(which, throughput, path->throughput);
  path->eta2 = sel_w(which, eta2, path->eta2);
  path->from = sel3_w(which, s->position, path->from);
  realw density = way.density;
  if (HAS_DELTA_LOBES) density = sel_w(LANED(is_lobe)(&way, LOBE_DELTA), splat_w(R(0.0)), density);
  path->density = sel_w(which, density, path->density);
  *on = way.wi;
  return which;
}

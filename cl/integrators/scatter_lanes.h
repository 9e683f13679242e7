// SPDX-License-Identifier: MIT
// The next direction of a path, drawn by the material, and Russian roulette. The throughput of a path changes where it
// enters a denser medium, and changes back where it leaves it. So roulette uses the throughput that the path would have
// outside, throughput times eta^2. One width; no guard.

/// Through glass of equal indices rays go on as they came, to the bit: along d.
FN void keep_straight_w(BsdfSample_w* way, real3w d) {
  if (!HAS_TRANSMISSION) return;
  maskw is_delta = is_lobe_w(way, LOBE_DELTA) & is_lobe_w(way, LOBE_TRANSMIT);
  way->wi = sel3_w(is_delta & eq_w(way->eta, splat_w(R(1.0))), d, way->wi);
}

/// Draws the next directions, from all lobes or from the delta lobes alone, and returns the lanes of `which` that go
/// on; the other paths end. on: on entry the direction of the incoming rays, on return that of the new rays.
FN maskw path_scatter_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, const Bsdf_w* b, maskw which, int next,
                        real3w* on) {
  int lobes = (STEPS_w & STEP_SCATTER) && (next & STEP_SCATTER) != 0 ? LOBES_ALL : LOBES_DELTA;
  Random2_w numbers = vertex_pair_w(scene, &path->sample, path->depth, USE_WAY);
  realw u = random_between_w(numbers.x), v = random_between_w(numbers.y), one = splat_w(R(1.0));
  realw number = random_between_w(vertex_number_w(scene, &path->sample, path->depth, USE_LOBE));
  BsdfSample_w way = bsdf_sample_w(b, lobes, number, u, v);
#if HAS_MEDIA
  vertex_turn_w(scene, path, s, number, u, v, &way);
#endif
  keep_straight_w(&way, *on);
#if HAS_LIGHT_PATHS
  if ((STEPS_w & STEP_ADJOINT) && (next & STEP_ADJOINT) != 0) make_adjoint_w(scene, path, b, s, which, &way);
#endif
  real3w throughput = mul3_w(path->throughput, way.weight);
  realw most = max3_w(throughput), eta2 = path->eta2;
  which = which & lt_w(splat_w(R(0.0)), most);
  if (HAS_STRICT_NORMALS) which = on_one_side_w(scene, s, which, way.wi);
  if (HAS_TRANSMISSION) {
    eta2 = eta2 * (way.eta * way.eta);
    most = most * eta2;
  }
  maskw is_risked = which & lt_int_w(splat_int_w(scene->index[HEADER_RR_DEPTH] - 2), path->depth);
  if ((STEPS_w & STEP_ROULETTE) && (next & STEP_ROULETTE) != 0 && any_w(is_risked)) {
    realw limit = splat_w(R(0.95)), chance = sel_w(lt_w(most, limit), most, limit);
    realw drawn = random_between_w(vertex_number_w(scene, &path->sample, path->depth, USE_ROULETTE));
    which = which & ~(is_risked & le_w(chance, drawn));
    throughput = sel3_w(is_risked, scale3_w(one / chance, throughput), throughput);
  }
  path->throughput = sel3_w(which, throughput, path->throughput);
  path->eta2 = sel_w(which, eta2, path->eta2);
  path->from = sel3_w(which, s->position, path->from);
  realw density = way.density;
  if (HAS_DELTA_LOBES) density = sel_w(is_lobe_w(&way, LOBE_DELTA), splat_w(R(0.0)), density);
  path->density = sel_w(which, density, path->density);
  *on = way.wi;
  return which;
}

// SPDX-License-Identifier: MIT
// Rays that split in two, as a walk through their tree without recursion: of what is reflected and what is transmitted
// one is followed, the other waits. One width; no guard.
//
// The weaker one goes first. It carries half of the light at most, and what carries less than BRANCH_LEAST of the
// camera ray's is not followed beside a stronger one: so never more than 20 rays wait, whatever the scene, and the tree
// has an end (R. Hall, D. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3(8), 1983). Branches that
// end so are counted (COUNT_BRANCHES).

#define BRANCH_LEAST R(0x1p-20)
enum { LANED(BRANCHES_MOST) = HAS_BRANCHES ? 21 : 1 };
enum { LANED(BRANCH_O) = 0, LANED(BRANCH_D) = 3, LANED(BRANCH_SHARE) = 6, LANED(BRANCH_ETA2) = 9 };
enum { LANED(BRANCH_TRAVELLED) = 10, LANED(BRANCH_REALS) = 11 };
enum { LANED(BRANCH_LEFT), LANED(BRANCH_INSTANCE), LANED(BRANCH_OUTWARD), LANED(BRANCH_DEPTH), LANED(BRANCH_INTS) };

/// What waits of each lane, the latest last.
typedef struct {
  intw count;
  realw reals[LANED(BRANCHES_MOST)][LANED(BRANCH_REALS)];
  intw ints[LANED(BRANCHES_MOST)][LANED(BRANCH_INTS)];
  LANED(Interfaces) within[LANED(BRANCHES_MOST)];  ///< Kept only where shapes have priorities.
} LANED(Branches);

FN void LANED(put_branch3)(LANED(Branches) * branches, int at, int plane, int lane, const real3w* v) {
  put_w(&branches->reals[at][plane], lane, get_w(&v->x, lane));
  put_w(&branches->reals[at][plane + 1], lane, get_w(&v->y, lane));
  put_w(&branches->reals[at][plane + 2], lane, get_w(&v->z, lane));
}

FN void LANED(get_branch3)(const LANED(Branches) * branches, int at, int plane, int lane, real3w* v) {
  put_w(&v->x, lane, get_w(&branches->reals[at][plane], lane));
  put_w(&v->y, lane, get_w(&branches->reals[at][plane + 1], lane));
  put_w(&v->z, lane, get_w(&branches->reals[at][plane + 2], lane));
}

/// The rays along `way` wait in the lanes of `which`.
FN void LANED(branch_off)(const LANED(Paths) * path, const LANED(Surfaces) * s, maskw which, real3w way, real3w share,
                          realw eta2, const LANED(Interfaces) * within, LANED(Branches) * branches) {
  LANED(Rays) rays;
  LANED(rays_leaving)(s, which, way, splat_w(REAL_MAX), &rays);
  real3w o = LANED(real3_at)(rays.planes + RAY_PLANE_O), d = LANED(real3_at)(rays.planes + RAY_PLANE_D);
  for (uint lanes = bits_w(which); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes), at = get_int_w(&branches->count, i);
    LANED(put_branch3)(branches, at, LANED(BRANCH_O), i, &o);
    LANED(put_branch3)(branches, at, LANED(BRANCH_D), i, &d);
    LANED(put_branch3)(branches, at, LANED(BRANCH_SHARE), i, &share);
    put_w(&branches->reals[at][LANED(BRANCH_ETA2)], i, get_w(&eta2, i));
    put_w(&branches->reals[at][LANED(BRANCH_TRAVELLED)], i, get_w(&path->travelled, i));
    put_int_w(&branches->ints[at][LANED(BRANCH_LEFT)], i, get_int_w(&rays.left, i));
    put_int_w(&branches->ints[at][LANED(BRANCH_INSTANCE)], i, get_int_w(&rays.left_instance, i));
    put_int_w(&branches->ints[at][LANED(BRANCH_OUTWARD)], i, get_int_w(&rays.is_outward, i));
    put_int_w(&branches->ints[at][LANED(BRANCH_DEPTH)], i, get_int_w(&path->depth, i) + 1);
    if (HAS_PRIORITY) LANED(copy_interfaces)(within, i, &branches->within[at]);
    put_int_w(&branches->count, i, at + 1);
  }
}

/// As path_scatter, along both ways: one of them at once.
FN maskw LANED(path_branch)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s, const LANED(Bsdf) * b,
                            maskw which, const LANED(Crossing) * crossing, LANED(Branches) * branches, real3w* on) {
  realw zero = splat_w(R(0.0)), least = splat_w(BRANCH_LEAST);
  LANED(BsdfSample) back = LANED(bsdf_sample)(b, LOBE_DELTA | LOBE_REFLECT, zero, zero, zero);
  LANED(BsdfSample) through = LANED(bsdf_sample)(b, LOBE_DELTA | LOBE_TRANSMIT, zero, zero, zero);
  LANED(keep_straight)(&through, *on);
  real3w back_share = mul3_w(path->throughput, back.weight), through_share = mul3_w(path->throughput, through.weight);
  realw eta2 = path->eta2 * (through.eta * through.eta);
  realw back_light = max3_w(back_share) * path->eta2, through_light = max3_w(through_share) * eta2;
  maskw goes_back = which & lt_w(zero, back_light), goes_through = which & lt_w(zero, through_light);
  maskw is_back_less = lt_w(back_light, through_light), splits = goes_back & goes_through;
  maskw ends = splits & lt_w(sel_w(is_back_less, back_light, through_light), least);
  if (any_w(ends)) count_events(scene, COUNT_BRANCHES, lanes_among(bits_w(ends)));
  splits = splits & ~ends;
  goes_back = goes_back & ~(ends & is_back_less);
  goes_through = goes_through & ~(ends & ~is_back_less);
  maskw is_back = goes_back & (is_back_less | ~goes_through);
  if (any_w(splits)) {
    real3w way = sel3_w(is_back, through.wi, back.wi), share = sel3_w(is_back, through_share, back_share);
    LANED(Interfaces) within = path->within;
    if (HAS_PRIORITY) LANED(cross_interface)(scene, crossing, splits & LANED(goes_through)(crossing, s, way), &within);
    LANED(branch_off)(path, s, splits, way, share, sel_w(is_back, eta2, path->eta2), &within, branches);
  }
  which = goes_back | goes_through;
  path->throughput = sel3_w(which, sel3_w(is_back, back_share, through_share), path->throughput);
  path->eta2 = sel_w(which & ~is_back, eta2, path->eta2);
  path->density = sel_w(which, zero, path->density);
  *on = sel3_w(is_back, back.wi, through.wi);
  return which;
}

/// Paths of `which` that have ended go on along what waits of them.
FN void LANED(branches_resume)(const Scene* scene, LANED(Paths) * path, maskw which, LANED(Branches) * branches) {
  which = which & ~path->alive & lt_int_w(splat_int_w(0), branches->count);
  if (!any_w(which)) return;
  if (HAS_COUNT_RAYS) count_events(scene, COUNT_BOUNCE, lanes_among(bits_w(which)));
  LANED(Rays) rays;
  real3w o = path->throughput, d = o, share = o;
  rays.left = rays.left_instance = rays.aim = splat_int_w(-1);
  rays.is_outward = splat_int_w(0);
  for (uint lanes = bits_w(which); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes), at = get_int_w(&branches->count, i) - 1;
    LANED(get_branch3)(branches, at, LANED(BRANCH_O), i, &o);
    LANED(get_branch3)(branches, at, LANED(BRANCH_D), i, &d);
    LANED(get_branch3)(branches, at, LANED(BRANCH_SHARE), i, &share);
    put_w(&path->eta2, i, get_w(&branches->reals[at][LANED(BRANCH_ETA2)], i));
    put_w(&path->travelled, i, get_w(&branches->reals[at][LANED(BRANCH_TRAVELLED)], i));
    put_int_w(&rays.left, i, get_int_w(&branches->ints[at][LANED(BRANCH_LEFT)], i));
    put_int_w(&rays.left_instance, i, get_int_w(&branches->ints[at][LANED(BRANCH_INSTANCE)], i));
    put_int_w(&rays.is_outward, i, get_int_w(&branches->ints[at][LANED(BRANCH_OUTWARD)], i));
    put_int_w(&path->depth, i, get_int_w(&branches->ints[at][LANED(BRANCH_DEPTH)], i));
    if (HAS_PRIORITY) LANED(copy_interfaces)(&branches->within[at], i, &path->within);
    put_int_w(&branches->count, i, at);
  }
  // The planes that were kept are prepared already, which preparing leaves as they are.
  intw left = rays.left, left_instance = rays.left_instance, is_outward = rays.is_outward;
  LANED(rays_make)(o, d, splat_w(R(0.0)), splat_w(REAL_MAX), which, &rays);
  rays.left = left;
  rays.left_instance = left_instance;
  rays.is_outward = is_outward;
  rays.aim = splat_int_w(-1);
  path->throughput = sel3_w(which, share, path->throughput);
  path->alive = path->alive | which;
  LANED(paths_follow)(path, which, &rays);
}

// SPDX-License-Identifier: MIT
// Rays that split in two. Their tree is traversed without recursion: of the reflected and the transmitted ray one is
// followed and the other waits. One width; no guard.
//
// The weaker one goes first. It carries at most half of the light. A ray that carries less than BRANCH_LEAST of the
// camera ray's light is dropped where there is a stronger one beside it. So at most 20 rays wait in any scene, and the
// tree is finite (R. Hall, D. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3(8), 1983). Dropped
// branches are counted (COUNT_BRANCHES).
//
// Finite may still be millions of rays: between mirrors that lose nothing, hardly any ray becomes weak. After
// WHITTED_MOST_RAYS of one sample, rays no longer split: the weaker one is dropped (COUNT_LOST_BRANCHES), and those
// that wait, which are the brightest, are still followed.

#define BRANCH_LEAST R(0x1p-20)
enum { BRANCHES_MOST_w = HAS_BRANCHES ? 21 : 1 };
enum { BRANCH_O_w = 0, BRANCH_D_w = 3, BRANCH_SHARE_w = 6, BRANCH_ETA2_w = 9 };
enum { BRANCH_TRAVELLED_w = 10, BRANCH_REALS_w = 11 };
enum { BRANCH_LEFT_w, BRANCH_INSTANCE_w, BRANCH_OUTWARD_w, BRANCH_DEPTH_w, BRANCH_INTS_w };

/// The waiting rays of each lane, the latest last.
typedef struct {
  intw count;
  intw rays;  ///< Mirrors and surfaces of glass that the sample has been at.
  realw reals[BRANCHES_MOST_w][BRANCH_REALS_w];
  intw ints[BRANCHES_MOST_w][BRANCH_INTS_w];
  Interfaces_w within[BRANCHES_MOST_w];  ///< Kept only where shapes have priorities.
} Branches_w;

FN void put_branch3_w(Branches_w* branches, int at, int plane, int lane, const real3w* v) {
  put_w(&branches->reals[at][plane], lane, get_w(&v->x, lane));
  put_w(&branches->reals[at][plane + 1], lane, get_w(&v->y, lane));
  put_w(&branches->reals[at][plane + 2], lane, get_w(&v->z, lane));
}

FN void get_branch3_w(const Branches_w* branches, int at, int plane, int lane, real3w* v) {
  put_w(&v->x, lane, get_w(&branches->reals[at][plane], lane));
  put_w(&v->y, lane, get_w(&branches->reals[at][plane + 1], lane));
  put_w(&v->z, lane, get_w(&branches->reals[at][plane + 2], lane));
}

FN void branches_none_w(Branches_w* branches) { branches->count = branches->rays = splat_int_w(0); }

FN maskw are_too_many_w(const Branches_w* branches) { return lt_int_w(splat_int_w(WHITTED_MOST_RAYS), branches->rays); }

/// Adds the rays along `way` to those that wait, in the lanes of `which`.
FN void branch_off_w(const Paths_w* path, const Surfaces_w* s, maskw which, real3w way, real3w share, realw eta2,
                     const Interfaces_w* within, Branches_w* branches) {
  Rays_w rays;
  rays_leaving_w(s, which, way, splat_w(REAL_MAX), &rays);
  real3w o = real3_at_w(rays.planes + RAY_PLANE_O), d = real3_at_w(rays.planes + RAY_PLANE_D);
  for (uint lanes = bits_w(which); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes), at = get_int_w(&branches->count, i);
    put_branch3_w(branches, at, BRANCH_O_w, i, &o);
    put_branch3_w(branches, at, BRANCH_D_w, i, &d);
    put_branch3_w(branches, at, BRANCH_SHARE_w, i, &share);
    put_w(&branches->reals[at][BRANCH_ETA2_w], i, get_w(&eta2, i));
    put_w(&branches->reals[at][BRANCH_TRAVELLED_w], i, get_w(&path->travelled, i));
    put_int_w(&branches->ints[at][BRANCH_LEFT_w], i, get_int_w(&rays.departed, i));
    put_int_w(&branches->ints[at][BRANCH_INSTANCE_w], i, get_int_w(&rays.departed_instance, i));
    put_int_w(&branches->ints[at][BRANCH_OUTWARD_w], i, get_int_w(&rays.is_outward, i));
    put_int_w(&branches->ints[at][BRANCH_DEPTH_w], i, get_int_w(&path->depth, i) + 1);
    if (HAS_PRIORITY) copy_interfaces_w(within, i, &branches->within[at]);
    put_int_w(&branches->count, i, at + 1);
  }
}

/// As path_scatter, along both directions: one is followed at once.
FN maskw path_branch_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, const Bsdf_w* b, maskw which,
                       const Crossing_w* crossing, Branches_w* branches, real3w* on) {
  realw zero = splat_w(R(0.0)), least = splat_w(BRANCH_LEAST);
  BsdfSample_w back = bsdf_sample_w(b, LOBE_DELTA | LOBE_REFLECT, zero, zero, zero);
  BsdfSample_w through = bsdf_sample_w(b, LOBE_DELTA | LOBE_TRANSMIT, zero, zero, zero);
  keep_straight_w(&through, *on);
  real3w back_share = mul3_w(path->throughput, back.weight), through_share = mul3_w(path->throughput, through.weight);
  realw eta2 = path->eta2 * (through.eta * through.eta);
  realw back_light = max3_w(back_share) * path->eta2, through_light = max3_w(through_share) * eta2;
  maskw goes_back = which & lt_w(zero, back_light), goes_through = which & lt_w(zero, through_light);
  if (HAS_STRICT_NORMALS) {
    goes_back = on_one_side_w(scene, s, goes_back, back.wi);
    goes_through = on_one_side_w(scene, s, goes_through, through.wi);
  }
  maskw is_back_less = lt_w(back_light, through_light), splits = goes_back & goes_through;
  maskw is_weak = splits & lt_w(sel_w(is_back_less, back_light, through_light), least);
  if (any_w(is_weak)) count_events(scene, COUNT_BRANCHES, lanes_among(bits_w(is_weak)));
  branches->rays = sel_int_w(goes_back | goes_through, branches->rays + splat_int_w(1), branches->rays);
  maskw is_lost = splits & ~is_weak & are_too_many_w(branches);
  if (any_w(is_lost)) count_events(scene, COUNT_LOST_BRANCHES, lanes_among(bits_w(is_lost)));
  maskw ends = is_weak | is_lost;
  splits = splits & ~ends;
  goes_back = goes_back & ~(ends & is_back_less);
  goes_through = goes_through & ~(ends & ~is_back_less);
  maskw is_back = goes_back & (is_back_less | ~goes_through);
  if (any_w(splits)) {
    real3w way = sel3_w(is_back, through.wi, back.wi), share = sel3_w(is_back, through_share, back_share);
    Interfaces_w within = path->within;
    if (HAS_PRIORITY) cross_interface_w(scene, crossing, splits & goes_through_w(crossing, s, way), &within);
    branch_off_w(path, s, splits, way, share, sel_w(is_back, eta2, path->eta2), &within, branches);
  }
  which = goes_back | goes_through;
  path->throughput = sel3_w(which, sel3_w(is_back, back_share, through_share), path->throughput);
  path->eta2 = sel_w(which & ~is_back, eta2, path->eta2);
  path->density = sel_w(which, zero, path->density);
  *on = sel3_w(is_back, back.wi, through.wi);
  return which;
}

/// Paths of `which` that have ended go on along their waiting rays.
FN void branches_resume_w(const Scene* scene, Paths_w* path, maskw which, Branches_w* branches) {
  which = which & ~path->alive;
  maskw waits = lt_int_w(splat_int_w(0), branches->count);
  branches->rays = sel_int_w(which & ~waits, splat_int_w(0), branches->rays);
  which = which & waits;
  if (!any_w(which)) return;
  if (HAS_COUNT_RAYS) count_events(scene, COUNT_BOUNCE, lanes_among(bits_w(which)));
  Rays_w rays;
  real3w o = path->throughput, d = o, share = o;
  rays.departed = rays.departed_instance = rays.aim = splat_int_w(-1);
  rays.is_outward = splat_int_w(0);
  for (uint lanes = bits_w(which); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes), at = get_int_w(&branches->count, i) - 1;
    get_branch3_w(branches, at, BRANCH_O_w, i, &o);
    get_branch3_w(branches, at, BRANCH_D_w, i, &d);
    get_branch3_w(branches, at, BRANCH_SHARE_w, i, &share);
    put_w(&path->eta2, i, get_w(&branches->reals[at][BRANCH_ETA2_w], i));
    put_w(&path->travelled, i, get_w(&branches->reals[at][BRANCH_TRAVELLED_w], i));
    put_int_w(&rays.departed, i, get_int_w(&branches->ints[at][BRANCH_LEFT_w], i));
    put_int_w(&rays.departed_instance, i, get_int_w(&branches->ints[at][BRANCH_INSTANCE_w], i));
    put_int_w(&rays.is_outward, i, get_int_w(&branches->ints[at][BRANCH_OUTWARD_w], i));
    put_int_w(&path->depth, i, get_int_w(&branches->ints[at][BRANCH_DEPTH_w], i));
    if (HAS_PRIORITY) copy_interfaces_w(&branches->within[at], i, &path->within);
    put_int_w(&branches->count, i, at);
  }
  // The stored planes are prepared already; preparing them again does not change them.
  intw departed = rays.departed, departed_instance = rays.departed_instance, is_outward = rays.is_outward;
  rays_make_w(o, d, splat_w(R(0.0)), splat_w(REAL_MAX), which, &rays);
  rays.departed = departed;
  rays.departed_instance = departed_instance;
  rays.is_outward = is_outward;
  rays.aim = splat_int_w(-1);
  path->throughput = sel3_w(which, share, path->throughput);
  path->alive = path->alive | which;
  paths_follow_w(path, which, &rays);
}

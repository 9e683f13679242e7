// SPDX-License-Identifier: MIT
// Which row of the material table describes each lane's surface: what is seen from behind may be another row, and of a
// blend one of two rows is drawn, in proportion to their shares of the light; a relief bends the normal of the row
// inside it; a coat lies on it. So shading knows single materials alone (docs/decisions/0027-nested-materials.md). One
// width; no guard.
#include "materials/relief_lanes.h"
#include "materials/coat_lanes.h"

typedef struct {
  intw rows;        ///< Offsets into the index.
  real3w normal;    ///< The shading normal; of what is seen from behind as from the front, that on the side of `out`.
  realw opacity;    ///< The share of rays that meet the surface; kept only with MASK.
  Relief_w relief;  ///< Kept only with RELIEF; its frame's z is the normal.
  Coat_w coat;      ///< Kept only with COAT.
} MaterialRows_w;

/// Offset of each lane's row in the index.
FN intw material_rows_w(const Scene* scene, intw materials) {
  return materials * (int)MATERIAL_INTS + splat_int_w(scene->index[HEADER_MATERIALS]);
}

/// Lanes whose rows have indices of that kind.
FN maskw has_indices_w(const Scene* scene, intw rows, int kind) {
  return ~nonzero_w(gather_int_w(scene->index + MATERIAL_INDICES, rows) - splat_int_w(kind));
}

FN void turn_rows_w(const Scene* scene, real3w out, MaterialRows_w* m) {
  intw back = gather_int_w(scene->index + MATERIAL_BACK, m->rows);
  maskw is_behind = ~lt_int_w(back, splat_int_w(0)) & lt_w(dot3_w(out, m->normal), splat_w(R(0.0)));
  m->normal = sel3_w(is_behind, negate3_w(m->normal), m->normal);
  if (HAS_RELIEF) {
    m->relief.base = sel3_w(is_behind, negate3_w(m->relief.base), m->relief.base);
    m->relief.frame.z = m->normal;
  }
  m->rows = sel_int_w(is_behind, material_rows_w(scene, back), m->rows);
}

/// Goes on to the row inside, of the lanes of `which`: of a blend one of two, of a relief the one that it bends, of a
/// coat the one below.
/// Returns the lanes that had one. number: within (0, 1); what a draw leaves of it is spread evenly again, for blends
/// within blends.
FN maskw enter_rows_w(const Scene* scene, const Surfaces_w* s, maskw which, real3w out, MaterialRows_w* m,
                      PRIVATE realw* number) {
  realw one = splat_w(R(1.0));
  intw first = gather_int_w(scene->index + MATERIAL_FIRST, m->rows), drawn = first;
  which = which & ~lt_int_w(first, splat_int_w(0));
  if (!any_w(which)) return which;
  intw second = gather_int_w(scene->index + MATERIAL_SECOND, m->rows);
  maskw is_blend = which & ~lt_int_w(second, splat_int_w(0)), is_relief = which & ~is_blend, is_coat = none_w();
  if (HAS_COAT) {
    is_coat = which & ~nonzero_w(second + splat_int_w(2));
    is_relief = is_relief & ~is_coat;
    if (any_w(is_coat)) coat_load_w(scene, s, is_coat, m->rows, &m->coat);
  }
  if (HAS_BLEND && any_w(is_blend)) {
    realw weight = luminance_w(parameter_at_w(scene, s, is_blend, m->rows, 0));
    maskw is_second = is_blend & lt_w(*number, weight);
    realw past = sel_w(is_second, *number, *number - weight), share = sel_w(is_second, weight, one - weight);
    // The quotient may round up to 1; the last number below it (tests/physics/test_blends.cpp).
    realw left = min_w(past / share, splat_w(R(1.0) - real_roundoff()));
    *number = sel_w(is_blend, left, *number);
    drawn = sel_int_w(is_second, second, first);
  }
  if (HAS_RELIEF && any_w(is_relief)) {
    bend_w(scene, s, is_relief, m->rows, out, &m->relief);
    m->normal = m->relief.frame.z;
  }
  m->rows = sel_int_w(which, material_rows_w(scene, sel_int_w(which, drawn, splat_int_w(0))), m->rows);
  return which;
}

/// The rows of the lanes of `which`. out: where the light goes to, unit, in the world. number: within (0, 1), read only
/// with BLEND.
FN MaterialRows_w rows_at_w(const Scene* scene, const Surfaces_w* s, maskw which, real3w out, realw number) {
  MaterialRows_w m;
  m.rows = material_rows_w(scene, part_entry_w(scene, s, PART_MATERIAL));
  m.normal = s->shading;
  m.opacity = splat_w(R(1.0));
  if (HAS_RELIEF) {
    m.relief.frame = frame_along_w(s->shading, s->along);
    m.relief.base = s->shading;
    m.relief.which = none_w();
    m.relief.is_seen = ~none_w();
    m.relief.fading = splat_w(R(0.0));
  }
  if (HAS_COAT) coat_none_w(&m.coat);
  maskw at = which;
  do {
    if (HAS_TWOSIDED) turn_rows_w(scene, out, &m);
    if (HAS_MASK) {
      int opacity = (int)MATERIAL_OPACITY - (int)MATERIAL_SLOTS;
      realw share = luminance_w(parameter_at_w(scene, s, at, m.rows, opacity));
      m.opacity = sel_w(at, m.opacity * share, m.opacity);
    }
    at = HAS_BLEND || HAS_RELIEF || HAS_COAT ? enter_rows_w(scene, s, at, out, &m, &number) : none_w();
  } while ((HAS_BLEND || HAS_RELIEF || HAS_COAT) && any_w(at));
  return m;
}

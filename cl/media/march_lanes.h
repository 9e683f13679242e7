// SPDX-License-Identifier: MIT
// Rays through the cells of a medium that varies, each of which knows the largest sigma_t within it: where a ray could
// scatter is drawn as if the medium were that dense (tracking: E. Woodcock et al., "Techniques used in the GEM code",
// 1965), cell by cell, so that empty space costs a step a cell: L. Szirmay-Kalos, B. Toth, M. Magdics, "Free Path
// Sampling in High Resolution Inhomogeneous Participating Media", CGF 30(1), 2011. The walk from cell to cell: J.
// Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987. One width; no guard.

typedef struct {
  real3w o, inverse;  ///< The ray's origin in cells; 1 / its direction there, 0 along an axis on which it stays.
  intw x, y, z;       ///< The cell,
  intw dx, dy, dz;    ///< and the one that follows: 1, -1, 0.
  realw t, end;       ///< Where the ray is, and where it leaves the box or ends.
  maskw goes;         ///< Lanes that have not come to the end.
} March_w;

/// Narrows [near, far] to where o + t d is between low and high.
FN void clip_axis_w(realw o, realw d, real low, real high, PRIVATE realw* near, PRIVATE realw* far) {
  realw zero = splat_w(R(0.0)), most = splat_w(REAL_MAX);
  maskw stays = ~lt_w(splat_w(R(0.0)), abs_w(d));
  realw inverse = splat_w(R(1.0)) / sel_w(stays, splat_w(R(1.0)), d);
  realw a = (splat_w(low) - o) * inverse, b = (splat_w(high) - o) * inverse;
  maskw is_within = le_w(splat_w(low), o) & le_w(o, splat_w(high));
  a = sel_w(stays, sel_w(is_within, zero, most), a);
  b = sel_w(stays, most, b);
  *near = max_w(*near, min_w(a, b));
  *far = min_w(*far, max_w(a, b));
}

/// The cell of the place x, of `count`, and which one follows along d.
FN intw cell_of_w(realw x, realw d, int count, PRIVATE realw* inverse, PRIVATE intw* step) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  maskw stays = ~lt_w(zero, abs_w(d)), is_down = lt_w(d, zero);
  *inverse = sel_w(stays, zero, one / sel_w(stays, one, d));
  *step = sel_int_w(stays, splat_int_w(0), sel_int_w(is_down, splat_int_w(-1), splat_int_w(1)));
  realw last = splat_w((real)(count - 1));
  // Rounding may have put it a little outside.
  return int_of_real_w(min_w(max_w(floor_w(x), zero), last));
}

/// The march of the ways of `which`; cells: MAJORANT_..., of the medium.
FN March_w march_begin_w(const Scene* scene, GLOBAL const int* cells, const Flight_w* w, maskw which) {
  GLOBAL const real* reals = scene->shading + cells[MAJORANT_REALS];
  GLOBAL const real* low = reals + MAJORANT_LOW;
  GLOBAL const real* high = reals + MAJORANT_HIGH;
  March_w m;
  m.t = splat_w(R(0.0));
  m.end = w->length;
  clip_axis_w(w->from.x, w->d.x, low[0], high[0], &m.t, &m.end);
  clip_axis_w(w->from.y, w->d.y, low[1], high[1], &m.t, &m.end);
  clip_axis_w(w->from.z, w->d.z, low[2], high[2], &m.t, &m.end);
  m.goes = which & lt_w(m.t, m.end);
  m.t = sel_w(m.goes, m.t, splat_w(R(0.0)));
  m.o = in_box_frame_w(reals, w->from);
  real3w d = vec3_w(dot3_w(splat3_w(load3(reals + 3)), w->d), dot3_w(splat3_w(load3(reals + 6)), w->d),
                    dot3_w(splat3_w(load3(reals + 9)), w->d));
  m.o.x = fma_w(splat_w(R(0.5)), splat_w((real)cells[MAJORANT_WIDTH]), m.o.x);
  m.o.y = fma_w(splat_w(R(0.5)), splat_w((real)cells[MAJORANT_HEIGHT]), m.o.y);
  m.o.z = fma_w(splat_w(R(0.5)), splat_w((real)cells[MAJORANT_DEPTH]), m.o.z);
  real3w at = fma3_w(m.t, d, m.o);
  m.x = cell_of_w(at.x, d.x, cells[MAJORANT_WIDTH], &m.inverse.x, &m.dx);
  m.y = cell_of_w(at.y, d.y, cells[MAJORANT_HEIGHT], &m.inverse.y, &m.dy);
  m.z = cell_of_w(at.z, d.z, cells[MAJORANT_DEPTH], &m.inverse.z, &m.dz);
  return m;
}

/// The largest sigma_t of the cell that each lane is in.
FN realw majorant_w(const Scene* scene, GLOBAL const int* cells, const March_w* m) {
  intw cell = (m->z * splat_int_w(cells[MAJORANT_HEIGHT]) + m->y) * splat_int_w(cells[MAJORANT_WIDTH]) + m->x;
  return gather_w(scene->shading + cells[MAJORANT_MOST], sel_int_w(m->goes, cell, splat_int_w(0)));
}

/// Where the ray leaves the layer `cell` of an axis.
FN realw layer_end_w(intw cell, intw step, realw o, realw inverse) {
  realw ahead = real_of_int_w(sel_int_w(lt_int_w(splat_int_w(0), step), cell + splat_int_w(1), cell));
  return sel_w(nonzero_w(step), (ahead - o) * inverse, splat_w(REAL_MAX));
}

FN maskw is_layer_w(intw cell, int count) {
  return ~lt_int_w(cell, splat_int_w(0)) & lt_int_w(cell, splat_int_w(count));
}

/// Lets the lanes of m->goes come to where the optical depth *left, at the cells' largest sigma_t, is used up: those
/// that get there are returned, *most is the sigma_t of their cells; the others come to the end.
FN maskw march_w(const Scene* scene, GLOBAL const int* cells, March_w* m, PRIVATE realw* left, PRIVATE realw* most) {
  maskw arrived = none_w(), moves = m->goes;
  realw least_step = splat_w(REAL_BITS == 64 ? R(0x1p-52) : R(0x1p-23));
  *most = splat_w(R(1.0));
  while (any_w(moves)) {
    realw majorant = majorant_w(scene, cells, m);
    realw ahead_x = layer_end_w(m->x, m->dx, m->o.x, m->inverse.x);
    realw ahead_y = layer_end_w(m->y, m->dy, m->o.y, m->inverse.y);
    realw ahead_z = layer_end_w(m->z, m->dz, m->o.z, m->inverse.z);
    realw ahead = min_w(min_w(ahead_x, ahead_y), ahead_z);
    realw depth = majorant * max_w(min_w(ahead, m->end) - m->t, splat_w(R(0.0)));
    maskw stops = moves & lt_w(*left, depth), goes_on = moves & ~stops;
    // At least to the next number, so that a ray comes out of any cell.
    realw stop = max_w(m->t + *left / sel_w(stops, majorant, splat_w(R(1.0))), fma_w(m->t, least_step, m->t));
    m->t = sel_w(stops, stop, sel_w(goes_on, max_w(ahead, m->t), m->t));
    *most = sel_w(stops, majorant, *most);
    *left = sel_w(goes_on, *left - depth, *left);
    arrived = arrived | stops;
    // One axis at a time; ties take a step of no length.
    maskw is_x = goes_on & ~lt_w(ahead, ahead_x), is_y = goes_on & ~is_x & ~lt_w(ahead, ahead_y);
    maskw is_z = goes_on & ~is_x & ~is_y;
    intw still = splat_int_w(0);
    m->x = m->x + sel_int_w(is_x, m->dx, still);
    m->y = m->y + sel_int_w(is_y, m->dy, still);
    m->z = m->z + sel_int_w(is_z, m->dz, still);
    goes_on = goes_on & lt_w(m->t, m->end) & is_layer_w(m->x, cells[MAJORANT_WIDTH]) &
              is_layer_w(m->y, cells[MAJORANT_HEIGHT]) & is_layer_w(m->z, cells[MAJORANT_DEPTH]);
    moves = goes_on;
    m->goes = goes_on | arrived;
  }
  return arrived;
}

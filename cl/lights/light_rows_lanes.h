// SPDX-License-Identifier: MIT
// The lights that lanes ask for, and their parameters: those of lights that lie alike (scene/layout.h, LIGHT_ALIKE) are
// read for each lane by itself, so that one evaluation does for all of them. One width; no guard.

typedef struct {
  GLOBAL const int* row;  ///< Of one of them: what they have in common.
  intw rows;              ///< Of each lane's, in index.
  int is_one;             ///< All lanes have the same.
} LightRows_w;

FN LightRows_w rows_of_lights_w(const Scene* scene, intw lights) {
  int first = get_int_w(&lights, 0);
  LightRows_w at;
  at.row = light_row(scene, first);
  at.rows = splat_int_w(scene->index[HEADER_LIGHTS]) + lights * splat_int_w(LIGHT_INTS);
  at.is_one = !any_w(nonzero_w(lights - splat_int_w(first)));
  return at;
}

FN LightRows_w rows_of_light_w(const Scene* scene, GLOBAL const int* row) {
  LightRows_w at;
  at.row = row;
  at.rows = splat_int_w((int)(row - scene->index));
  at.is_one = 1;
  return at;
}

/// Entry `entry` of their rows.
FN intw light_entry_w(const Scene* scene, const LightRows_w* at, int entry) {
  return at->is_one ? splat_int_w(at->row[entry]) : gather_int_w(scene->index + entry, at->rows);
}

/// `count` reals of shading from each lane's place on. is_one: all places are the same. count: as of gather_row_w.
FN void shading_row_w(const Scene* scene, intw places, int is_one, int count, PRIVATE realw* row) {
  if (!is_one) {
    gather_row_once_w(scene->shading, places, count, row);
    return;
  }
  GLOBAL const real* reals = scene->shading + get_int_w(&places, 0);
  UNROLLED
  for (int k = 0; k < count; ++k) row[k] = splat_w(reals[k]);
}

/// The first `count` of their parameters.
FN void light_reals_w(const Scene* scene, const LightRows_w* at, int count, PRIVATE realw* reals) {
  shading_row_w(scene, light_entry_w(scene, at, LIGHT_REALS), at->is_one, count, reals);
}

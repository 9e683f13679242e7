// SPDX-License-Identifier: MIT
// What a mesh has at its vertices, interpolated as its positions are, or at its faces. PART_ATTRIBUTES of a part leads
// to two ints for each attribute that textures ask for, TEXTURE_IMAGE of them: where its values begin, -> shading, and
// how many reals a primitive has, 9 of vertices, 3 of faces, 0: it has none. Parameters: what multiplies them, the
// greatest value. One width; no guard.

/// Unknown: it is flat to maps of heights.
FN Real2_w mesh_attribute_slope_w(const Scene* scene, GLOBAL const int* row, TexturePlace_w at) {
  (void)scene;
  (void)row;
  (void)at;
  Real2_w slope;
  slope.x = slope.y = splat_w(R(0.0));
  return slope;
}

FN real3w mesh_attribute_value_w(const Scene* scene, GLOBAL const int* row, TexturePlace_w at) {
  GLOBAL const real* params = scene->shading + row[TEXTURE_REALS];
  GLOBAL const int* parts = scene->index + scene->index[HEADER_PARTS];
  intw zero = splat_int_w(0), tables = gather_int_w(parts + PART_ATTRIBUTES, at.part * (int)PART_INTS);
  maskw is_there = ~lt_int_w(tables, zero);
  tables = sel_int_w(is_there, tables + splat_int_w(2 * row[TEXTURE_IMAGE]), zero);
  intw reals = gather_int_w(scene->index + 1, tables);
  is_there = is_there & nonzero_w(reals);
  maskw is_of_vertices = is_there & lt_int_w(splat_int_w(3), reals);
  intw first = sel_int_w(is_there, gather_int_w(scene->index, tables) + at.primitive * reals, zero);
  intw second = sel_int_w(is_of_vertices, first + splat_int_w(3), first);
  intw third = sel_int_w(is_of_vertices, first + splat_int_w(6), first);
  real3w a = gather3_w(scene->shading, first), b = gather3_w(scene->shading, second);
  real3w c = gather3_w(scene->shading, third), none = splat3_w(vec3(R(0.0), R(0.0), R(0.0)));
  realw scale = splat_w(params[0]), most = splat_w(params[1]), least = splat_w(R(0.0));
  real3w between = fma3_w(at.own_v, c, fma3_w(at.own_u, b, scale3_w(splat_w(R(1.0)) - at.own_u - at.own_v, a)));
  real3w value = scale3_w(scale, sel3_w(is_of_vertices, between, a));
  value = vec3_w(max_w(min_w(value.x, most), least), max_w(min_w(value.y, most), least),
                 max_w(min_w(value.z, most), least));
  return sel3_w(is_there, value, none);
}

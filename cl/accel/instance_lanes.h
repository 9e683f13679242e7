// SPDX-License-Identifier: MIT
// Between the world and the frames of instances in lanes: accel/instance.h, operation by operation. One width; no
// guard.

/// What maps a ray into an instance's group (scene/layout.h), the same instance in all lanes or one a lane.
typedef struct {
  real3w to_group[3];
  real3w pivot, offset;
} InstanceRows_w;

/// placed: INSTANCE_REALS.
FN InstanceRows_w instance_rows_w(GLOBAL const real* placed) {
  InstanceRows_w rows;
  for (int k = 0; k < 3; ++k) rows.to_group[k] = splat3_w(load3(placed + INSTANCE_TO_GROUP + 3 * k));
  rows.pivot = splat3_w(load3(placed + INSTANCE_PIVOT));
  rows.offset = splat3_w(load3(placed + INSTANCE_OFFSET));
  return rows;
}

/// What maps back as well, one instance a lane: read once for all that is mapped of a hit.
typedef struct {
  InstanceRows_w rows;
  real3w to_world[3];
} Placement_w;

/// at: where each lane's INSTANCE_REALS begin in the geometry.
FN Placement_w gather_placement_w(GLOBAL const real* geometry, intw at) {
  enum { FIRST = INSTANCE_PIVOT, END = INSTANCE_TO_WORLD + 9 };
  realw row[END - FIRST];
  gather_row_w(geometry + FIRST, at, END - FIRST, row);
  Placement_w placement;
  for (int k = 0; k < 3; ++k) {
    placement.rows.to_group[k] = real3_at_w(row + INSTANCE_TO_GROUP - FIRST + 3 * k);
    placement.to_world[k] = real3_at_w(row + INSTANCE_TO_WORLD - FIRST + 3 * k);
  }
  placement.rows.pivot = real3_at_w(row + INSTANCE_PIVOT - FIRST);
  placement.rows.offset = real3_at_w(row + INSTANCE_OFFSET - FIRST);
  return placement;
}

FN realw difference_rest_w(realw a, realw b, realw s) {
  realw minus_b = s - a;
  return (a - (s - minus_b)) - (b + minus_b);
}

/// mapped_component.
FN realw mapped_each_w(real3w a, real3w v, real3w rest, realw b) {
#if TIER_ROBUST
  realw x = a.x * v.x, y = a.y * v.y, z = a.z * v.z;
  realw xy = x + y, xyz = xy + z, sum = xyz + b;
  realw error = fma_w(a.x, v.x, -x) + fma_w(a.y, v.y, -y) + fma_w(a.z, v.z, -z);
  error = error + (difference_rest_w(x, -y, xy) + difference_rest_w(xy, -z, xyz) + difference_rest_w(xyz, -b, sum));
  error = fma_w(a.x, rest.x, fma_w(a.y, rest.y, fma_w(a.z, rest.z, error)));
  return sum + error;
#else
  (void)rest;
  return fma_w(a.x, v.x, fma_w(a.y, v.y, fma_w(a.z, v.z, b)));
#endif
}

/// Origin and direction of ray_into_group, not prepared yet. o, d: on entry in the world.
FN void ray_into_group_w(const InstanceRows_w* rows, real3w* o, real3w* d) {
  realw zero = splat_w(R(0.0));
  real3w from = sub3_w(*o, rows->pivot), none = vec3_w(zero, zero, zero), to_d = *d, b = rows->offset;
  real3w rest = vec3_w(difference_rest_w(o->x, rows->pivot.x, from.x), difference_rest_w(o->y, rows->pivot.y, from.y),
                       difference_rest_w(o->z, rows->pivot.z, from.z));
  *o = vec3_w(mapped_each_w(rows->to_group[0], from, rest, b.x), mapped_each_w(rows->to_group[1], from, rest, b.y),
              mapped_each_w(rows->to_group[2], from, rest, b.z));
  *d = vec3_w(mapped_each_w(rows->to_group[0], to_d, none, zero), mapped_each_w(rows->to_group[1], to_d, none, zero),
              mapped_each_w(rows->to_group[2], to_d, none, zero));
}

/// vector_to_world.
FN real3w vector_to_world_w(const Placement_w* placement, real3w v) {
  const real3w* a = placement->to_world;
  return vec3_w(dot3_w(a[0], v), dot3_w(a[1], v), dot3_w(a[2], v));
}

/// point_to_world.
FN real3w point_to_world_w(const Placement_w* placement, real3w p) {
  return add3_w(placement->rows.pivot, vector_to_world_w(placement, sub3_w(p, placement->rows.offset)));
}

/// normal_to_world.
FN real3w normal_to_world_w(const Placement_w* placement, real3w n) {
  const real3w* a = placement->rows.to_group;
  return fma3_w(n.z, a[2], fma3_w(n.y, a[1], scale3_w(n.x, a[0])));
}

// SPDX-License-Identifier: MIT
// Groups of shapes that stand in several places: a ray into the frame of a group, a surface out of it
// (docs/decisions/0009-instances.md).
#ifndef STRAHL_ACCEL_INSTANCE_H
#define STRAHL_ACCEL_INSTANCE_H

#include "hits/nearest.h"
#include "rays/ray.h"
#include "scene/scene.h"

/// INSTANCE_REALS of them.
FN GLOBAL const real* instance_reals(const Scene* scene, int instance) {
  return scene->geometry + scene_shape_row(scene, SHAPE_COUNT)[SHAPE_GEOMETRY] + (ulong)instance * INSTANCE_REALS;
}

/// The row of the group that it places.
FN GLOBAL const int* instance_group(const Scene* scene, int instance) {
  return scene->index + scene->index[scene_shape_row(scene, SHAPE_COUNT)[SHAPE_IDS] + instance];
}

/// Where a ray is within a box, by the operations of the tree's nodes (accel/slabs_lanes.h); from t_min on.
typedef struct {
  real enter, leave;
} BoxSpan;

INLINE_FN BoxSpan span_clip(BoxSpan span, real near, real far, real o, real inv, real slack) {
  real enter = real_fma(near - o, inv, -slack), leave = real_fma(far - o, inv, slack);
  if (span.enter < enter) span.enter = enter;
  if (leave < span.leave) span.leave = leave;
  return span;
}

FN BoxSpan box_span(const Ray* ray, GLOBAL const real* box) {
  BoxSpan span;
  int x = ray->near_x, y = ray->near_y, z = ray->near_z;
  span.enter = ray->t_min;
  span.leave = REAL_MAX;
  span = span_clip(span, box[x], box[x ^ 1], ray->o.x, ray->inv.x, ray->slack.x);
  span = span_clip(span, box[y], box[y ^ 1], ray->o.y, ray->inv.y, ray->slack.y);
  return span_clip(span, box[z], box[z ^ 1], ray->o.z, ray->inv.z, ray->slack.z);
}

/// a . (v + rest) + b; in robust with about one rounding: T. Ogita, S. Rump, S. Oishi, "Accurate Sum and Dot Product",
/// SIAM J. Sci. Comput. 26(6), 2005.
FN real mapped_component(GLOBAL const real* a, real3 v, real3 rest, real b) {
#if TIER_ROBUST
  real x = a[0] * v.x, y = a[1] * v.y, z = a[2] * v.z;
  real xy = x + y, xyz = xy + z, sum = xyz + b;
  real error = real_fma(a[0], v.x, -x) + real_fma(a[1], v.y, -y) + real_fma(a[2], v.z, -z);
  error += difference_rest(x, -y, xy) + difference_rest(xy, -z, xyz) + difference_rest(xyz, -b, sum);
  error = real_fma(a[0], rest.x, real_fma(a[1], rest.y, real_fma(a[2], rest.z, error)));
  return sum + error;
#else
  (void)rest;
  return real_fma(a[0], v.x, real_fma(a[1], v.y, real_fma(a[2], v.z, b)));
#endif
}

/// The ray in the group's frame until t_max, which is in units of the world's ray. `departed`: the id, in the group, of
/// the primitive that the ray has left.
FN Ray ray_into_group(const Ray* world, GLOBAL const real* placed, real t_max, int departed) {
  GLOBAL const real* a = placed + INSTANCE_TO_GROUP;
  real3 pivot = load3(placed + INSTANCE_PIVOT), b = load3(placed + INSTANCE_OFFSET);
  real zero = R(0.0);
  real3 from = sub3(world->o, pivot), none = vec3(zero, zero, zero);
  real3 rest = vec3(difference_rest(world->o.x, pivot.x, from.x), difference_rest(world->o.y, pivot.y, from.y),
                    difference_rest(world->o.z, pivot.z, from.z));
  real3 o = vec3(mapped_component(a, from, rest, b.x), mapped_component(a + 3, from, rest, b.y),
                 mapped_component(a + 6, from, rest, b.z));
  real3 d = vec3(mapped_component(a, world->d, none, zero), mapped_component(a + 3, world->d, none, zero),
                 mapped_component(a + 6, world->d, none, zero));
  Ray ray = ray_make(o, d, world->t_min, t_max, departed);
  ray.is_outward = world->is_outward;
  return ray;
}

/// Where a traversal is: in the world (instance -1), or within an instance; then also the state of the world that it
/// returns to.
typedef struct {
  int instance;
  int floor;  ///< Height of the stack at which the instance's own entries begin.
  real enter, leave;
  GLOBAL const int* group;
  Nearest outside;
} Place;

FN int is_within(const Place* place) { return place->instance >= 0; }

FN Ray ray_of_world(const Ray* world) {
  Ray ray = *world;
  if (HAS_INSTANCES && ray.departed_instance >= 0) ray.departed = -1;
  return ray;
}

FN int leaf_kind(int reference) { return (int)((uint)~reference & (REFERENCE_MOST_KINDS - 1)); }
FN int leaf_first(int reference) { return (int)((uint)~reference >> REFERENCE_BLOCK); }
FN int leaf_blocks(int reference) { return (int)((uint)~reference >> REFERENCE_COUNT) & REFERENCE_MOST_BLOCKS; }
FN int leaf_is_list(int reference) { return leaf_blocks(reference) == 0; }

/// The list of instances after the first one of this list; NO_REFERENCE: it is empty.
FN int next_instance(const Scene* scene, int reference) {
  int next = leaf_first(reference) + 1;
  if (!leaf_is_list(reference) || next >= scene_shape_row(scene, SHAPE_COUNT)[SHAPE_LISTED]) return NO_REFERENCE;
  return (int)~((uint)next << REFERENCE_BLOCK | (uint)SHAPE_COUNT);
}

/// Enters an instance; returns 0 where it cannot be hit. ray: receives the ray in the group's frame. best: on entry the
/// nearest hit in the world, on return the empty hit of the instance.
FN int enter_instance(const Scene* scene, const Ray* world, int reference, int floor, Place* place, Ray* ray,
                      Nearest* best) {
  int instance = leaf_first(reference);
  // An empty child of a node is an empty list.
  if (leaf_is_list(reference) && instance >= scene_shape_row(scene, SHAPE_COUNT)[SHAPE_LISTED]) return 0;
  GLOBAL const real* placed = instance_reals(scene, instance);
  BoxSpan span = box_span(ray, placed + INSTANCE_BOX);
  if (!(span.enter <= span.leave) || best->t < span.enter) return 0;
  place->instance = instance;
  place->floor = floor;
  place->enter = span.enter;
  place->leave = span.leave;
  place->group = instance_group(scene, instance);
  place->outside = *best;
  // Hits beyond the box are all moved to its end, so they get equal t: the nearest of them must be found before any is
  // dropped.
  real limit = best->t < span.leave ? best->t : REAL_MAX;
  *ray = ray_into_group(world, placed, limit, world->departed_instance == instance ? world->departed : -1);
  ray_widen(ray, scene->geometry + place->group[GROUP_BOUNDS]);
  *best = nearest_none(ray->t_max);
  return 1;
}

/// Leaves an instance. best: on entry the nearest hit within the instance, on return that in the world. ray: the ray in
/// the group's frame.
FN void leave_instance(Place* place, const Ray* ray, Nearest* best) {
  Nearest found = *best;
  *best = place->outside;
  real t = found.t * ray->t_from_scaled;
  if (t < place->enter) t = place->enter;
  if (place->leave < t) t = place->leave;
  int is_before = best->kind < 0 || place->instance < best->instance;
  if (found.kind >= 0 && (t < best->t || (t == best->t && is_before))) {
    *best = found;
    best->t = t;
#if TIER_ROBUST
    best->t_least = t;
#endif
    best->instance = place->instance;
  }
  place->instance = -1;
}

FN real3 point_to_world(GLOBAL const real* placed, real3 p) {
  GLOBAL const real* l = placed + INSTANCE_TO_WORLD;
  real3 from = sub3(p, load3(placed + INSTANCE_OFFSET));
  real3 turned = vec3(dot3(load3(l), from), dot3(load3(l + 3), from), dot3(load3(l + 6), from));
  return add3(load3(placed + INSTANCE_PIVOT), turned);
}

/// A normal is mapped by the transpose of the mapping into the group, so that outward normals stay outward. The result
/// is not a unit vector.
FN real3 vector_to_world(GLOBAL const real* placed, real3 v) {
  GLOBAL const real* a = placed + INSTANCE_TO_WORLD;
  return vec3(dot3(load3(a), v), dot3(load3(a + 3), v), dot3(load3(a + 6), v));
}

FN real3 normal_to_world(GLOBAL const real* placed, real3 n) {
  GLOBAL const real* a = placed + INSTANCE_TO_GROUP;
  return fma3(n.z, load3(a + 6), fma3(n.y, load3(a + 3), scale3(n.x, load3(a))));
}

#endif

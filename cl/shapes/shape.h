// SPDX-License-Identifier: MIT
// From the nearest hit to the surface there: dispatch over the active kinds, flipped and smooth normals, mesh uvs.
#ifndef STRAHL_SHAPES_SHAPE_H
#define STRAHL_SHAPES_SHAPE_H

#include "accel/instance.h"
#include "hits/departure.h"
#include "hits/nearest.h"
#include "hits/surface.h"
#include "scene/scene.h"
#include "shapes/all.h"

/// a + u (b - a) + v (c - a) over three consecutive triples, without cancelling near a corner.
FN real3 interpolate3(GLOBAL const real* abc, real u, real v) {
  real w = R(1.0) - u - v;
  return fma3(v, load3(abc + 6), fma3(u, load3(abc + 3), scale3(w, load3(abc))));
}

/// Where u of a triangle's texture coordinates (u, v of each vertex) grows: the inverse of the map from its edges to
/// them. As of the weight of the second corner where they span no area.
FN real3 triangle_along(GLOBAL const real* prim, int stride, GLOBAL const real* uv) {
  real3 p0 = vec3(prim[0], prim[stride], prim[2 * stride]);
  real3 e1 = sub3(vec3(prim[3 * stride], prim[4 * stride], prim[5 * stride]), p0);
  real3 e2 = sub3(vec3(prim[6 * stride], prim[7 * stride], prim[8 * stride]), p0);
  real v1 = uv[3] - uv[1], v2 = uv[5] - uv[1], area = difference_of_products(uv[2] - uv[0], v2, uv[4] - uv[0], v1);
  if (area == R(0.0)) return e1;
  real sign = area < R(0.0) ? -R(1.0) : R(1.0);
  return scale3(sign, fma3(v2, e1, scale3(-v1, e2)));
}

/// A point on a box is moved away from the edges in the box's own frame (hits/departure.h), where they are parallel to
/// the axes.
FN void surface_to_world(Surface* s) {
  if (!TIER_FAST && s->outline == OUTLINE_BOX) s->position = box_departure(s);
  s->position = point_to_world(s->placed, s->position);
  s->normal = normalize3(normal_to_world(s->placed, s->normal));
}

/// lanes: the width that the scene was packed for.
FN Surface surface_at(const Scene* scene, const Ray* ray, const Nearest* hit, int lanes) {
  Surface s;
  GLOBAL const int* row = scene_shape_row(scene, hit->kind);
  Ray within = *ray;
  real t = hit->t;
  s.instance = -1;
  s.placed = scene->geometry;
  if (HAS_INSTANCES && hit->instance >= 0) {
    s.instance = hit->instance;
    s.placed = instance_reals(scene, hit->instance);
    within = ray_into_group(ray, s.placed, REAL_MAX, -1);
    t /= within.t_from_scaled;
  }
  int block = hit->slot / lanes, lane = hit->slot % lanes;
  s.part = scene->index[row[SHAPE_IDS] + row[SHAPE_BLOCKS] * lanes + hit->slot];
  GLOBAL const int* part = scene_part(scene, s.part);
  s.shape = part[PART_SHAPE];
  s.primitive = hit->id - part[PART_FIRST_ID];
  s.position = s.normal = within.o;
  if (HAS_TANGENT) s.along = vec3(R(0.0), R(0.0), R(0.0));
  if (HAS_RELIEF) s.grad_u = s.grad_v = vec3(R(0.0), R(0.0), R(0.0));
  s.facing = s.off = s.u = s.v = R(0.0);
  s.outline = OUTLINE_NONE;
  s.prim = scene->geometry;
  s.stride = lanes;
  int frame_at = part[PART_AXES];
  GLOBAL const real* frame = scene->shading + (frame_at < 0 ? 0 : frame_at);
  (void)frame;
  (void)t;
  (void)block;
  (void)lane;
  switch (hit->kind) {
#define SHAPE(name, planes)                                                         \
  case SHAPE_##name:                                                                \
    s.prim = scene->geometry + row[SHAPE_GEOMETRY] + block * (planes)*lanes + lane; \
    name##_surface(&within, s.prim, lanes, frame, t, &s);                           \
    break;
#include "shapes/shapes.def"
#undef SHAPE
    default:
      break;
  }
  if (HAS_INSTANCES && hit->instance >= 0) surface_to_world(&s);
#if TIER_FAST
  s.position = ray_at(ray, hit->t);  // As in textbooks: the point is off the surface by the rounding of o + t d.
#endif
  surface_keep_finite(ray, &s);
  s.tex_u = s.u;
  s.tex_v = s.v;
  s.is_flipped = part[PART_FLIP];
  if (s.is_flipped != 0) {
    s.normal = negate3(s.normal);
    s.facing = -s.facing;
  }
  s.shading = s.normal;
  if (HAS_SMOOTH_NORMALS && part[PART_NORMALS] >= 0) {
    real3 smooth = interpolate3(scene->shading + part[PART_NORMALS] + 9 * s.primitive, s.u, s.v);
    if (HAS_INSTANCES && hit->instance >= 0) smooth = normal_to_world(s.placed, smooth);
    if (dot3(smooth, smooth) > R(0.0)) s.shading = normalize3(part[PART_FLIP] != 0 ? negate3(smooth) : smooth);
  }
  if (HAS_MESH_UVS && part[PART_UVS] >= 0) {
    GLOBAL const real* uv = scene->shading + part[PART_UVS] + 6 * s.primitive;
    if (HAS_TANGENT) s.along = triangle_along(s.prim, s.stride, uv);
    if (HAS_RELIEF) {
      real3 u = s.grad_u, v = s.grad_v;
      s.grad_u = fma3(uv[2] - uv[0], u, scale3(uv[4] - uv[0], v));
      s.grad_v = fma3(uv[3] - uv[1], u, scale3(uv[5] - uv[1], v));
    }
    real w = R(1.0) - s.u - s.v;
    s.tex_u = real_fma(s.v, uv[4], real_fma(s.u, uv[2], w * uv[0]));
    s.tex_v = real_fma(s.v, uv[5], real_fma(s.u, uv[3], w * uv[1]));
  }
  if (HAS_TANGENT && HAS_INSTANCES && hit->instance >= 0) s.along = vector_to_world(s.placed, s.along);
  if (HAS_RELIEF && HAS_INSTANCES && hit->instance >= 0) {
    s.grad_u = normal_to_world(s.placed, s.grad_u);
    s.grad_v = normal_to_world(s.placed, s.grad_v);
  }
  return s;
}

#endif

// SPDX-License-Identifier: MIT
// What is known of the point that a ray has hit. Frame: the one the scene was uploaded in.
#ifndef STRAHL_HITS_SURFACE_H
#define STRAHL_HITS_SURFACE_H

#include "rays/ray.h"
#include "math/vec3.h"

/// The outline that the surface may share with a neighbour (hits/departure.h). ROUND: a convex curved surface, which
/// has no outline.
enum { OUTLINE_NONE, OUTLINE_TRIANGLE, OUTLINE_PARALLELOGRAM, OUTLINE_BOX, OUTLINE_ROUND };

typedef struct {
  real3 position;        ///< On the surface to rounding, not o + t d where the shape knows better.
  real3 normal;          ///< Unit, geometric, as built.
  real3 shading;         ///< Unit: interpolated vertex normals where there are any.
  real3 along;           ///< Where u grows, of any length; set only with TANGENT. 0: the shape does not say.
  real3 grad_u, grad_v;  ///< Gradients of tex_u and tex_v on the surface; set only with RELIEF. 0: they are constant.
  real u, v;             ///< The shape's own parameters (docs/scene-format.md).
  real tex_u, tex_v;     ///< Texture coordinates: the mesh's uvs where there are any, else u, v.
  real footprint;        ///< How wide the pixel is here; set only where there are textures (textures/footprint.h).
  int outline;           ///< OUTLINE_...
  real off;              ///< Bound on the position's distance from its plane; 0: that of its outline. Of round shapes:
                         ///< what a bound by the position alone leaves out, in the frame of the group.
  real facing;           ///< Below 0: the ray comes from the normal's side. Known before the normal is.
  int is_flipped;        ///< 1: the normal points the other way than the shape has it.
  GLOBAL const real* prim;  ///< Its planes, `stride` apart.
  int stride;
  int shape;                  ///< Index in file order.
  int primitive;              ///< Within the shape.
  int part;                   ///< Row of the part table.
  int instance;               ///< That it belongs to; -1: none.
  GLOBAL const real* placed;  ///< Its INSTANCE_REALS, defined only in an instance. `prim` is in the group's frame.
} Surface;

/// The surface where nothing is hit. It is defined because PoCL would otherwise keep it in memory across work-items.
FN Surface surface_none(void) {
  Surface s;
  s.position = s.normal = s.shading = vec3(R(0.0), R(0.0), R(0.0));
  s.along = s.grad_u = s.grad_v = s.normal;
  s.u = s.v = s.tex_u = s.tex_v = s.footprint = s.facing = s.off = R(0.0);
  s.outline = OUTLINE_NONE;
  s.is_flipped = s.stride = s.shape = s.primitive = s.part = 0;
  s.instance = -1;
  s.prim = s.placed = 0;
  return s;
}

/// Surface.off of a round shape of that size.
FN real round_off(real size) { return R(8.0) * real_roundoff() * size; }

FN real3 ray_at(const Ray* ray, real t) { return fma3(t, ray->d, ray->o); }

/// Where a shape is so large or small that its own numbers leave the range of real, numbers of the ray replace them, so
/// that no reported value is infinite or NaN (test_arbitrary_bits).
FN void surface_keep_finite(const Ray* ray, Surface* s) {
  if (!is_finite3(s->position)) s->position = ray->o;
  if (!is_finite3(s->normal)) s->normal = normalize3(negate3(ray->d));
  if (!(s->facing < R(0.0) || R(0.0) <= s->facing)) s->facing = -R(1.0);
  if (!real_is_finite(s->u)) s->u = R(0.0);
  if (!real_is_finite(s->v)) s->v = R(0.0);
}

#endif

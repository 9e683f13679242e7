// SPDX-License-Identifier: MIT
// Rays that leave a surface: the one place that decides where they begin.
//
// The primitive that a ray leaves is excluded by its id, and a round shape is hit again only at its other, analytic
// root. So a ray begins exactly at the point found, with no offset and no epsilon. A ray that leaves a round shape
// outwards does not hit it again; the normal decides this, even where rounding has put the point on the other side of
// the shape.
//
// Flat polygons and boxes have neighbours that touch them: a point within rounding of a shared edge may lie outside of
// the neighbour, and a ray from there would leave a closed room. So
//   - polygons: the point moves off the edges that are nearer than b, within the plane, and by b along the normal to
//     the side that the ray goes to. b = 7/4 u (max |p_i| + size) bounds the rounding of a point interpolated over
//     corners ("Solving Self-Intersection Artifacts in DirectX Raytracing", NVIDIA, 2023, has u |p0| + 3 u extent along
//     the normal alone). The whole displacement is at most 4 u (max |p_i| + size), apart from rounding. A point of a
//     large polygon that is known better (shapes/polygon/near_point.h) moves by its own bound, off edges by that and
//     the error of its height over them;
//   - boxes: the coordinate across the face is the face's, exactly; the other two stay strictly between the faces.
// In an instance the face of a box is not axis-aligned in the world. There a ray leaves it as it leaves a polygon, with
// the rounding of the instance's mapping added to the bound.
// Rays leave in lanes (hits/surfaces_lanes.h). The fast tier leaves from the point found, by its epsilon
// (hits/epsilon_fast.h). A polygon that is narrower than 4 b keeps its point as far from its edges as fits. Held by
// tests/render/test_mirror_box.cpp and tests/cl/test_departure.cpp.
#ifndef STRAHL_HITS_DEPARTURE_H
#define STRAHL_HITS_DEPARTURE_H

#include "accel/instance.h"
#include "rays/ray.h"
#include "hits/surface.h"
#include "shapes/polygon/corners.h"

FN real larger_of(real a, real b) { return a > b ? a : b; }

/// `move`, plus the step that brings the point p + from to the distance `bound` from the line a b. `within`: a corner
/// on the inner side. is_near: p is near the origin and the corners are far, so that p - a would be rounded as a is.
/// The height of the origin over the line is subtracted instead: of the products of b x a most cancels, but no
/// rounding.
FN real3 off_edge(real3 move, real3 p, real3 from, real3 a, real3 b, real3 within, real3 normal, real bound,
                  int is_near) {
  real3 across = cross3(normal, sub3(b, a)), inward = normalize3(across);
  real height = dot3(inward, sub3(within, a)), zero = R(0.0);
  if (height < zero) {  // The normal was turned by flip_normals.
    inward = negate3(inward);
    height = -height;
  }
  real room = R(0.25) * height;
  real height_of_p = dot3(inward, add3(sub3(p, is_near ? vec3(zero, zero, zero) : a), from));
  if (is_near) height_of_p -= dot3(normal, cross3(b, a)) / dot3(inward, across);
  real missing = (bound < room ? bound : room) - height_of_p;
  return missing > R(0.0) ? fma3(missing, inward, move) : move;
}

/// In the world.
FN real3 outline_corner(const Surface* s, int k) {
  real3 p = corner_load(s->prim, s->stride, k);
  if (HAS_INSTANCES && s->instance >= 0) p = point_to_world(s->placed, p);
  return p;
}

/// A bound on how far a point within `reach` of the origin may be off its surface.
FN real departure_bound(const Surface* s, real reach) {
  if (HAS_INSTANCES && s->instance >= 0) reach += s->placed[INSTANCE_ERROR];
  return R(1.75) * real_roundoff() * reach;
}

/// 1: the point is certainly farther than the bound from every edge, rounding included, so it need not move. The height
/// over an edge is its weight times twice the area over its length, which is at most 2 sqrt(3) size.
FN int is_amid(const Surface* s, real3 e, real3 f, real size, real bound) {
  real least = s->u < s->v ? s->u : s->v;
  real u_rest = R(1.0) - s->u, v_rest = R(1.0) - s->v, both_rest = u_rest - s->v;
  if (s->outline == OUTLINE_TRIANGLE) {
    least = both_rest < least ? both_rest : least;
  } else {
    least = u_rest < least ? u_rest : least;
    least = v_rest < least ? v_rest : least;
  }
  real3 n = vec3(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
  real across = real_abs(dot3(s->normal, n));
  return least * across > R(16.0) * bound * size;
}

/// Where rays leave a surface: from `point`, moved by `move` and by `bound` along the normal to the side that the ray
/// goes to. Below 0: of round shapes, which rays leave from `point` itself, how far that may be off the surface; rays
/// that end at it stop so much before it.
typedef struct {
  real3 point, move;
  real bound;
} Departure;

FN void polygon_departure(const Surface* s, Departure* departure) {
  int corners = s->outline == OUTLINE_TRIANGLE ? 3 : 4;
  real3 p = s->position, first = outline_corner(s, 0);
  real3 e = sub3(outline_corner(s, 1), first), f = sub3(outline_corner(s, corners - 1), first);
  real size = larger_of(max3(abs3(e)), max3(abs3(f)));
  real bound = departure_bound(s, max3(abs3(p)) + size);
  int is_placed = HAS_INSTANCES && s->instance >= 0, is_near = !is_placed && R(0.0) < s->off;
  departure->bound = is_near ? s->off : bound;
  if (is_amid(s, e, f, size, bound)) return;
  // The height's error is at most 16 u max |p_i| (tests/cl/test_departure.cpp).
  if (is_near) bound = real_fma(R(16.0) * real_roundoff(), max3(abs3(p)), s->off);
  // The point moves away from all edges at once: in a sharp corner, a move away from one edge alone could cross the
  // other. A second step adds what is still missing. The point itself is rounded once, at the end.
  real3 move = departure->move;
  for (int pass = 0; pass < 2; ++pass) {
    real3 from = move;
    for (int k = 0; k < corners; ++k) {
      real3 a = outline_corner(s, k), b = outline_corner(s, (k + 1) % corners);
      real3 within = outline_corner(s, (k + 2) % corners);
      move = off_edge(move, p, from, a, b, within, s->normal, bound, is_near);
    }
  }
  departure->move = move;
}

/// x, clamped strictly between the faces lo and hi where a number lies between them.
FN real between_faces(real x, real lo, real hi) {
  real u2 = R(2.0) * real_roundoff(), size = hi - lo;
  real first = lo + u2 * (real_abs(lo) + size), last = hi - u2 * (real_abs(hi) + size);
  if (!(first < last)) return x;
  return x < first ? first : (x > last ? last : x);
}

FN real3 box_departure(const Surface* s) {
  real3 p = s->position, n = s->normal, inside;
  real zero = R(0.0);
  inside = vec3(between_faces(p.x, s->prim[0], s->prim[s->stride]),
                between_faces(p.y, s->prim[2 * s->stride], s->prim[3 * s->stride]),
                between_faces(p.z, s->prim[4 * s->stride], s->prim[5 * s->stride]));
  return vec3(n.x != zero ? p.x : inside.x, n.y != zero ? p.y : inside.y, n.z != zero ? p.z : inside.z);
}

/// Of a round shape whose own bound is `off`, in the world. Its points are as far off as it is large, be they near or
/// not.
FN real round_departure_bound(const Surface* s) {
  real off = s->off;
  if (HAS_INSTANCES && s->instance >= 0) off = off / s->placed[INSTANCE_SHRINK] + departure_bound(s, R(0.0));
  return off;
}

FN Departure departure_of(const Surface* s) {
  Departure departure;
  real zero = R(0.0);
  departure.point = s->position;
  departure.move = vec3(zero, zero, zero);
  departure.bound = zero;
  if (!TIER_FAST && s->outline == OUTLINE_BOX) {
    if (HAS_INSTANCES && s->instance >= 0)
      departure.bound = departure_bound(s, max3(abs3(s->position)));
    else
      departure.point = box_departure(s);
  }
  if (!TIER_FAST && s->outline == OUTLINE_ROUND) departure.bound = -round_departure_bound(s);
  if (!TIER_FAST && (s->outline == OUTLINE_TRIANGLE || s->outline == OUTLINE_PARALLELOGRAM))
    polygon_departure(s, &departure);
  return departure;
}

#endif

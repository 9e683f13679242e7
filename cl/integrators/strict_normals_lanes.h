// SPDX-License-Identifier: MIT
// strict_normals of Mitsuba 0.x: light arrives and leaves on one side of the surface by the shading normal and by the
// geometric one alike, or there is none. One width; no guard.

/// The lanes of `which` in which both normals have d on one side. An interpolated normal that faces the other way than
/// its triangle counts turned around. Where a path scatters in a medium the two are one.
FN maskw on_one_side_w(const Scene* scene, const Surfaces_w* s, maskw which, real3w d) {
  if (scene->index[HEADER_STRICT_NORMALS] == 0) return which;
  realw side = dot3_w(d, s->normal) * dot3_w(d, s->shading) * dot3_w(s->normal, s->shading);
  return which & lt_w(splat_w(R(0.0)), side);
}

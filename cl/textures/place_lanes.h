// SPDX-License-Identifier: MIT
// Where LANES points lie on a texture. One width; no guard.

/// The values of surface points that textures use.
typedef struct {
  realw u, v;    ///< As in hits/surface.h.
  realw du, dv;  ///< The size of the pixel in u and v.
  // Used with MESH_ATTRIBUTE alone.
  realw own_u, own_v;    ///< The shape's own parameters.
  intw part, primitive;  ///< Of the part table, of the shape.
} TexturePlace_w;

/// m: u' = m0 u + m1 v + m2, v' = m3 u + m4 v + m5.
FN Real2_w mapped_uv_w(GLOBAL const real* m, realw u, realw v) {
  Real2_w mapped;
  mapped.x = fma_w(splat_w(m[0]), u, fma_w(splat_w(m[1]), v, splat_w(m[2])));
  mapped.y = fma_w(splat_w(m[3]), u, fma_w(splat_w(m[4]), v, splat_w(m[5])));
  return mapped;
}

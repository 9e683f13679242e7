// SPDX-License-Identifier: MIT
// Where texture coordinates grow on LANES surfaces, for materials that know along from across and for reliefs: as in
// surface_at of shapes/shape.h and hits/edge_gradients.h, operation by operation. One width; no guard.

/// The texture coordinates of each lane's triangle, relative to those of its first corner.
typedef struct {
  realw u1, v1, u2, v2;
} UvEdges_w;

FN UvEdges_w uv_edges_w(GLOBAL const real* uv, intw place) {
  realw corners[6];
  gather_row_w(uv, place, 6, corners);
  UvEdges_w edges;
  edges.u1 = corners[2] - corners[0];
  edges.v1 = corners[3] - corners[1];
  edges.u2 = corners[4] - corners[0];
  edges.v2 = corners[5] - corners[1];
  return edges;
}

/// triangle_along of shapes/shape.h.
FN real3w triangle_along_w(const UvEdges_w* uv, real3w e1, real3w e2) {
  realw one = splat_w(R(1.0)), zero = splat_w(R(0.0));
  realw area = difference_of_products_w(uv->u1, uv->v2, uv->u2, uv->v1);
  real3w along = scale3_w(sel_w(lt_w(area, zero), -one, one), fma3_w(uv->v2, e1, scale3_w(-uv->v1, e2)));
  return sel3_w(eq_w(area, zero), e1, along);
}

/// take_edge_gradients of hits/edge_gradients.h.
FN void edge_gradients_w(real3w edge_u, real3w edge_v, PRIVATE real3w* grad_u, PRIVATE real3w* grad_v) {
  realw one = splat_w(R(1.0)), zero = splat_w(R(0.0));
  real3w n = cross3_w(edge_u, edge_v), unit = normalize3_w(n);
  realw area = length3_w(n);
  maskw has_area = lt_w(zero, area);
  realw inverse = sel_w(has_area, one / sel_w(has_area, area, one), zero);
  *grad_u = scale3_w(inverse, cross3_w(edge_v, unit));
  *grad_v = scale3_w(inverse, cross3_w(unit, edge_u));
}

/// Of polygons; those of other shapes are there already, in the frame of their group.
FN void tangents_each_w(const Scene* scene, const SurfaceHits_w* hits, maskw plain, const HitParameters_w* at,
                        Surfaces_w* s) {
  maskw flat = at->has_edges;
  if (HAS_TANGENT) s->along = sel3_w(flat, at->edge_u, s->along);
  if (HAS_RELIEF) {
    real3w grad_u, grad_v;
    edge_gradients_w(at->edge_u, at->edge_v, &grad_u, &grad_v);
    s->grad_u = sel3_w(flat, grad_u, s->grad_u);
    s->grad_v = sel3_w(flat, grad_v, s->grad_v);
  }
  if (HAS_MESH_UVS) {
    maskw has_uvs = flat;
    intw place = mesh_corners_w(scene, hits, s, PART_UVS, 6, &has_uvs);
    if (any_w(has_uvs)) {
      UvEdges_w uv = uv_edges_w(scene->shading, place);
      if (HAS_TANGENT) s->along = sel3_w(has_uvs, triangle_along_w(&uv, at->edge_u, at->edge_v), s->along);
      if (HAS_RELIEF) {
        real3w u = s->grad_u, v = s->grad_v;
        s->grad_u = sel3_w(has_uvs, fma3_w(uv.u1, u, scale3_w(uv.u2, v)), u);
        s->grad_v = sel3_w(has_uvs, fma3_w(uv.v1, u, scale3_w(uv.v2, v)), v);
      }
    }
  }
  if (!HAS_INSTANCES) return;
  maskw placed = plain & hits->is_placed;
  if (!any_w(placed)) return;
  if (HAS_TANGENT) s->along = sel3_w(placed, vector_to_world_w(&hits->placement, s->along), s->along);
  if (HAS_RELIEF) {
    s->grad_u = sel3_w(placed, normal_to_world_w(&hits->placement, s->grad_u), s->grad_u);
    s->grad_v = sel3_w(placed, normal_to_world_w(&hits->placement, s->grad_v), s->grad_v);
  }
}

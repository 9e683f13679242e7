// SPDX-License-Identifier: MIT
// How likely the techniques of bidirectional path tracing make the same path: the balance heuristic over all of them,
// by sums that each subpath carries along, so that no weight walks back over the path (I. Georgiev, "Implementing
// Vertex Connection and Merging", Saarland University, 2012; without merging, and with exponent 1, so that no square
// leaves a float's range).
//
// A path of k edges is made by up to k + 1 techniques, one for each number of its vertices that come from the light.
// The light's vertices that are joined with the camera's are kept, and their number is bounded (LIGHT_VERTICES). So
// only paths of up to FULL_EDGES edges are made by all techniques. Longer ones are made by three: the path from the
// camera finds the light, or its last vertex is joined with a place on the light; or the path from the light is joined
// with the sensor. A second sum, over these alone, gives their weights. Angles are those to the surfaces themselves,
// whatever their shading normals. One width; no guard.

enum { LIGHT_VERTICES_w = 8, FULL_EDGES_w = LIGHT_VERTICES_w + 2 };

/// Of a subpath up to a vertex. All are ratios: the density of another technique over that of this subpath, apart from
/// what only the rest of the path decides.
typedef struct {
  realw last;     ///< Of the technique that joins this vertex with the one before. 0: a delta lobe lies there.
  realw earlier;  ///< The sum over those that join two earlier ones, or end earlier, over the density with which the
                  ///< way back from this vertex is drawn.
  realw ends;     ///< The same, of the techniques that long paths have.
} Techniques_w;

/// A new vertex. area: what turns a solid angle at the vertex before into an area across the ray here.
FN void techniques_arrive_w(maskw which, realw area, realw cosine, Techniques_w* t) {
  realw least = splat_w(real_roundoff() * real_roundoff()), over = splat_w(R(1.0)) / max_w(cosine, least);
  t->last = sel_w(which, t->last * area * over, t->last);
  t->earlier = sel_w(which, t->earlier * over, t->earlier);
  t->ends = sel_w(which, t->ends * over, t->ends);
}

/// The new direction was drawn with `density`, 0 of a delta lobe; the way back from there has density `reverse`;
/// cosine: of the new direction. is_first: lanes whose last edge is one that long paths join, too.
FN void techniques_turn_w(maskw which, maskw is_first, realw density, realw reverse, realw cosine, Techniques_w* t) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  maskw is_spread = lt_w(zero, density);
  realw over = sel_w(is_spread, one / sel_w(is_spread, density, one), zero);
  realw ends = fma_w(t->ends, reverse, sel_w(is_first, t->last, zero));
  realw earlier = fma_w(t->earlier, reverse, t->last);
  t->ends = sel_w(which, cosine * sel_w(is_spread, over * ends, t->ends), t->ends);
  t->earlier = sel_w(which, cosine * sel_w(is_spread, over * earlier, t->earlier), t->earlier);
  t->last = sel_w(which, over, t->last);
}

/// Lanes whose paths have more edges than all techniques make.
FN maskw is_long_w(intw edges) { return lt_int_w(splat_int_w(FULL_EDGES_w), edges); }

/// All techniques with fewer of the subpath's vertices, of paths of so many edges, where the way back from its last
/// vertex is drawn with density `reverse`.
FN realw techniques_before_w(const Techniques_w* t, intw edges, maskw is_first, realw reverse) {
  maskw is_long = is_long_w(edges);
  realw last = sel_w(is_long & ~is_first, splat_w(R(0.0)), t->last);
  return fma_w(sel_w(is_long, t->ends, t->earlier), reverse, last);
}

/// The weight of a technique: others: the sum of all others' densities over its own.
FN realw weight_among_w(realw others) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  maskw is_sound = le_w(zero, others);
  return sel_w(is_sound, one / (one + sel_w(is_sound, others, zero)), zero);
}

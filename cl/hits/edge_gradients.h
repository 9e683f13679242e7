// SPDX-License-Identifier: MIT
// How coordinates along two edges change over the plane that the edges span: vectors at right angles to the other edge.
#ifndef STRAHL_HITS_EDGE_GRADIENTS_H
#define STRAHL_HITS_EDGE_GRADIENTS_H

#include "hits/surface.h"

/// Gradients of u and v at points a + u edge_u + v edge_v; 0 where the edges span no area.
FN void take_edge_gradients(real3 edge_u, real3 edge_v, Surface* s) {
  real3 n = cross3(edge_u, edge_v);
  real area = length3(n), inverse = area > R(0.0) ? R(1.0) / area : R(0.0);
  real3 unit = normalize3(n);
  s->grad_u = scale3(inverse, cross3(edge_v, unit));
  s->grad_v = scale3(inverse, cross3(unit, edge_u));
}

#endif

// SPDX-License-Identifier: MIT
// intersect_any.cl for coherent rays.
#define RAYS_ARE_ALIKE 1
#include "kernels/intersect_any.cl"

// SPDX-License-Identifier: MIT
// intersect.cl for coherent rays.
#define RAYS_ARE_ALIKE 1
#include "kernels/intersect.cl"

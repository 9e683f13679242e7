// SPDX-License-Identifier: MIT
// intersect.cl for rays that are alike.
#define RAYS_ARE_ALIKE 1
#include "kernels/intersect.cl"

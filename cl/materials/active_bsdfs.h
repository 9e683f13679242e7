// SPDX-License-Identifier: MIT
// What the program's materials need and do together.
#ifndef STRAHL_MATERIALS_ACTIVE_BSDFS_H
#define STRAHL_MATERIALS_ACTIVE_BSDFS_H

#include "materials/lobes.h"

/// As large as the parameters of the material that has most of them.
typedef union {
  char none[1];
#define MATERIAL(name, reals, lobes) char name[reals];
#include "materials/materials.def"
#undef MATERIAL
} LargestBsdf;

enum {
  BSDF_REALS = (int)sizeof(LargestBsdf),
  /// Any that a surface may have.
  BSDF_LOBES = 0
#define MATERIAL(name, reals, lobes) | (lobes)
#include "materials/materials.def"
#undef MATERIAL
  ,
  HAS_DELTA_LOBES = (BSDF_LOBES & LOBE_DELTA) != 0 || HAS_COAT,
  HAS_TRANSMISSION = (BSDF_LOBES & LOBE_TRANSMIT) != 0
};

#endif

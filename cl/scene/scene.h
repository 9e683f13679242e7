// SPDX-License-Identifier: MIT
// The scene as kernels see it: three buffers (layout.h) and the enumerators of the active entries of every list.
#ifndef STRAHL_SCENE_SCENE_H
#define STRAHL_SCENE_SCENE_H

#include "portable.h"
#include "scene/layout.h"

enum {
#define SHAPE(name, planes) SHAPE_##name,
#include "shapes/shapes.def"
#undef SHAPE
  SHAPE_COUNT
};

enum {
#define MATERIAL(name, reals, lobes) MATERIAL_##name,
#include "materials/materials.def"
#undef MATERIAL
  MATERIAL_COUNT
};
/// Whether every material is of the one kind that the program has. The kind of one that was left out is -1.
#define ONLY_MATERIAL (MATERIAL_COUNT == 1 && !HAS_BLACK)

enum {
#define TEXTURE(name) TEXTURE_##name,
#include "textures/textures.def"
#undef TEXTURE
  TEXTURE_COUNT
};

enum {
#define LIGHT(name) LIGHT_##name,
#define DELTA_LIGHT LIGHT
#include "lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
  LIGHT_COUNT
};

/// Of these, those that no ray hits.
enum {
#define LIGHT(name)
#define DELTA_LIGHT(name) DELTA_LIGHT_##name,
#include "lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
  DELTA_LIGHT_COUNT
};

enum {
#define CHOOSER(name) CHOOSER_##name,
#include "choosers/choosers.def"
#undef CHOOSER
  CHOOSER_COUNT
};

enum {
#define AREA(name, reals) AREA_##name,
#include "areas/areas.def"
#undef AREA
  AREA_COUNT
};

enum {
#define SAMPLER(name) SAMPLER_##name,
#include "samplers/samplers.def"
#undef SAMPLER
  SAMPLER_COUNT
};

enum {
#define INTEGRATOR(name) INTEGRATOR_##name,
#include "integrators/integrators.def"
#undef INTEGRATOR
  INTEGRATOR_COUNT
};

#if HAS_LIGHT_PATHS
/// The film that light paths add to, each to any pixel (film/splat.h).
typedef struct {
  GLOBAL long* words;
  int x, y, columns, rows;  ///< Its place in the picture, its pixels.
  int sums;                 ///< Of a pixel's light paths.
  int pixel_words;          ///< Those, and the sums of film/film_sum.h of its own camera paths, if there are any.
  GLOBAL uint* done;        ///< With HAS_LOOP_LIMIT: how far the work-item has come, as COUNTERS describes it.
} SplatFilm;
#endif

typedef struct {
  GLOBAL const real* geometry;
  GLOBAL const real* shading;
  GLOBAL const int* index;
  GLOBAL uint* counters;  ///< COUNTERS of them; written only by programs that count.
#if HAS_LIGHT_PATHS
  PRIVATE const SplatFilm* splats;
#endif
#if HAS_MEDIA
  GLOBAL const int* met;  ///< The row, as of a group, of the shapes that rays meet; 0: those of the header.
#endif
} Scene;

/// The scene in a kernel's buffers. counters: null in kernels that count nothing.
FN Scene scene_of(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                  GLOBAL uint* counters) {
  Scene scene;
  scene.geometry = geometry;
  scene.shading = shading;
  scene.index = index;
  scene.counters = counters;
#if HAS_LIGHT_PATHS
  scene.splats = 0;
#endif
#if HAS_MEDIA
  scene.met = 0;
#endif
  return scene;
}

FN GLOBAL const int* scene_shape_row(const Scene* scene, int kind) {
  return scene->index + HEADER_INTS + kind * SHAPE_INTS;
}

FN GLOBAL const int* scene_part(const Scene* scene, int part) {
  return scene->index + scene->index[HEADER_PARTS] + part * PART_INTS;
}

#endif

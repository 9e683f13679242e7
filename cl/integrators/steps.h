// SPDX-License-Identifier: MIT
// What a path does at a surface: what an integrator asks for (integrators.def), of any width.
#ifndef STRAHL_INTEGRATORS_STEPS_H
#define STRAHL_INTEGRATORS_STEPS_H

enum {
  STEP_LIGHTS = 1,     ///< Add the light of the lights at the surface.
  STEP_DELTA = 2,      ///< Follow the material's delta lobes.
  STEP_SCATTER = 4,    ///< Follow a direction that the material draws; drawn lights are then weighted against it.
  STEP_ROULETTE = 8,   ///< Apply Russian roulette.
  STEP_OPENNESS = 16,  ///< Add white if an ambient-occlusion ray hits nothing.
  STEP_THROUGH = 32,   ///< Light goes through masks as if they were not there, and through media.
  STEP_ADJOINT = 64    ///< The path comes from a light: what the material does to it is the adjoint.
};

#endif

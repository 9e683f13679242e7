// SPDX-License-Identifier: MIT
// What a path does at a surface: what an integrator asks for (integrators.def), of any width.
#ifndef STRAHL_INTEGRATORS_STEPS_H
#define STRAHL_INTEGRATORS_STEPS_H

enum {
  STEP_LIGHTS = 1,    ///< Add what the lights throw on the surface.
  STEP_DELTA = 2,     ///< Follow the material's delta lobes.
  STEP_SCATTER = 4,   ///< Follow a way that the material draws; drawn lights then share their work with it.
  STEP_ROULETTE = 8,  ///< Perhaps not.
  STEP_OPENNESS = 16  ///< Add white if a way into the open meets nothing.
};

#endif

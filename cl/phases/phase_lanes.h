// SPDX-License-Identifier: MIT
// How media turn light: dispatch over the phase functions of each medium, of which each has a share. One width; no
// guard.

/// An angle between two ways: 1 - cos and 1 + cos, so that neither loses digits, and the density per solid angle with
/// which it was drawn.
typedef struct {
  realw missing, beyond, density;
} Turn_w;

FN Turn_w turn_of_w(realw missing, realw beyond, realw density) {
  Turn_w turn;
  turn.missing = missing;
  turn.beyond = beyond;
  turn.density = density;
  return turn;
}

#include "phases/all_lanes.h"

/// medium: its row. before, after: unit.
FN realw phase_of_medium_w(const Scene* scene, GLOBAL const int* medium, real3w before, real3w after) {
  realw sum = splat_w(R(0.0));
  GLOBAL const int* row = scene->index + medium[MEDIUM_PHASES];
  for (int i = 0; i < medium[MEDIUM_PHASE_COUNT]; ++i, row += PHASE_INTS) {
    GLOBAL const real* reals = scene->shading + row[PHASE_REALS];
    realw value = splat_w(R(0.0));
    switch (row[PHASE_KIND]) {
#define PHASE(name)                                        \
  case PHASE_##name:                                       \
    value = name##_value_w(reals[PHASE_G], before, after); \
    break;
#include "phases/phases.def"
#undef PHASE
      default:
        (void)before;
        (void)after;
        break;
    }
    sum = fma_w(splat_w(reals[PHASE_SHARE]), value, sum);
  }
  return sum;
}

/// The way after one of them has turned it, drawn by `number` (which one), u and v. density: of all together.
FN real3w turned_by_medium_w(const Scene* scene, GLOBAL const int* medium, real3w before, realw number, realw u,
                             realw v, PRIVATE realw* density) {
  Turn_w turn = turn_of_w(splat_w(R(1.0)), splat_w(R(1.0)), splat_w(R(0.0)));
  GLOBAL const int* row = scene->index + medium[MEDIUM_PHASES];
  int count = medium[MEDIUM_PHASE_COUNT];
  maskw left = ~none_w();
  for (int i = 0; i < count; ++i, row += PHASE_INTS) {
    GLOBAL const real* reals = scene->shading + row[PHASE_REALS];
    number = number - splat_w(reals[PHASE_SHARE]);
    maskw is_one = i + 1 == count ? left : left & lt_w(number, splat_w(R(0.0)));
    left = left & ~is_one;
    if (!any_w(is_one)) continue;
    Turn_w drawn = turn;
    switch (row[PHASE_KIND]) {
#define PHASE(name)                           \
  case PHASE_##name:                          \
    drawn = name##_turn_w(reals[PHASE_G], u); \
    break;
#include "phases/phases.def"
#undef PHASE
      default:
        (void)u;
        break;
    }
    turn.missing = sel_w(is_one, drawn.missing, turn.missing);
    turn.beyond = sel_w(is_one, drawn.beyond, turn.beyond);
    turn.density = sel_w(is_one, drawn.density, turn.density);
  }
  Frame_w frame = frame_around_w(before);
  SinCos_w around = sincos_turns_w(v);
  realw sine = sqrt_w(turn.missing * turn.beyond);
  real3w after = from_frame_w(
      &frame, vec3_w(sine * around.cosine, sine * around.sine, splat_w(R(0.5)) * (turn.beyond - turn.missing)));
  after = unit3_w(after);
  *density = count == 1 ? turn.density : phase_of_medium_w(scene, medium, before, after);
  return after;
}

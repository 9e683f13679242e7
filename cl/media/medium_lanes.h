// SPDX-License-Identifier: MIT
// Dispatch over the media that paths are within, medium by medium: all lanes of one medium are evaluated together. One
// width; no guard.

FN maskw is_within_w(intw medium) { return ~lt_int_w(medium, splat_int_w(0)); }

FN void travel_w(const Scene* scene, intw media, const SampleState_w* sample, maskw which, Flight_w* flight) {
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int medium;
    maskw of_medium = next_alike_w(media, which, &lanes, &medium);
    GLOBAL const int* row = medium_row(scene, medium);
    switch (row[MEDIUM_KIND]) {
#define MEDIUM(name)                                        \
  case MEDIUM_##name:                                       \
    name##_travel_w(scene, row, sample, of_medium, flight); \
    break;
#include "media/media.def"
#undef MEDIUM
      default:
        break;
    }
  }
}

/// The lengths of ways in `media` after which paths scatter, of the optical depth that they have drawn; REAL_MAX: not
/// known yet.
FN realw media_reach_w(const Scene* scene, intw media, const SampleState_w* sample, maskw which, realw optical) {
  realw reach = splat_w(REAL_MAX);
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int medium;
    maskw of_medium = next_alike_w(media, which, &lanes, &medium);
    GLOBAL const int* row = medium_row(scene, medium);
    switch (row[MEDIUM_KIND]) {
#define MEDIUM(name)                                                              \
  case MEDIUM_##name:                                                             \
    reach = sel_w(of_medium, name##_reach_w(scene, row, sample, optical), reach); \
    break;
#include "media/media.def"
#undef MEDIUM
      default:
        break;
    }
  }
  return reach;
}

FN real3w transmittance_w(const Scene* scene, intw media, const SampleState_w* sample, maskw which, Flight_w* flight) {
  realw one = splat_w(R(1.0));
  real3w share = vec3_w(one, one, one);
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int medium;
    maskw of_medium = next_alike_w(media, which, &lanes, &medium);
    GLOBAL const int* row = medium_row(scene, medium);
    switch (row[MEDIUM_KIND]) {
#define MEDIUM(name)                                                                                 \
  case MEDIUM_##name:                                                                                \
    share = sel3_w(of_medium, name##_transmittance_w(scene, row, sample, of_medium, flight), share); \
    break;
#include "media/media.def"
#undef MEDIUM
      default:
        break;
    }
  }
  return share;
}

/// The phase functions' value in the lanes of `which`.
FN realw phase_value_w(const Scene* scene, intw media, maskw which, real3w before, real3w after) {
  realw value = splat_w(R(0.0));
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int medium;
    maskw of_medium = next_alike_w(media, which, &lanes, &medium);
    value = sel_w(of_medium, phase_of_medium_w(scene, medium_row(scene, medium), before, after), value);
  }
  return value;
}

FN real3w phase_turn_w(const Scene* scene, intw media, maskw which, real3w before, realw number, realw u, realw v,
                       PRIVATE realw* density) {
  real3w after = before;
  *density = splat_w(R(0.0));
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int medium;
    maskw of_medium = next_alike_w(media, which, &lanes, &medium);
    realw drawn;
    real3w turned = turned_by_medium_w(scene, medium_row(scene, medium), before, number, u, v, &drawn);
    after = sel3_w(of_medium, turned, after);
    *density = sel_w(of_medium, drawn, *density);
  }
  return after;
}

// SPDX-License-Identifier: MIT
// Paths on their way through a medium, one a lane. A path has one channel, its hero, which its distances are drawn for;
// what it carries is divided by the density with which any of the three heroes would have drawn the same path (balance
// heuristic): B. Miller, I. Georgiev, W. Jarosz, "A null-scattering path integral formulation of light transport", ACM
// TOG 38(4), 2019. One width; no guard.

typedef struct {
  real3w from, d;     ///< Where the way begins; its direction, unit.
  realw length;       ///< To the surface where it ends; REAL_MAX: there is none.
  realw optical;      ///< Optical depth of the hero that is left until the path scatters.
  real3w throughput;  ///< Of the path, divided by the mean density of the heroes.
  real3w share;       ///< Each hero's density over their mean.
  real3w radiance;    ///< What the medium has emitted on the way, as it reaches the camera.
  maskw scatters;     ///< Lanes that scatter before the surface,
  realw t;            ///< and where.
  uintw draws;        ///< The stream's next numbers (samplers/uses.h).
} Flight_w;

/// The stream's next numbers, which the lanes of `which` have then drawn: of what a path meets any number of times.
FN Random4_w stream_numbers_w(const SampleState_w* sample, maskw which, PRIVATE uintw* draws) {
  Random4_w numbers = random4_w(sample->pixel, sample->sample, *draws, sample->seed);
  *draws = *draws + uint_of_int_w(sel_int_w(which, splat_int_w(1), splat_int_w(0)));
  return numbers;
}

/// -ln(1 - v), v the number whose bits are those of `high` and then of `low`: an optical depth from 2.7e-20 to 45 of
/// exponential distribution. Exact to 3 ulps: near 0 by the logarithm's series, beyond by ln of what is left to 1.
FN realw optical_depth_w(uintw high, uintw low) {
  realw one = splat_w(R(1.0)), down = splat_w(R(0x1p-32));
  realw v = fma_w(real_of_uint_w(low) + splat_w(R(0.5)), down * down, real_of_uint_w(high) * down);
  realw rest = fma_w(real_of_uint_w(~low) + splat_w(R(0.5)), down * down, real_of_uint_w(~high) * down);
  maskw is_near = lt_w(v, splat_w(R(0.25)));
  realw near = sel_w(is_near, v, splat_w(R(0.0))), s = -near / (splat_w(R(2.0)) - near), z = s * s;
  // ln(1 + f) = f - s (f - z tail), f = -v.
  realw series = near + s * fma_w(-z, log_tail_w(z), -near);
  return sel_w(is_near, series, minus_log_w(sel_w(is_near, one, rest)));
}

/// 1 - e^-a for a >= 0: 2 ulps.
FN realw one_minus_exp_w(realw a) {
  realw one = splat_w(R(1.0)), zero = splat_w(R(0.0));
  maskw is_near = lt_w(a, splat_w(R(0.34)));
  realw r = sel_w(is_near, a, zero);
  return sel_w(is_near, fma_w(-r * r, exp_tail_w(r), r), one - exp_minus_w(a));
}

/// The hero's channel of a colour.
FN realw of_hero_w(const Scene* scene, const SampleState_w* sample, real3w colour) {
  realw number = random_unit_w(sample_pair_w(scene, sample, USE_CHANNEL).x);
  intw hero = int_of_real_w(splat_w(R(3.0)) * number);
  maskw is_second = ~nonzero_w(hero - splat_int_w(1)), is_third = ~nonzero_w(hero - splat_int_w(2));
  return sel_w(is_third, colour.z, sel_w(is_second, colour.y, colour.x));
}

/// Something happens that lets the share `passed` of each channel's light on, and that has the density `drawn` for each
/// hero.
FN void flight_event_w(Flight_w* w, maskw which, real3w passed, real3w drawn) {
  realw zero = splat_w(R(0.0)), third = splat_w(R(1.0) / R(3.0));
  real3w densities = mul3_w(w->share, drawn);
  realw mean = ((densities.x + densities.y) + densities.z) * third;
  maskw is_possible = lt_w(zero, mean);
  realw inverse = sel_w(is_possible, splat_w(R(1.0)) / mean, zero);
  w->throughput = sel3_w(which, scale3_w(inverse, mul3_w(w->throughput, passed)), w->throughput);
  w->share = sel3_w(which & is_possible, scale3_w(inverse, densities), w->share);
}

// SPDX-License-Identifier: MIT
// Beckmann's distribution of microfacets, with exact masking for densities and B. Walter's rational one for values
// (docs/decisions/0025-microfacets.md). B. Walter and others, "Microfacet Models for Refraction through Rough
// Surfaces", EGSR 2007; E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2),
// 2014. One width; no guard.
#include "math/erf_inverse_lanes.h"
#include "math/erfc_lanes.h"

#define ONE_OVER_SQRT_PI R(0.564189583547756286948)

/// m: within the upper hemisphere.
FN realw beckmann_normals_w(const Microfacets_w* f, real3w m) {
  realw zero = splat_w(R(0.0)), x = m.x / f->alpha_u, y = m.y / f->alpha_v, z2 = m.z * m.z;
  realw e = exp_minus_w(fma_w(x, x, y * y) / z2);
  // Where the power is 0 the divisor may be 0 too.
  realw divisor = sel_w(lt_w(zero, e), f->alpha_u * f->alpha_v * (z2 * z2), splat_w(R(1.0)));
  return splat_w(ONE_OVER_PI) * e / divisor;
}

/// Both by the ratio a of the cosine to the stretched sine. 0.35 % off.
FN realw beckmann_masking_w(realw z, realw across) {
  realw one = splat_w(R(1.0)), zero = splat_w(R(0.0));
  maskw is_steep = le_w(splat_w(R(1.6)) * across, z);
  realw side = sel_w(is_steep, one, across), a = sel_w(is_steep, zero, z) / side;
  realw rational =
      fma_w(splat_w(R(2.181)), a, splat_w(R(3.535))) / fma_w(a, fma_w(splat_w(R(2.577)), a, splat_w(R(2.276))), one);
  return sel_w(is_steep, one / z, rational / side);
}

FN realw beckmann_exact_masking_w(realw z, realw across) {
  realw zero = splat_w(R(0.0)), two = splat_w(R(2.0)), far = splat_w(R(8.0));
  // Beyond a = 8 nothing is masked: e^-64 is below the roundoff.
  maskw is_masked = lt_w(z, far * across);
  realw side = sel_w(is_masked, across, splat_w(R(1.0))), a = sel_w(is_masked, z, zero) / side;
  realw hidden = exp_minus_w(a * a) * fma_w(-a, erfcx_w(a), splat_w(ONE_OVER_SQRT_PI));
  return two / fma_w(two, z, sel_w(is_masked, across * hidden, zero));
}

/// s e^(-x^2) / sqrt(pi) + c (1 + erf(x)), which grows with x up to c / s. e: e^(-x^2); tail: erfc(|x|).
FN realw beckmann_slopes_below_w(realw s, realw c, realw x, realw e, realw tail) {
  realw within = sel_w(lt_w(x, splat_w(R(0.0))), tail, splat_w(R(2.0)) - tail);
  return fma_w(s * splat_w(ONE_OVER_SQRT_PI), e, c * within);
}

/// The slope along the direction of view, of which s and c are the stretched sine and cosine: the share u of the
/// visible microfacets have a smaller one. The square root of -ln of that share is nearly linear in the slope; three
/// steps of Newton's method after a start by S. Winitzki's inverse of erf ("A Handy Approximation for the Error
/// Function and its Inverse", 2008) leave 1e-5 but for the last millionth (3e-3). At normal incidence a Gaussian.
SELDOM_FN realw beckmann_slope_w(realw s, realw c, realw u) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0)), far = splat_w(R(8.0));
  maskw is_near = lt_w(c, far * s);
  realw most = sel_w(is_near, c, far) / sel_w(is_near, s, one);
  realw e = exp_minus_w(most * most), tail = e * erfcx_w(most), root = sqrt_w(minus_log_w(u));
  realw whole = beckmann_slopes_below_w(s, c, most, e, tail), up = one - tail;
  realw down = one - u * erfcx_w(root);  // e^(-root^2) is u.
  realw guess = up - (up + one) * fma_w(one - c, down, c * (one - u));
  realw room = (one - guess) * (one + guess), least = splat_w(real_roundoff() * real_roundoff());
  realw l = -minus_log_w(sel_w(lt_w(least, room), room, least)), b = fma_w(splat_w(R(0.5)), l, splat_w(R(4.3307467)));
  realw x2 = sqrt_w(fma_w(b, b, l * splat_w(R(-6.8027211)))) - b;
  realw x = sqrt_w(sel_w(lt_w(zero, x2), x2, zero));
  x = min_w(sel_w(lt_w(guess, zero), -x, x), most);
  for (int step = 0; step < 3; ++step) {
    e = exp_minus_w(x * x);
    tail = e * erfcx_w(abs_w(x));
    realw below = beckmann_slopes_below_w(s, c, x, e, tail), share = below / whole;
    share = sel_w(lt_w(share, one), share, one);
    realw y = sqrt_w(minus_log_w(share)), rise = two * fma_w(-x, s, c) * splat_w(ONE_OVER_SQRT_PI) * e;
    realw move = two * y * (y - root) * below / sel_w(lt_w(zero, rise), rise, one);
    x = min_w(sel_w(lt_w(zero, rise), x + move, x), most);
  }
  return x;
}

/// Slopes of visible microfacets of roughness 1 along and across the direction of view. Across, a Gaussian.
FN Real2_w beckmann_visible_slopes_w(realw s, realw c, realw u, realw v) {
  Real2_w slopes;
  slopes.x = beckmann_slope_w(s, c, u);
  slopes.y = erf_inverse_w(v);
  return slopes;
}

/// Square of the slope of roughness 1 that a share u of all microfacets exceeds.
FN realw beckmann_steepness_w(realw u) { return minus_log_w(u); }

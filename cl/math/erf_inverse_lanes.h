// SPDX-License-Identifier: MIT
// The inverse of the error function: M. Giles, "Approximating the erfinv function", GPU Computing Gems Jade Edition,
// 2012, in its single-precision form. Off by 3e-7 of the result down to a share of 1e-7 on either side, by 1e-4 at
// 1e-9. Needs math/exp_log_lanes.h. One width; no guard.

/// x with (1 + erf(x)) / 2 = share, within (0, 1).
FN realw erf_inverse_w(realw share) {
  realw one = splat_w(R(1.0)), w = minus_log_w(splat_w(R(4.0)) * share * (one - share));
  realw a = w - splat_w(R(2.5)), b = sqrt_w(w) - splat_w(R(3.0));
  realw p = fma_w(a, splat_w(R(2.81022636e-8)), splat_w(R(3.43273939e-7)));
  p = fma_w(a, p, splat_w(R(-3.5233877e-6)));
  p = fma_w(a, p, splat_w(R(-4.39150654e-6)));
  p = fma_w(a, p, splat_w(R(0.00021858087)));
  p = fma_w(a, p, splat_w(R(-0.00125372503)));
  p = fma_w(a, p, splat_w(R(-0.00417768164)));
  p = fma_w(a, p, splat_w(R(0.246640727)));
  p = fma_w(a, p, splat_w(R(1.50140941)));
  realw far = fma_w(b, splat_w(R(-0.000200214257)), splat_w(R(0.000100950558)));
  far = fma_w(b, far, splat_w(R(0.00134934322)));
  far = fma_w(b, far, splat_w(R(-0.00367342844)));
  far = fma_w(b, far, splat_w(R(0.00573950773)));
  far = fma_w(b, far, splat_w(R(-0.0076224613)));
  far = fma_w(b, far, splat_w(R(0.00943887047)));
  far = fma_w(b, far, splat_w(R(1.00167406)));
  far = fma_w(b, far, splat_w(R(2.83297682)));
  return sel_w(lt_w(w, splat_w(R(5.0))), p, far) * (share - (one - share));
}

// SPDX-License-Identifier: MIT
// The complementary error function, scaled: erfcx(a) = e^(a^2) erfc(a), which falls from 1 like 1 / (a sqrt(pi)) and so
// neither underflows nor cancels. (1 + 2 a) erfcx(a) is a polynomial in (a - k) / (a + k): M. Shepherd, J. Laframboise,
// "Chebyshev Approximation of (1 + 2x) exp(x^2) erfc x in 0 <= x < infinity", Mathematics of Computation 36(153), 1981.
// Bound in ulps of the result: 6 (worst seen 5.1), held by tests/cl/test_exp_log.cpp against MPFR. One width; no
// guard.

/// For a >= 0, infinity excluded.
FN realw erfcx_w(realw a) {
  realw one = splat_w(R(1.0)), k = splat_w(R(3.75)), t = (a - k) / (a + k);
#if REAL_BITS == 64
  realw p = fma_w(t, splat_w(R(-0x1.4e14d07a8416dp-35)), splat_w(R(0x1.d28e6270e10c9p-32)));
  p = fma_w(t, p, splat_w(R(0x1.2d8bb3ae3b809p-31)));
  p = fma_w(t, p, splat_w(R(-0x1.63376daa748f8p-28)));
  p = fma_w(t, p, splat_w(R(-0x1.2e2777e7e9c1ap-28)));
  p = fma_w(t, p, splat_w(R(0x1.4c1b8fe94af13p-25)));
  p = fma_w(t, p, splat_w(R(0x1.a1809ecfcbfe0p-26)));
  p = fma_w(t, p, splat_w(R(-0x1.15b8e4af3e51ap-22)));
  p = fma_w(t, p, splat_w(R(-0x1.f4941f05a731dp-25)));
  p = fma_w(t, p, splat_w(R(0x1.d63256489b33bp-20)));
  p = fma_w(t, p, splat_w(R(-0x1.052525efa669bp-20)));
  p = fma_w(t, p, splat_w(R(-0x1.80005da99b005p-17)));
  p = fma_w(t, p, splat_w(R(0x1.778a276cd97c4p-16)));
  p = fma_w(t, p, splat_w(R(0x1.b14395a551aeep-15)));
  p = fma_w(t, p, splat_w(R(-0x1.303f9d8ceda2dp-12)));
  p = fma_w(t, p, splat_w(R(0x1.33fb298161868p-12)));
  p = fma_w(t, p, splat_w(R(0x1.cc3a0e2212f44p-10)));
  p = fma_w(t, p, splat_w(R(-0x1.3f603c39af06fp-7)));
  p = fma_w(t, p, splat_w(R(0x1.d0b0037dcc906p-6)));
  p = fma_w(t, p, splat_w(R(-0x1.e0d0fa6ddf01ap-5)));
  p = fma_w(t, p, splat_w(R(0x1.7a14188a99b30p-4)));
  p = fma_w(t, p, splat_w(R(-0x1.bda9309a294fdp-4)));
  p = fma_w(t, p, splat_w(R(0x1.510169d096803p-4)));
  p = fma_w(t, p, splat_w(R(0x1.d5f294815a448p-9)));
  p = fma_w(t, p, splat_w(R(-0x1.1f367683f89a7p-3)));
  p = fma_w(t, p, splat_w(R(0x1.3ccda0b5d5dc2p+0)));
#else
  realw p = fma_w(t, splat_w(R(-0x1.dfb7bcp-13)), splat_w(R(0x1.9ff998p-12)));
  p = fma_w(t, p, splat_w(R(0x1.baac34p-10)));
  p = fma_w(t, p, splat_w(R(-0x1.429df8p-7)));
  p = fma_w(t, p, splat_w(R(0x1.d13f7ap-6)));
  p = fma_w(t, p, splat_w(R(-0x1.e06d8ap-5)));
  p = fma_w(t, p, splat_w(R(0x1.7a0bc2p-4)));
  p = fma_w(t, p, splat_w(R(-0x1.bdb45cp-4)));
  p = fma_w(t, p, splat_w(R(0x1.510220p-4)));
  p = fma_w(t, p, splat_w(R(0x1.d6109ap-9)));
  p = fma_w(t, p, splat_w(R(-0x1.1f3678p-3)));
  p = fma_w(t, p, splat_w(R(0x1.3ccda0p+0)));
#endif
  return p / fma_w(splat_w(R(2.0)), a, one);
}

// SPDX-License-Identifier: MIT
// LANES 8 and 16 on the host: the compiler's vector extension (g++ and clang, -Wno-psabi). Included by lane_ops.h.
typedef real realw __attribute__((vector_size(LANES * sizeof(real))));
typedef int intw __attribute__((vector_size(LANES * sizeof(int))));
typedef decltype(realw{} < realw{}) maskw;
#define LANE_AS_MASK(a) ((maskw)(a))
#define LANE_AS_REAL(m) ((realw)(m))
#define LANE_TO_MASK(i) __builtin_convertvector(i, maskw)
#define LANE_TO_INT(m) __builtin_convertvector(m, intw)
#define LANE_TO_REAL(m) __builtin_convertvector(m, realw)
#define LANE_SPLAT_MASK(x) ((decltype(maskw{}[0] + 0))(x)-maskw{})

// x - (+0) keeps -0; x + 0 would not.
FN realw splat_w(real x) { return x - realw{}; }
FN intw splat_int_w(int x) { return x - intw{}; }
FN maskw lt_w(realw a, realw b) { return a < b; }
FN maskw le_w(realw a, realw b) { return a <= b; }
FN maskw eq_w(realw a, realw b) { return a == b; }
FN realw sel_w(maskw m, realw a, realw b) { return m ? a : b; }
FN maskw nonzero_w(intw i) { return __builtin_convertvector(i != intw{}, maskw); }
FN realw fma_w(realw a, realw b, realw c) {
  for (int i = 0; i < LANES; ++i) a[i] = std::fma(a[i], b[i], c[i]);
  return a;
}
FN realw sqrt_w(realw a) {
  for (int i = 0; i < LANES; ++i) a[i] = std::sqrt(a[i]);
  return a;
}
FN realw abs_w(realw a) { return (realw)((maskw)a & ~(maskw)splat_w(-R(0.0))); }
FN realw floor_w(realw a) {
  for (int i = 0; i < LANES; ++i) a[i] = std::floor(a[i]);
  return a;
}
FN uint bits_w(maskw m) {
  uint bits = 0u;
  for (int i = 0; i < LANES; ++i) bits |= (uint)(m[i] & 1) << i;
  return bits;
}
FN int any_w(maskw m) { return bits_w(m) != 0u; }
FN realw load_w(GLOBAL const real* p) {
  realw a;
  std::memcpy(&a, p, sizeof a);
  return a;
}
FN intw load_int_w(GLOBAL const int* p) {
  intw a;
  std::memcpy(&a, p, sizeof a);
  return a;
}
FN void store_w(realw a, PRIVATE real* p) { std::memcpy(p, &a, sizeof a); }
FN void write_w(realw a, GLOBAL real* p) { std::memcpy(p, &a, sizeof a); }
FN void write_int_w(intw a, GLOBAL int* p) { std::memcpy(p, &a, sizeof a); }

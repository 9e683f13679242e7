// SPDX-License-Identifier: MIT
// Owen-scrambled Sobol points, two dimensions a set, sets decorrelated by shuffling: B. Burley, "Practical Hash-based
// Owen Scrambling", JCGT 9(4), 2020, with the hash of N. Vegdahl, "Building a Better LK Hash", 2021.
//
// SOBOL_SEQUENCES sequences, scrambled independently, are interleaved by the sample's number, so that each gives an
// independent estimate of the same picture. Where the film keeps one sum there is one sequence, which is longer and
// therefore more even. Each is a (0, 2)-sequence in every set: of its first 2^m points one lies in every elementary
// interval of area 2^-m (tests/cl/test_samplers.cpp). Every pixel, set and sequence has its own scramble. One width; no
// guard.

FN uintw reversed_bits_w(uintw x) {
  x = (x >> 16) | (x << 16);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Flips each bit by a hash of the bits below it: Owen's scrambling of a number whose bits are reversed.
FN uintw scrambled_reverse_w(uintw x, uintw seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  return x ^ x * 0x53a22864u;
}

/// The second dimension's bits in reverse: Pascal's triangle modulo 2, applied to the index in five steps.
FN uintw sobol_second_reversed_w(uintw index) {
  index ^= (index & 0xaaaaaaaau) >> 1;
  index ^= (index & 0xccccccccu) >> 2;
  index ^= (index & 0xf0f0f0f0u) >> 4;
  index ^= (index & 0xff00ff00u) >> 8;
  return index ^ index >> 16;
}

FN void sobol_begin_w(SampleState_w* state) {
  uintw number = state->sequences == 1u ? state->sample : state->sample / (uint)SOBOL_SEQUENCES;
  state->reversed = reversed_bits_w(number);
  state->key = random4_w(state->pixel, state->sample & (state->sequences - 1u), splat_uint_w(0u), state->seed).x;
}

/// A hash of 32 bits: C. Wellons, "Prospecting for Hash Functions", 2018.
FN uintw mixed_bits_w(uintw x) {
  x = (x ^ x >> 16) * 0x7feb352du;
  x = (x ^ x >> 15) * 0x846ca68bu;
  return x ^ x >> 16;
}

FN Random2_w sobol_pair_w(const SampleState_w* state, uintw set) {
  uintw seed = mixed_bits_w(state->key + set * 0x9e3779b9u);
  // The first dimension is the index in reverse, so the index's bits in reverse are that dimension's in order.
  uintw index = reversed_bits_w(scrambled_reverse_w(state->reversed, seed));
  Random2_w pair;
  pair.x = reversed_bits_w(scrambled_reverse_w(index, mixed_bits_w(seed ^ 0x55555555u)));
  pair.y = reversed_bits_w(scrambled_reverse_w(sobol_second_reversed_w(index), mixed_bits_w(seed ^ 0xaaaaaaaau)));
  return pair;
}

// SPDX-License-Identifier: MIT
// A sum of numbers that does not depend on their order: two integers at fixed powers of two, on the device as on the
// host. J. Demmel, H. D. Nguyen, "Parallel Reproducible Summation", IEEE Transactions on Computers 64(7), 2015.
//
// The powers of two are divided into bins of FILM_BIN_BITS bits, the same ones for every sum. A number is cut at their
// borders; a sum keeps the pieces in the bin of its largest number (its top) and in the bin below, each added up in a
// word of its own without carries. A larger number moves the top up. The pieces that this drops would have been dropped
// in any order, so the words depend on the set of numbers alone (docs/decisions/0002-film.md, tests/cl/test_film.cpp).
//
// A word is 4 x (sum of pieces) + two bits of the top; 0 is an empty sum. 2^21 pieces below 2^40 leave just these bits.
// Needs FN, GLOBAL and a long of 64 bits: the host includes it by itself (render/film_sum.h).
#ifndef STRAHL_FILM_FILM_SUM_H
#define STRAHL_FILM_FILM_SUM_H

/// FILM_ORIGIN: bin 1 begins at 2^-FILM_ORIGIN, below the smallest float; bin 8 ends at 2^140, above the largest. Bins
/// meet at 2^-20 and 2^20, far from what most pictures show: FILM_USUAL_TOP. Between the other two tops numbers can be
/// cut in floating point (film/film.h).
enum { FILM_BIN_BITS = 40, FILM_ORIGIN = 180, FILM_LEAST_TOP = 4, FILM_USUAL_TOP = 5, FILM_MOST_TOP = 7 };

/// Pieces in bin `top` and in the one below, in units of 2^((top - 1) 40 - 180) and 2^((top - 2) 40 - 180). top 0:
/// nothing.
typedef struct {
  int top;
  long high, low;
} FilmBins;

/// What two words hold.
FN FilmBins film_bins(long high_word, long low_word) {
  FilmBins bins;
  bins.top = (int)(high_word & 3) << 2 | (int)(low_word & 3);
  bins.high = high_word >> 2;
  bins.low = low_word >> 2;
  return bins;
}

/// Adds a number, or another sum, to the sum in two words.
FN void film_add(GLOBAL long* sum, FilmBins more) {
  long high = sum[0], low = sum[1];
  int top = (int)(high & 3) << 2 | (int)(low & 3);
  if (more.top == top) {
    sum[0] = high + more.high * 4;
    sum[1] = low + more.low * 4;
  } else if (more.top < top) {
    if (more.top == top - 1) sum[1] = low + more.high * 4;
  } else {
    sum[0] = more.high * 4 + (more.top >> 2);
    sum[1] = ((top == more.top - 1 ? high >> 2 : 0) + more.low) * 4 + (more.top & 3);
  }
}

#endif

// SPDX-License-Identifier: MIT
// Which of a pixel's sub-sums a sample goes to (docs/decisions/0011-error.md). Samples take turns among the sequences;
// a sequence's points go in turns of 2^turn_bits to the sums that are its own. So `independent` has a sum for each of
// its FILM_SUBSUMS sequences, `sobol` two for each of two: the sequence's halves, where the number of samples is known.
//
// Needs FN: the host includes it by itself (render/sub_sums.h).
#ifndef STRAHL_FILM_SUB_SUMS_H
#define STRAHL_FILM_SUB_SUMS_H

/// `count` is one or two times `sequences`.
typedef struct {
  int count;      ///< Sums of a pixel, FILM_SUBSUMS at most.
  int sequences;  ///< Independent sequences, 1, 2 or 4, interleaved by the sample's number.
  int turn_bits;  ///< 2^turn_bits points of a sequence in a row are in the same sum.
} SubSums;

/// The logarithm of their number to base 2.
FN int sequence_bits(SubSums sums) { return sums.sequences >> 1; }

/// Sum `sequence + sequences * turn`.
FN int sub_sum_of(SubSums sums, int sample) {
  int sequence = sample & (sums.sequences - 1), point = sample >> sequence_bits(sums);
  int turn = sums.count > sums.sequences ? point >> sums.turn_bits & 1 : 0;
  return sequence + sums.sequences * turn;
}

/// Samples in that sum among the first `samples`.
FN int sub_sum_size(SubSums sums, int sub, int samples) {
  int sequence = sub & (sums.sequences - 1);
  int points = (samples - sequence + sums.sequences - 1) / sums.sequences;
  if (sums.count == sums.sequences) return points;
  int length = 1 << sums.turn_bits, rest = points & (2 * length - 1);
  int first = (points - rest) / 2 + (rest < length ? rest : length);
  return sub < sums.sequences ? first : points - first;
}

#endif

// SPDX-License-Identifier: MIT
// The error of one scrambled sequence, told from the spread of its own blocks (docs/decisions/0011-error.md).
//
// Blocks [a 2^l, (a + 1) 2^l) of an Owen-scrambled sequence are exchangeable, so the covariance of two samples depends
// on the smallest such block alone that holds both. Haar's functions of the sample's number are then uncorrelated, with
// a variance g_l for each level l; g is flat for independent samples and falls where the sequence is even. The variance
// of *any* weighted sum of samples is a sum of its energies at the levels times g. Contrasts of the film's blocks show
// g at the levels that are seen; the mean of 2^L samples has the sum of g_(L + k) / 2^(k + 1), k = 0, 1, ...: of levels
// that nobody has seen. The law that leads there: g is a mixture of 1 (what the sequence does not help), of edges,
// which fall by about 0.7 a level, and of what is smooth. A mixture stays one when pixels are added up.
#pragma once

#include <array>
#include <vector>

namespace strahl {

/// Samples [first, end) with that weight each.
struct WeightedSamples {
  int first = 0, end = 0;
  double weight = 0;
};

/// Energies of a weighted sum of samples of [0, 2^levels): its squared norm, by level.
struct Energies {
  std::vector<double> level;  ///< Of Haar's functions that differ from block to block of 2^l samples.
  double constant = 0;        ///< Of the function that is the same for all.
};
[[nodiscard]] Energies energies_of(const std::vector<WeightedSamples>& weights, int levels);

/// Contrasts of the blocks, averages over the pixels. Each contrast has the norm 1: independent samples make all
/// `squares` alike.
struct BlockSpread {
  static constexpr int contrasts = 3;
  std::array<double, contrasts> squares{};   ///< Summed over the channels.
  std::array<Energies, contrasts> energies;  ///< No levels: nobody has measured it.
  Energies mean;                             ///< Of the pixels' means.
  /// Variance of one of `squares`, relative to its square, were the blocks normally distributed.
  double relative_variance = 0;
};

/// The logarithm of a pixel's squared error, summed over the channels, and the variance of what that is off by, without
/// what the realised error itself varies by.
struct SequenceError {
  double log_square = 0;
  double variance = 0;
};

/// Posterior mean and variance over the mixtures of the law. At least one of the squares is above 0.
[[nodiscard]] SequenceError sequence_error(const BlockSpread& spread);

}  // namespace strahl

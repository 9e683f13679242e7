// SPDX-License-Identifier: MIT
#include "render/block_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace strahl {
namespace {

/// What g falls by a level, of the parts that are mixed. Edges tend to 2^-0.5 in a (0, 2)-sequence, a little faster
/// while blocks are few; smooth integrands to 1/4.
constexpr std::array ratios{1.0, 0.75, 0.6, 0.3};
/// How much less likely a picture is for every unit of its share that is smooth: few pictures are without an edge.
constexpr double smooth_is_rare = 3;
constexpr int steps = 20;  ///< Shares are multiples of 1 / steps.
/// How far g is off the law, as standard deviations of its logarithm. At level l: off_the_law / l. What follows L
/// levels: off_the_future, and off_the_start / L^3, since features of a pixel that few samples have not resolved yet
/// make g fall later and faster. Measured on renders (docs/decisions/0011-error.md).
constexpr double off_the_law = 0.15, off_the_future = 0.1, off_the_start = 20;
constexpr double most_off = 0.6;

using Shares = std::array<double, ratios.size()>;

/// Adds the energies of aligned blocks from 2^level samples on down; returns the sum of the block's weights.
double descend(const std::vector<WeightedSamples>& weights, int level, int first, std::vector<double>& energies) {
  const int end = first + (1 << level);
  double sum = 0;
  bool is_constant = true;
  for (const WeightedSamples& piece : weights) {
    const int a = std::max(first, piece.first), b = std::min(end, piece.end);
    if (a >= b) continue;
    sum += piece.weight * (b - a);
    is_constant = is_constant && a == first && b == end;
  }
  if (is_constant || level == 0) return sum;
  const int below = level - 1;
  const double one = descend(weights, below, first, energies);
  const double other = descend(weights, below, first + (1 << below), energies);
  energies[static_cast<std::size_t>(below)] += (one - other) * (one - other) / (1 << level);
  return sum;
}

/// Energies times g, which is 1 at the highest level; each part of the mixture by itself.
Shares seen_through(const Energies& energies) {
  Shares seen{};
  const int levels = static_cast<int>(energies.level.size());
  for (std::size_t part = 0; part < ratios.size(); ++part) {
    const double ratio = ratios[part];
    for (int l = 0; l < levels; ++l)
      seen[part] += energies.level[static_cast<std::size_t>(l)] * std::pow(ratio, l - (levels - 1));
    seen[part] += energies.constant * ratio / (2 - ratio);  // g_(L + k) / 2^(k + 1), summed.
  }
  return seen;
}

double mixed(const Shares& shares, const Shares& seen) {
  double sum = 0;
  for (std::size_t part = 0; part < shares.size(); ++part) sum += shares[part] * seen[part];
  return sum;
}

/// Standard deviation of the logarithm of what a contrast sees, since g is not quite the law.
double discrepancy(const Energies& energies) {
  double sum = 0;
  for (std::size_t l = 0; l < energies.level.size(); ++l)
    sum += energies.level[l] * std::min(most_off, off_the_law / std::max(0.7, static_cast<double>(l)));
  return sum;
}

struct Contrast {
  double square = 0;
  double freedom = 0;  ///< Degrees of freedom of a chi-squared distribution.
  Shares seen{};
};

struct Hypothesis {
  double log_likelihood = 0;
  double log_square = 0;
};

/// The mixture's amplitude is the one that fits best.
Hypothesis judged(const Shares& shares, const std::vector<Contrast>& contrasts, const Shares& mean) {
  double amplitude = 0, freedom = 0;
  for (const Contrast& contrast : contrasts) {
    amplitude += contrast.freedom * contrast.square / mixed(shares, contrast.seen);
    freedom += contrast.freedom;
  }
  amplitude /= freedom;
  Hypothesis result;
  for (const Contrast& contrast : contrasts) {
    const double expected = amplitude * mixed(shares, contrast.seen);
    result.log_likelihood -= contrast.freedom / 2 * (std::log(expected) + contrast.square / expected);
  }
  result.log_likelihood -= smooth_is_rare * shares.back();
  result.log_square = std::log(amplitude * mixed(shares, mean));
  return result;
}

std::vector<Shares> all_mixtures() {
  std::vector<Shares> all;
  for (int a = 0; a <= steps; ++a)
    for (int b = 0; a + b <= steps; ++b)
      for (int c = 0; a + b + c <= steps; ++c) {
        const double unit = 1.0 / steps;
        all.push_back({(steps - a - b - c) * unit, a * unit, b * unit, c * unit});
      }
  return all;
}

}  // namespace

Energies energies_of(const std::vector<WeightedSamples>& weights, int levels) {
  Energies energies;
  energies.level.resize(static_cast<std::size_t>(levels), 0.0);
  const double sum = descend(weights, levels, 0, energies.level);
  energies.constant = sum * sum / (1 << levels);
  return energies;
}

SequenceError sequence_error(const BlockSpread& spread) {
  std::vector<Contrast> contrasts;
  double freedom = 0;
  for (std::size_t k = 0; k < spread.squares.size(); ++k) {
    if (spread.energies[k].level.empty()) continue;
    const double off = discrepancy(spread.energies[k]);
    contrasts.push_back(
        {spread.squares[k], 2 / (spread.relative_variance + off * off), seen_through(spread.energies[k])});
    freedom += contrasts.back().freedom;
  }
  const Shares mean = seen_through(spread.mean);
  static const std::vector<Shares> mixtures = all_mixtures();
  std::vector<Hypothesis> judgements;
  judgements.reserve(mixtures.size());
  double best = -HUGE_VAL;
  for (const Shares& shares : mixtures) {
    judgements.push_back(judged(shares, contrasts, mean));
    best = std::max(best, judgements.back().log_likelihood);
  }
  double weights = 0, sum = 0, squares = 0;
  for (const Hypothesis& hypothesis : judgements) {
    const double weight = std::exp(hypothesis.log_likelihood - best);
    weights += weight;
    sum += weight * hypothesis.log_square;
    squares += weight * hypothesis.log_square * hypothesis.log_square;
  }
  const double average = sum / weights;
  const double levels = std::max(1.0, static_cast<double>(spread.mean.level.size()));
  const double future = std::hypot(off_the_future, off_the_start / (levels * levels * levels));
  return {average, std::max(0.0, squares / weights - average * average) + 2 / freedom + future * future};
}

}  // namespace strahl

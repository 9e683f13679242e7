// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "render/error_law.h"
#include "render/film.h"
#include "render/shared_noise.h"

namespace strahl {
namespace {

constexpr int turns = layout::FILM_SUBSUMS;
static_assert(turns == 4, "disjoint_pairs are those of four");
constexpr double to_difference = 2.0 * turns / (turns - 1);  ///< From squared covariances of one sample.
constexpr int disjoint_pairs[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};

/// A pixel's four means, their weights, and the weight of all.
struct Turns {
  std::array<Colour, turns> part{};
  SubSumWeights weight{};
  double total = 0;
  PixelError error;
};

/// A sum without weight says nothing, as in the limit: it adds nothing to the spread, and no pair with it to the
/// variance.
Turns turns_of(const FilmRows& film, std::size_t at, const SubSumWeights& weights) {
  const SubSumColours sums = film.sub_sums(at);
  Turns pixel{{}, weights, std::accumulate(weights.begin(), weights.end(), 0.0), {}};
  if (!(pixel.total > 0)) return pixel;
  for (int k = 0; k < turns; ++k)
    for (int c = 0; c < layout::FILM_CHANNELS; ++c) {
      const double sum = sums[k][c];
      if (weights[k] > 0) pixel.part[k][c] = sum / weights[k];
      pixel.error.mean[c] += sum / pixel.total;
    }
  for (int c = 0; c < layout::FILM_CHANNELS; ++c) {
    double spread = 0;
    for (int k = 0; k < turns; ++k) {
      const double deviation = pixel.part[k][c] - pixel.error.mean[c];
      spread += weights[k] * deviation * deviation;
    }
    pixel.error.squared[c] = spread / ((turns - 1) * pixel.total);
  }
  return pixel;
}

/// Of the differences of two pairs of sums each.
using PairProducts = std::array<double, std::size(disjoint_pairs)>;

PairProducts products_of(const Turns& pixel) {
  PairProducts products{};
  for (std::size_t k = 0; k < products.size(); ++k)
    for (int c = 0; c < layout::FILM_CHANNELS; ++c) {
      const auto difference = [&](int a, int b) { return pixel.part[a][c] - pixel.part[b][c]; };
      const auto& pairs = disjoint_pairs[k];
      products[k] += difference(pairs[0], pairs[1]) * difference(pairs[2], pairs[3]);
    }
  return products;
}

double difference_variance(const Turns& pixel, const PairProducts& products) {
  if (!(pixel.total > 0)) return 0;
  // Of one sample: sum over pairs of channels of the squared covariance.
  double covariance = 0;
  for (std::size_t k = 0; k < products.size(); ++k) {
    const auto& pairs = disjoint_pairs[k];
    covariance += products[k] * products[k] /
                  ((1 / pixel.weight[pairs[0]] + 1 / pixel.weight[pairs[1]]) *
                   (1 / pixel.weight[pairs[2]] + 1 / pixel.weight[pairs[3]])) /
                  3;
  }
  return to_difference / (pixel.total * pixel.total) * covariance;
}

/// The squared error over all channels, whose square overestimates what the difference's variance is made of.
double squared_error(const Turns& pixel) {
  double sum = 0;
  for (const double squared : pixel.error.squared) sum += squared;
  return sum;
}

class LawOfTurns final : public ErrorLaw {
 public:
  explicit LawOfTurns(const FilmShape& film) : overlap_(film.noise_overlap), bands_(band_of(film.height - 1) + 1) {}

  void add(const FilmRows& rows, int first) override {
    WeightsOfSamples weights;
    SharedNoiseRows<std::size(disjoint_pairs)> shared(static_cast<std::size_t>(rows.width));
    each_pixel(rows, first, [&](std::size_t at, std::size_t x, std::optional<std::size_t> band_number) {
      const Turns pixel = turns_of(rows, at, weights.of(rows, at));
      const PairProducts products = products_of(pixel);
      const SharedNoise noise = shared.add(x, products);
      if (!band_number) return;
      Band& band = bands_[*band_number];
      band.shared += noise;
      const double variance = difference_variance(pixel, products);
      band.picture.add(pixel.error);
      band.picture.variance += variance;
      band.squares += variance * variance;
      band.most = std::max(band.most, squared_error(pixel));
    });
  }
  PixelError pixel_error(const FilmRows& rows, std::size_t at) const override {
    return turns_of(rows, at, rows.sub_sum_weights(at)).error;
  }
  PictureError tell() const override {
    PictureError picture;
    double squares = 0, most = 0;
    SharedNoise shared;
    for (const Band& band : bands_) {
      picture += band.picture;
      shared += band.shared;
      squares += band.squares;
      most = std::max(most, band.most);
    }
    picture.freedom = satterthwaite(picture.variance, squares);
    picture.variance *= shared.overlap(overlap_);
    // By the pixel that has most of the noise alone (error_of_sequences.cpp), times its whole share: the four sums'
    // spread says less than three differences of sequences.
    if (picture.squared > 0) picture.variance += to_difference * std::pow(most, 3) / picture.squared;
    return picture;
  }

 private:
  struct Band {
    PictureError picture;
    double squares = 0, most = 0;
    SharedNoise shared;
  };
  double overlap_;
  std::vector<Band> bands_;
};

}  // namespace

std::unique_ptr<ErrorLaw> law_of_turns(const FilmShape& film) { return std::make_unique<LawOfTurns>(film); }

}  // namespace strahl

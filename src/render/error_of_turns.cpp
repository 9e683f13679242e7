// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/error_law.h"
#include "render/film.h"

namespace strahl {
namespace {

constexpr int turns = layout::FILM_SUBSUMS;
static_assert(turns == 4, "disjoint_pairs are those of four");
constexpr double to_difference = 2.0 * turns / (turns - 1);  ///< From squared covariances of one sample.
constexpr int disjoint_pairs[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};

/// A pixel's four means and the number of samples in each.
struct Turns {
  std::array<Colour, turns> part{};
  std::array<double, turns> count{};
  PixelError error;
};

Turns turns_of(const FilmRows& film, std::size_t at, const SubSumCounts& counts) {
  const int samples = film.samples[at];
  const SubSumColours sums = film.sub_sums(at);
  Turns pixel;
  for (int k = 0; k < turns; ++k) {
    pixel.count[k] = counts[k];
    for (int c = 0; c < layout::FILM_CHANNELS; ++c) {
      const double sum = sums[k][c];
      pixel.part[k][c] = sum / pixel.count[k];
      pixel.error.mean[c] += sum / samples;
    }
  }
  for (int c = 0; c < layout::FILM_CHANNELS; ++c) {
    double spread = 0;
    for (int k = 0; k < turns; ++k) {
      const double deviation = pixel.part[k][c] - pixel.error.mean[c];
      spread += pixel.count[k] * deviation * deviation;
    }
    pixel.error.squared[c] = spread / ((turns - 1) * static_cast<double>(samples));
  }
  return pixel;
}

double difference_variance(const Turns& pixel, double samples) {
  // Of one sample: sum over pairs of channels of the squared covariance.
  double covariance = 0;
  for (const auto& pairs : disjoint_pairs) {
    double product = 0;
    for (int c = 0; c < layout::FILM_CHANNELS; ++c)
      product +=
          (pixel.part[pairs[0]][c] - pixel.part[pairs[1]][c]) * (pixel.part[pairs[2]][c] - pixel.part[pairs[3]][c]);
    covariance += product * product /
                  ((1 / pixel.count[pairs[0]] + 1 / pixel.count[pairs[1]]) *
                   (1 / pixel.count[pairs[2]] + 1 / pixel.count[pairs[3]])) /
                  3;
  }
  return to_difference / (samples * samples) * covariance;
}

/// The squared error over all channels, whose square overestimates what the difference's variance is made of.
double squared_error(const Turns& pixel) {
  double sum = 0;
  for (const double squared : pixel.error.squared) sum += squared;
  return sum;
}

class LawOfTurns final : public ErrorLaw {
 public:
  explicit LawOfTurns(int height) : bands_(band_of(height - 1) + 1) {}

  void add(const FilmRows& rows, int first) override {
    CountsOfSamples counts;
    each_pixel(rows, first, [&](std::size_t at, std::size_t band_number) {
      Band& band = bands_[band_number];
      const Turns pixel = turns_of(rows, at, counts.of(rows, at));
      const double variance = difference_variance(pixel, rows.samples[at]);
      band.picture.add(pixel.error);
      band.picture.variance += variance;
      band.squares += variance * variance;
      band.most = std::max(band.most, squared_error(pixel));
    });
  }
  PixelError pixel_error(const FilmRows& rows, std::size_t at) const override {
    return turns_of(rows, at, rows.sub_sum_counts(rows.samples[at])).error;
  }
  PictureError tell() const override {
    PictureError picture;
    double squares = 0, most = 0;
    for (const Band& band : bands_) {
      picture += band.picture;
      squares += band.squares;
      most = std::max(most, band.most);
    }
    picture.freedom = satterthwaite(picture.variance, squares);
    // By the pixel that has most of the noise alone (error_of_sequences.cpp), times its whole share: the four sums'
    // spread says less than three differences of sequences.
    if (picture.squared > 0) picture.variance += to_difference * std::pow(most, 3) / picture.squared;
    return picture;
  }

 private:
  struct Band {
    PictureError picture;
    double squares = 0, most = 0;
  };
  std::vector<Band> bands_;
};

}  // namespace

std::unique_ptr<ErrorLaw> law_of_turns(int height) { return std::make_unique<LawOfTurns>(height); }

}  // namespace strahl

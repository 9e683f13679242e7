// SPDX-License-Identifier: MIT
// The error of a picture from independent replicates of it. With D the replicates' deviations from their mean, each
// times the root of its number of paths, the products of deviations G = D D^T say all: the trace is the squared error,
// and what G differs from a multiple of the identity on the replicates' differences says how much the realised error
// may differ from it. For normal deviations of covariance S that difference has the squared norm 2 f tr(S^2), with f =
// (R - 1) R / 2 - 1 degrees of freedom; rare bright splats only enlarge it (docs/decisions/0032-light-tracing.md).
#include <cmath>
#include <vector>

#include "render/error_law.h"
#include "render/film.h"

namespace strahl {
namespace {

constexpr int replicates = layout::FILM_SUBSUMS;

using Deviations = std::array<Colour, replicates>;

struct Replicated {
  Deviations deviation{};  ///< Times the root of the replicate's size.
  PixelError error;
};

Replicated replicated_at(const FilmRows& film, const std::vector<double>& sizes, std::size_t at,
                         const SubSumWeights& weights) {
  const SubSumColours sums = film.sub_sums(at);
  Replicated pixel;
  double samples = 0;
  for (const double size : sizes) samples += size;
  for (int c = 0; c < layout::FILM_CHANNELS; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    std::array<double, replicates> mean{};
    for (std::size_t k = 0; k < replicates; ++k) {
      const double sum = sums[k][channel], own = film.own_sum(at, static_cast<int>(k), c);
      pixel.error.mean[channel] += sum / samples;
      mean[k] = sum / sizes[k];
      if (film.samples[at] > 0) pixel.error.mean[channel] += own / film.samples[at];
      if (weights[k] > 0) mean[k] += own / weights[k];
    }
    double spread = 0;
    for (std::size_t k = 0; k < replicates; ++k) {
      const double deviation = std::sqrt(sizes[k]) * (mean[k] - pixel.error.mean[channel]);
      pixel.deviation[k][channel] = deviation;
      spread += deviation * deviation;
    }
    pixel.error.squared[channel] = spread / ((replicates - 1) * samples);
  }
  return pixel;
}

/// Paths of a pixel on average, in each replicate.
std::vector<double> replicate_sizes(const FilmSums& film) {
  std::vector<double> sizes(replicates, 0.0);
  const FilmRows rows = film.rows();
  const auto pixels = static_cast<double>(film.samples.size());
  WeightsOfSamples weights;
  for (std::size_t at = 0; at < film.samples.size(); ++at)
    for (std::size_t k = 0; k < replicates; ++k) sizes[k] += weights.of(rows, at)[k] / pixels;
  return sizes;
}

class LawOfReplicates final : public ErrorLaw {
 public:
  explicit LawOfReplicates(const FilmSums& film)
      : sizes_(replicate_sizes(film)), bands_(band_of(film.height - 1) + 1) {}

  void add(const FilmRows& rows, int first) override {
    WeightsOfSamples weights;
    each_pixel(rows, first, [&](std::size_t at, std::size_t, std::optional<std::size_t> band_number) {
      if (!band_number) return;
      Band& band = bands_[*band_number];
      const Replicated pixel = replicated_at(rows, sizes_, at, weights.of(rows, at));
      band.picture.add(pixel.error);
      for (std::size_t i = 0; i < replicates; ++i)
        for (std::size_t j = 0; j < replicates; ++j)
          for (std::size_t c = 0; c < layout::FILM_CHANNELS; ++c)
            band.products[i][j] += pixel.deviation[i][c] * pixel.deviation[j][c];
    });
  }
  PixelError pixel_error(const FilmRows& rows, std::size_t at) const override {
    return replicated_at(rows, sizes_, at, rows.sub_sum_weights(at)).error;
  }
  PictureError tell() const override {
    PictureError picture;
    Products products{};
    for (const Band& band : bands_) {
      picture += band.picture;
      for (std::size_t i = 0; i < replicates; ++i)
        for (std::size_t j = 0; j < replicates; ++j) products[i][j] += band.products[i][j];
    }
    double trace = 0, norm = 0, samples = 0;
    for (std::size_t i = 0; i < replicates; ++i) {
      trace += products[i][i];
      samples += sizes_[i];
      for (std::size_t j = 0; j < replicates; ++j) norm += products[i][j] * products[i][j];
    }
    constexpr double between = replicates - 1, freedom = between * replicates / 2 - 1;
    const double squares = std::max(0.0, norm - trace * trace / between) / (2 * freedom);  // tr(S^2) of one path
    picture.variance = 2 * replicates / (between * samples * samples) * squares;
    picture.freedom = freedom;
    return picture;
  }

 private:
  using Products = std::array<std::array<double, replicates>, replicates>;
  struct Band {
    PictureError picture;
    Products products{};
  };
  std::vector<double> sizes_;
  std::vector<Band> bands_;
};

}  // namespace

std::unique_ptr<ErrorLaw> law_of_replicates(const FilmSums& film) { return std::make_unique<LawOfReplicates>(film); }

}  // namespace strahl

// SPDX-License-Identifier: MIT
// d_k is the deviation of sequence k's mean, and S its covariance; halves of a sequence are those of film/sub_sums.h.
// The realised squared error differs from the estimate by d_1 d_2, whose variance is |S|^2, the sum over pairs of
// channels of the squared covariance. Only u = d_1 - d_2 is observed, and its fourth power overestimates the variance
// where samples are rare and bright. So products of independent differences are used instead:
//
//   (u_p u_q)^2 / 4     for neighbouring pixels p, q: |S|^2 where the noise changes slowly, too small at an edge;
//   (w_1 w_2)^2         with w_k half of the difference of the halves of sequence k: the pixel's own, but of halves;
//   (w_1p w_2q)^2 ...   for neighbours: too small at an edge, as the first is.
//
// The first over the third converts the second from halves to the whole; what is lost at edges cancels.
//
// Where one pixel or a few are all of the noise, these products are small by chance as often as the estimate is. So the
// largest upper estimate of a pixel by itself is added, |S|^2 with S the mean of the three differences' squares, times
// half of that pixel's share of the noise. Among many noisy pixels it does not count.
//
// Where pixels share samples, the first is larger by the neighbours' correlation, the third, half of whose products are
// of two sequences, by half of that: the variance comes out a few per cent too large.
//
// A part of a picture may have nothing of the second halves. Then u by itself tells all, pixel by pixel.
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/error_law.h"
#include "render/film.h"
#include "render/shared_noise.h"

namespace strahl {
namespace {

constexpr std::size_t sequences = layout::SOBOL_SEQUENCES;
static_assert(sequences == 2 && layout::FILM_SUBSUMS == 2 * sequences);

/// Products that share a pixel are not independent, so the parts of a sum are square tiles of a band; this is their
/// side in pixels.
constexpr int tile_side = rows_per_band;

/// One pixel in so many may have no halves: of filters with negative parts weights may cancel.
constexpr std::size_t pixels_for_one = 100;

/// The differences between a pixel's sums.
struct Differences {
  Colour whole{};                        ///< u.
  std::array<Colour, sequences> half{};  ///< w_1, w_2; zero without has_halves.
  double halves = 0;                     ///< w_1 w_2.
  bool has_halves = false;
};

/// What a pixel's sums are multiplied by. Products with weights, not quotients: of a noiseless pixel both are the same
/// number, and divisions take most of the time. A sequence without weight says nothing, as in the limit.
struct Factors {
  explicit Factors(const SubSumWeights& weights) : weight(weights) {
    first = weight[0] + weight[2];
    second = weight[1] + weight[3];
    if (first + second > 0) per_sample = 1 / (first + second);
    // 1 but where one sequence weighs more.
    const double evenness = 2 * std::sqrt(first * second) * per_sample;
    if (first * second > 0) per_whole = evenness / (first * second);
    has_halves = std::all_of(weight.begin(), weight.end(), [](double one) { return one > 0; });
    for (std::size_t k = 0; k < sequences; ++k)
      per_half[k] = has_halves ? 0.5 / (weight[k] * weight[k + sequences]) : 0;
  }

  SubSumWeights weight;
  double first, second, per_sample = 0, per_whole = 0;
  std::array<double, sequences> per_half{};
  bool has_halves;
};

PixelError told_by_sequences(const SubSumColours& colours, const Factors& by, Differences& differences) {
  differences.has_halves = by.has_halves;
  PixelError pixel;
  for (std::size_t c = 0; c < layout::FILM_CHANNELS; ++c) {
    const std::array<double, layout::FILM_SUBSUMS> sum{colours[0][c], colours[1][c], colours[2][c], colours[3][c]};
    const double first = sum[0] + sum[2], second = sum[1] + sum[3];
    const double u = (first * by.second - second * by.first) * by.per_whole;
    pixel.mean[c] = (first + second) * by.per_sample;
    pixel.squared[c] = u * u / 4;
    differences.whole[c] = u;
    for (std::size_t k = 0; k < sequences; ++k)
      differences.half[k][c] = (sum[k] * by.weight[k + sequences] - sum[k + sequences] * by.weight[k]) * by.per_half[k];
    differences.halves += differences.half[0][c] * differences.half[1][c];
  }
  return pixel;
}

/// A sum of matrices a a^T, the upper triangle row by row. The scalar product of two of them is the sum of the squared
/// scalar products of their vectors, of which there would be more.
using Outer = std::array<double, 6>;
static_assert(layout::FILM_CHANNELS == 3);

void add_outer(const Colour& a, Outer& sum) {
  for (std::size_t i = 0, at = 0; i < a.size(); ++i)
    for (std::size_t j = i; j < a.size(); ++j, ++at) sum[at] += a[i] * a[j];
}
double dot(const Outer& a, const Outer& b) {
  return a[0] * b[0] + a[3] * b[3] + a[5] * b[5] + 2 * (a[1] * b[1] + a[2] * b[2] + a[4] * b[4]);
}
double trace(const Outer& a) { return a[0] + a[3] + a[5]; }

/// Of u, and of w_1 and w_2 together; of a pixel, or of its neighbours.
struct Noise {
  Outer whole{}, half{};

  void operator+=(const Noise& other) {
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] += other.whole[i];
    for (std::size_t i = 0; i < half.size(); ++i) half[i] += other.half[i];
  }
};

Noise noise_of(const Differences& pixel) {
  Noise noise;
  add_outer(pixel.whole, noise.whole);
  for (const Colour& half : pixel.half) add_outer(half, noise.half);
  return noise;
}

/// Sums of products; each estimates |S|^2 as described above.
struct Products {
  double whole_beside = 0, half = 0, half_beside = 0;
  double squared = 0;  ///< The squared error itself.
  double spread = 0;   ///< The trace of S by the pixel itself,
  double alone = 0;    ///< and its square: an overestimate, the only one where neighbours have no noise.

  void operator+=(const Products& other) {
    whole_beside += other.whole_beside;
    half += other.half;
    half_beside += other.half_beside;
    squared += other.squared;
    spread += other.spread;
    alone += other.alone;
  }
};

/// beside: of those of its neighbours that no other pair is made with.
Products products_of(const Differences& pixel, const Noise& noise, const Noise& beside) {
  const double by_whole = trace(noise.whole) / 2;
  const double spread = pixel.has_halves ? (by_whole + trace(noise.half)) / 3 : by_whole;
  return {dot(noise.whole, beside.whole) / 4,
          pixel.halves * pixel.halves,
          dot(noise.half, beside.half) / 4,
          by_whole / 2,
          spread,
          spread * spread};
}

class LawOfSequences final : public ErrorLaw {
 public:
  explicit LawOfSequences(const FilmShape& film) : overlap_(film.noise_overlap), bands_(band_of(film.height - 1) + 1) {
    for (Band& band : bands_) band.tiles.resize(static_cast<std::size_t>((film.width + tile_side - 1) / tile_side));
  }

  void add(const FilmRows& rows, int first) override {
    OfSamples<Factors> factors;
    const auto width = static_cast<std::size_t>(rows.width);
    std::vector<Noise> above(width), row(width);
    SharedNoiseRows<1> shared(width);
    each_pixel(rows, first, [&](std::size_t at, std::size_t x, std::optional<std::size_t> band_number) {
      Differences here;
      const PixelError pixel = told_by_sequences(rows.sub_sums(at), factors.of(rows, at), here);
      if (x == 0) above.swap(row);
      row[x] = noise_of(here);
      const SharedNoise noise = shared.add(x, {here.halves});
      if (!band_number) return;
      Band& band = bands_[*band_number];
      band.picture.add(pixel);
      band.shared += noise;
      band.add(x, products_of(here, row[x], beside(row, above, x)), here.has_halves);
    });
  }
  PixelError pixel_error(const FilmRows& rows, std::size_t at) const override {
    Differences unused;
    return told_by_sequences(rows.sub_sums(at), Factors(rows.sub_sum_weights(at)), unused);
  }
  PictureError tell() const override;

 private:
  struct Band {
    PictureError picture;
    SharedNoise shared;
    std::vector<Products> tiles;
    double most_alone = 0;
    std::size_t pixels = 0, without_halves = 0;

    void add(std::size_t x, const Products& products, bool has_halves) {
      tiles[x / tile_side] += products;
      most_alone = std::max(most_alone, products.alone);
      ++pixels;
      if (!has_halves) ++without_halves;
    }
  };

  /// Of the neighbours to the left and above.
  static Noise beside(const std::vector<Noise>& row, const std::vector<Noise>& above, std::size_t x) {
    Noise sum = above[x];
    if (x + 1 < row.size()) sum += above[x + 1];
    if (x == 0) return sum;
    sum += above[x - 1];
    sum += row[x - 1];
    return sum;
  }

  double overlap_;
  std::vector<Band> bands_;
};

/// The variance; zero where there is no noise. Its degrees of freedom go by the change that each tile makes to its
/// ratio to the squared error's square, which the interval is of; without neighbours, to the variance itself. The
/// changes of the ratio add up to -1, so that tiles count as those of a sum.
PictureError LawOfSequences::tell() const {
  PictureError picture;
  Products all;
  SharedNoise shared;
  double most_alone = 0;
  std::size_t pixels = 0, without_halves = 0;
  for (const Band& band : bands_) {
    picture += band.picture;
    shared += band.shared;
    for (const Products& tile : band.tiles) all += tile;
    most_alone = std::max(most_alone, band.most_alone);
    pixels += band.pixels;
    without_halves += band.without_halves;
  }
  if (!(all.alone > 0)) return picture;
  const bool has_halves = without_halves * pixels_for_one <= pixels;
  const bool has_neighbours = has_halves && all.whole_beside > 0 && all.half > 0 && all.half_beside > 0;
  const double by_one = most_alone * (std::sqrt(most_alone) / all.spread) / 2;
  picture.variance = overlap_ * all.alone;
  if (has_neighbours)
    picture.variance = shared.overlap(overlap_) * all.half * (all.whole_beside / all.half_beside) + by_one;
  double squares = 0;
  for (const Band& band : bands_)
    for (const Products& tile : band.tiles) {
      const double share = has_neighbours ? tile.half / all.half + tile.whole_beside / all.whole_beside -
                                                tile.half_beside / all.half_beside - 2 * tile.squared / all.squared
                                          : tile.alone / all.alone;
      squares += share * share;
    }
  picture.freedom = satterthwaite(1, squares);
  return picture;
}

}  // namespace

std::unique_ptr<ErrorLaw> law_of_sequences(const FilmShape& film) { return std::make_unique<LawOfSequences>(film); }

}  // namespace strahl

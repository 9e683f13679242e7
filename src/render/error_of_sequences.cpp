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
// A part of a picture may have nothing of the second halves. Then u by itself tells all, pixel by pixel.
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/error_law.h"
#include "render/film.h"

namespace strahl {
namespace {

constexpr std::size_t sequences = layout::SOBOL_SEQUENCES;
static_assert(sequences == 2 && layout::FILM_SUBSUMS == 2 * sequences);

/// Products that share a pixel are not independent, so the parts of a sum are square tiles; this is their side in
/// pixels.
constexpr int tile_side = 4;

/// The differences between a pixel's sums.
struct Differences {
  Colour whole{};                        ///< u.
  std::array<Colour, sequences> half{};  ///< w_1, w_2; zero without has_halves.
  bool has_halves = false;
};

/// What the sums of pixels of so many samples are multiplied by. Products with counts, not quotients: of a noiseless
/// pixel both are the same number, and divisions take most of the time.
struct Weights {
  explicit Weights(const SubSumCounts& counts) {
    for (std::size_t sub = 0; sub < number.size(); ++sub) number[sub] = counts[sub];
    first = number[0] + number[2];
    second = number[1] + number[3];
    per_sample = 1 / (first + second);
    // 1 but where one sequence is a sample longer.
    const double evenness = 2 * std::sqrt(first * second) * per_sample;
    per_whole = evenness / (first * second);
    has_halves = std::all_of(counts.begin(), counts.end(), [](int count) { return count > 0; });
    for (std::size_t k = 0; k < sequences; ++k)
      per_half[k] = has_halves ? 0.5 / (number[k] * number[k + sequences]) : 0;
  }

  std::array<double, layout::FILM_SUBSUMS> number{};
  double first, second, per_sample, per_whole;
  std::array<double, sequences> per_half{};
  bool has_halves;
};

PixelError told_by_sequences(const SubSumColours& colours, const Weights& by, Differences& differences) {
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
      differences.half[k][c] = (sum[k] * by.number[k + sequences] - sum[k + sequences] * by.number[k]) * by.per_half[k];
  }
  return pixel;
}

double squared_product(const Colour& a, const Colour& b) {
  double product = 0;
  for (int c = 0; c < layout::FILM_CHANNELS; ++c) product += a[c] * b[c];
  return product * product;
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

double squared_length(const Colour& a) {
  double sum = 0;
  for (const double value : a) sum += value * value;
  return sum;
}

Products own_products(const Differences& p) {
  const double by_whole = squared_length(p.whole) / 2;
  const double spread =
      p.has_halves ? (by_whole + squared_length(p.half[0]) + squared_length(p.half[1])) / 3 : by_whole;
  return {0, squared_product(p.half[0], p.half[1]), 0, by_whole / 2, spread, spread * spread};
}

/// One pixel's half of a pair's product; the other half belongs to the other pixel.
Products pair_products(const Differences& p, const Differences& q) {
  double halves = 0;
  for (const Colour& a : p.half)
    for (const Colour& b : q.half) halves += squared_product(a, b);
  return {squared_product(p.whole, q.whole) / 8, 0, halves / 8, 0, 0, 0};
}

class TiledProducts {
 public:
  TiledProducts(int width, int height)
      : across_((width + tile_side - 1) / tile_side),
        tiles_(static_cast<std::size_t>(across_) * static_cast<std::size_t>((height + tile_side - 1) / tile_side)) {}

  /// Of a pixel that has no halves.
  void lacks_halves() { has_halves_ = false; }

  void add(int x, int y, const Products& products) {
    tiles_[static_cast<std::size_t>(y / tile_side) * static_cast<std::size_t>(across_) +
           static_cast<std::size_t>(x / tile_side)] += products;
    most_alone_ = std::max(most_alone_, products.alone);
  }

  /// The variance; and degrees of freedom, from the change that each tile makes to its ratio to the squared error's
  /// square, which the interval goes by. Zero where there is no noise.
  void tell(PictureError& picture) const {
    Products all;
    for (const Products& tile : tiles_) all += tile;
    if (!(all.alone > 0)) return;
    const bool has_neighbours = has_halves_ && all.whole_beside > 0 && all.half > 0 && all.half_beside > 0;
    const double by_one = most_alone_ * (std::sqrt(most_alone_) / all.spread) / 2;
    picture.variance = has_neighbours ? all.half * (all.whole_beside / all.half_beside) + by_one : all.alone;
    double squares = 0;
    for (const Products& tile : tiles_) {
      const double share = has_neighbours ? tile.half / all.half + tile.whole_beside / all.whole_beside -
                                                tile.half_beside / all.half_beside - 2 * tile.squared / all.squared
                                          : tile.alone / all.alone;
      squares += share * share;
    }
    picture.freedom = satterthwaite(1, squares);
  }

 private:
  int across_;
  std::vector<Products> tiles_;
  double most_alone_ = 0;
  bool has_halves_ = true;
};

class LawOfSequences final : public ErrorLaw {
 public:
  LawOfSequences(int width, int height) : products_(width, height), row_(static_cast<std::size_t>(width)) {}

  void add(const FilmRows& rows) override {
    std::size_t at = 0;
    for (int y = 0; y < rows.height; ++y, ++y_) {
      for (int x = 0; x < rows.width; ++x, ++at) {
        Differences& here = row_[static_cast<std::size_t>(x)];
        picture_.add(told_by_sequences(rows.sub_sums(at), weights_.of(rows, at), here));
        add_products(here, x, rows.width);
      }
      above_.swap(row_);
      row_.resize(above_.size());
    }
  }
  PixelError pixel_error(const FilmRows& rows, std::size_t at) const override {
    Differences unused;
    return told_by_sequences(rows.sub_sums(at), Weights(rows.sub_sum_counts(rows.samples[at])), unused);
  }
  PictureError tell() const override {
    PictureError picture = picture_;
    products_.tell(picture);
    return picture;
  }

 private:
  /// Of a pixel of row y_ by itself and with its neighbours to the left and above.
  void add_products(const Differences& here, int x, int width) {
    if (!here.has_halves) products_.lacks_halves();
    Products all = own_products(here);
    const auto pair = [&](int other_x, int other_y, const Differences& other) {
      const Products shared = pair_products(here, other);
      all += shared;
      products_.add(other_x, other_y, shared);
    };
    if (x > 0) pair(x - 1, y_, row_[static_cast<std::size_t>(x) - 1]);
    for (int other = std::max(0, x - 1); y_ > 0 && other <= std::min(width - 1, x + 1); ++other)
      pair(other, y_ - 1, above_[static_cast<std::size_t>(other)]);
    products_.add(x, y_, all);
  }

  PictureError picture_;
  OfSamples<Weights> weights_;
  TiledProducts products_;
  std::vector<Differences> above_, row_;
  int y_ = 0;  ///< The next row.
};

}  // namespace

std::unique_ptr<ErrorLaw> law_of_sequences(int width, int height) {
  return std::make_unique<LawOfSequences>(width, height);
}

}  // namespace strahl

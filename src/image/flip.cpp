// SPDX-License-Identifier: MIT
// Names of constants as in the paper: qc, pc, pt (section 5.1), w, qf (section 5.2 and 5.3).
#include "image/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/flip_colour.h"
#include "image/separable_filter.h"

namespace strahl {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double qc = 0.7, pc = 0.4, pt = 0.95;
constexpr double w = 0.082, qf = 0.5;

// Contrast sensitivity as gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b) of degrees x (Table 1); that of Cz is a sum of
// two.
constexpr double b_y = 0.0047, b_cx = 0.0053;
constexpr double a_cz1 = 34.1, b_cz1 = 0.04, a_cz2 = 13.5, b_cz2 = 0.025;

/// The filters of one viewing distance, each used along rows and columns.
struct Filters {
  std::vector<double> y, cx, cz1, cz2;            ///< What the eye blurs; cz1 and cz2 carry the roots of their shares.
  std::vector<double> blur, slope, second_slope;  ///< A gaussian and its derivatives, for edges and points.
};

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

/// The positive weights to sum 1, the negative ones to -1.
void balance(std::vector<double>& weights) {
  double positive = 0, negative = 0;
  for (const double weight : weights) (weight > 0 ? positive : negative) += std::fabs(weight);
  for (double& weight : weights) weight /= weight > 0 ? positive : negative;
}

Filters filters_of(double pixels_per_degree) {
  Filters f;
  const int reach = static_cast<int>(std::ceil(3 * std::sqrt(b_cz1 / (2 * pi * pi)) * pixels_per_degree));
  for (int i = -reach; i <= reach; ++i) {
    const double x2 = (i / pixels_per_degree) * (i / pixels_per_degree);
    const auto gaussian = [x2](double b) { return std::exp(-pi * pi * x2 / b); };
    f.y.push_back(gaussian(b_y));
    f.cx.push_back(gaussian(b_cx));
    f.cz1.push_back(std::sqrt(a_cz1 * std::sqrt(pi / b_cz1)) * gaussian(b_cz1));
    f.cz2.push_back(std::sqrt(a_cz2 * std::sqrt(pi / b_cz2)) * gaussian(b_cz2));
  }
  scale(f.y, 1 / sum(f.y));
  scale(f.cx, 1 / sum(f.cx));
  const double both = std::hypot(sum(f.cz1), sum(f.cz2));
  scale(f.cz1, 1 / both);
  scale(f.cz2, 1 / both);

  const double deviation = 0.5 * w * pixels_per_degree;
  const int near = static_cast<int>(std::ceil(3 * deviation));
  for (int i = -near; i <= near; ++i) {
    const double g = std::exp(-0.5 * i * i / (deviation * deviation));
    f.blur.push_back(g);
    f.slope.push_back(-i * g);
    f.second_slope.push_back((i * i / (deviation * deviation) - 1) * g);
  }
  scale(f.blur, 1 / sum(f.blur));
  balance(f.slope);
  balance(f.second_slope);
  return f;
}

Channel filter(const Channel& channel, const std::vector<double>& x, const std::vector<double>& y) {
  return filter_columns(filter_rows(channel, x, Border::repeat), y, Border::repeat);
}

/// What FLIP compares of one picture.
struct Appearance {
  RgbChannels colour;   ///< Hunt-adjusted L*a*b* of the blurred picture.
  Channel edge, point;  ///< Lengths of the first and second derivatives of lightness.
};

Channel lengths(const Channel& x, const Channel& y) {
  Channel result(x.width, x.height);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    result.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
  }
  return result;
}

Appearance appearance(const RgbChannels& rgb, const Filters& f) {
  RgbChannels ycxcz = rgb;
  for (std::size_t i = 0; i < rgb[0].values.size(); ++i) {
    const Colour colour = ycxcz_from_linear({rgb[0].values[i], rgb[1].values[i], rgb[2].values[i]});
    for (std::size_t c = 0; c < 3; ++c) ycxcz[c].values[i] = colour[c];
  }

  RgbChannels colour{filter(ycxcz[0], f.y, f.y), filter(ycxcz[1], f.cx, f.cx), filter(ycxcz[2], f.cz1, f.cz1)};
  const Channel narrow = filter(ycxcz[2], f.cz2, f.cz2);
  for (std::size_t i = 0; i < narrow.values.size(); ++i) {
    Colour seen = linear_from_ycxcz({colour[0].values[i], colour[1].values[i], colour[2].values[i] + narrow.values[i]});
    for (double& channel : seen) channel = std::clamp(channel, 0.0, 1.0);
    seen = hunt_lab_from_linear(seen);
    for (std::size_t c = 0; c < 3; ++c) colour[c].values[i] = seen[c];
  }

  Channel& lightness = ycxcz[0];
  for (double& value : lightness.values) value = (value + 16) / 116;
  const Channel blurred = filter_rows(lightness, f.blur, Border::repeat);
  return {std::move(colour),
          lengths(filter(lightness, f.slope, f.blur), filter_columns(blurred, f.slope, Border::repeat)),
          lengths(filter(lightness, f.second_slope, f.blur), filter_columns(blurred, f.second_slope, Border::repeat))};
}

/// The largest distance that there is, of pure green and blue.
double largest_distance() {
  return std::pow(hyab_distance(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), qc);
}

/// A distance to [0, 1]: those up to pc of the largest take most of the range, up to pt.
double colour_error(double distance, double largest) {
  const double d = std::pow(distance, qc);
  const double knee = pc * largest;
  return d < knee ? d * pt / knee : pt + (d - knee) / (largest - knee) * (1 - pt);
}

}  // namespace

Channel flip_map(const RgbChannels& a, const RgbChannels& reference, double pixels_per_degree) {
  const Filters filters = filters_of(pixels_per_degree);
  const Appearance ours = appearance(a, filters);
  const Appearance theirs = appearance(reference, filters);
  const double largest = largest_distance();
  const auto colour_at = [](const Appearance& picture, std::size_t i) {
    return Colour{picture.colour[0].values[i], picture.colour[1].values[i], picture.colour[2].values[i]};
  };
  Channel map(a[0].width, a[0].height);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const double colour = colour_error(hyab_distance(colour_at(ours, i), colour_at(theirs, i)), largest);
    const double edge = std::fabs(ours.edge.values[i] - theirs.edge.values[i]);
    const double point = std::fabs(ours.point.values[i] - theirs.point.values[i]);
    const double feature = std::pow(std::max(edge, point) / std::numbers::sqrt2, qf);
    map.values[i] = std::pow(colour, 1 - feature);
  }
  return map;
}

}  // namespace strahl

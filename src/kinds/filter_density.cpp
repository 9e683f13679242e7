// SPDX-License-Identifier: MIT
#include "kinds/filter_density.h"

#include <cmath>

namespace strahl::kinds {

LoweredGaussian::LoweredGaussian(double radius, double stddev)
    : radius_(radius),
      stddev_(stddev),
      // So wide a gaussian is 1 - (x / radius)^2 to 3e-7 of itself, while its two terms differ by fewer digits.
      is_parabola_(stddev > 1024 * radius),
      floor_(std::exp(-radius * radius / (2 * stddev * stddev))),
      unit_(stddev * std::sqrt(2.0)),
      area_(stddev * std::sqrt(std::acos(-1.0) / 2)),
      beyond_(std::erfc(radius / unit_)) {
  whole_ = is_parabola_ ? radius - radius * radius * radius / (3 * radius * radius)
                        : area_ * std::erf(radius / unit_) - floor_ * radius;
}

double LoweredGaussian::density(double x) const {
  const double height =
      is_parabola_ ? 1 - x * x / (radius_ * radius_) : std::exp(-x * x / (2 * stddev_ * stddev_)) - floor_;
  return height / (2 * whole_);
}

double LoweredGaussian::quantile(double share) const {
  double low = 0, high = radius_;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) return middle;
    (tail(middle) > share * whole_ ? low : high) = middle;
  }
}

/// The integral from x to the radius: of tails the difference of two from 0 has few digits.
double LoweredGaussian::tail(double x) const {
  const double rest = radius_ - x;
  if (is_parabola_) return rest * rest * (2 * radius_ + x) / (3 * radius_ * radius_);
  // Near the radius both differences are small beside their terms: there the bell is a line and a parabola.
  const double slope = radius_ / (stddev_ * stddev_) * floor_;
  if (slope * rest < 1e-3 * floor_ && rest < 0.1 * radius_)
    return slope * rest * rest / 2 * (1 + rest * (radius_ / (stddev_ * stddev_) - 1 / radius_) / 3);
  return area_ * (std::erfc(x / unit_) - beyond_) - floor_ * rest;
}

namespace {

/// x >= 0.
double cubic(double b, double c, double x) {
  if (x < 1) return (((12 - 9 * b - 6 * c) * x + (-18 + 12 * b + 6 * c)) * x * x + (6 - 2 * b)) / 6;
  return (((-(b + 6 * c) * x + (6 * b + 30 * c)) * x - (12 * b + 48 * c)) * x + (8 * b + 24 * c)) / 6;
}

double sinc(double x) {
  const double turn = std::acos(-1.0) * x;
  return turn == 0 ? 1 : std::sin(turn) / turn;
}

}  // namespace

double filter_radius(const Filter& filter) {
  const auto given_or = [&](double own) { return filter.radius > 0 ? filter.radius : own; };
  switch (filter.kind) {
    case FilterKind::box:
      return given_or(0.5);
    case FilterKind::tent:
      return given_or(1);
    case FilterKind::gaussian:
      return given_or(4 * filter.stddev);
    case FilterKind::lanczos:
      return given_or(3);
    case FilterKind::mitchell:
    case FilterKind::catmullrom:
      return 2;
  }
  return 0;
}

double filter_density(const Filter& filter, double x) {
  const double radius = filter_radius(filter);
  switch (filter.kind) {
    case FilterKind::box:
      return 0.5 / radius;
    case FilterKind::tent:
      return (1 - std::fabs(x) / radius) / radius;
    case FilterKind::gaussian:
      return LoweredGaussian(radius, filter.stddev).density(x);
    case FilterKind::mitchell:
      return cubic(filter.b, filter.c, std::fabs(x));
    case FilterKind::catmullrom:
      return cubic(0, 0.5, std::fabs(x));
    case FilterKind::lanczos:
      return sinc(x) * sinc(x / radius);
  }
  return 0;
}

bool is_density(const Filter& filter) {
  return filter.kind == FilterKind::box || filter.kind == FilterKind::tent || filter.kind == FilterKind::gaussian;
}

Filter drawn_filter(const Filter& filter) { return is_density(filter) ? filter : Filter{}; }

}  // namespace strahl::kinds

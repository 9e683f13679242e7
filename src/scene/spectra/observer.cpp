// SPDX-License-Identifier: MIT
// Products of the tables and the curve are integrated exactly: between neighbouring wavelengths of either they are
// polynomials of degree 3 at most, for which Simpson's rule is exact. XYZ to linear sRGB: ITU-R BT.709.
#include "scene/spectra/observer.h"

#include <algorithm>
#include <cmath>

#include "scene/spectra/observer_table.h"

namespace strahl {

namespace {

double observer_last() { return observer_first + observer_step * static_cast<double>(observer_table.size() - 1); }

ObserverRow observer_at(double wavelength) {
  const double place = (wavelength - observer_first) / observer_step;
  const auto last = observer_table.size() - 2;
  const std::size_t i = std::min(static_cast<std::size_t>(std::max(place, 0.0)), last);
  const double s = place - static_cast<double>(i);
  const ObserverRow &a = observer_table[i], &b = observer_table[i + 1];
  const auto between = [s](double from, double to) { return from + s * (to - from); };
  return {between(a.x, b.x), between(a.y, b.y), between(a.z, b.z), between(a.d65, b.d65)};
}

Vec3 weighted(const ObserverRow& row, double by) { return {by * row.x, by * row.y, by * row.z}; }

/// Integral of curve * observer (* D65).
Vec3 xyz_of(const SpectrumCurve& curve, bool under_d65) {
  std::vector<double> nodes = curve.wavelengths;
  for (std::size_t i = 0; i < observer_table.size(); ++i)
    nodes.push_back(observer_first + observer_step * static_cast<double>(i));
  std::sort(nodes.begin(), nodes.end());
  const double first = std::max(observer_first, curve.wavelengths.front());
  const double last = std::min(observer_last(), curve.wavelengths.back());
  const auto at = [&](double wavelength) {
    const ObserverRow row = observer_at(wavelength);
    return weighted(row, curve.at(wavelength) * (under_d65 ? row.d65 : 1));
  };
  Vec3 sum;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double from = nodes[i], to = nodes[i + 1];
    if (from < first || to > last || from == to) continue;
    sum = sum + ((to - from) / 6) * (at(from) + 4.0 * at((from + to) / 2) + at(to));
  }
  return sum;
}

Rgb rgb_of(const Vec3& xyz) {
  return {3.240479 * xyz.x - 1.537150 * xyz.y - 0.498535 * xyz.z,
          -0.969256 * xyz.x + 1.875991 * xyz.y + 0.041556 * xyz.z,
          0.055648 * xyz.x - 0.204043 * xyz.y + 1.057311 * xyz.z};
}

Rgb not_negative(const Rgb& c) { return {std::max(c.r, 0.0), std::max(c.g, 0.0), std::max(c.b, 0.0)}; }

SpectrumCurve one() { return {{observer_first, observer_last()}, {1, 1}}; }

}  // namespace

Rgb rgb_of_emission(const SpectrumCurve& curve) {
  static const double luminance_of_one = xyz_of(one(), false).y;
  return not_negative(rgb_of((1 / luminance_of_one) * xyz_of(curve, false)));
}

Rgb rgb_of_constant_emission(double value) { return rgb_of({value, value, value}); }

Rgb rgb_of_weight(const SpectrumCurve& curve) {
  static const Rgb of_one = rgb_of(xyz_of(one(), true));
  const Rgb c = rgb_of(xyz_of(curve, true));
  return not_negative({c.r / of_one.r, c.g / of_one.g, c.b / of_one.b});
}

}  // namespace strahl

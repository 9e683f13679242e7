// SPDX-License-Identifier: MIT
// Coefficients: appendix A.2 of the paper; the sun's light: A.1.
#include "scene/sky/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/spectra/curve.h"
#include "scene/spectra/observer.h"

namespace strahl {
namespace {

using std::numbers::pi;

/// Lumens a watt at 555 nm times the integral of the observer's y over wavelengths, nm: cd / m^2 of a spectrum of 1.
constexpr double luminance_of_one = 683 * 106.857;

/// rows times (angle^3, angle^2, angle, 1), times (turbidity^2, turbidity, 1).
double zenith_chromaticity(double turbidity, double angle, const std::array<std::array<double, 4>, 3>& rows) {
  double sum = 0;
  for (const auto& [cubic, square, linear, constant] : rows)
    sum = sum * turbidity + ((cubic * angle + square) * angle + linear) * angle + constant;
  return sum;
}

int day_of_year(int year, int month, int day) {
  constexpr std::array before{0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334};
  const bool is_leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return before.at(static_cast<std::size_t>(month - 1)) + day + (is_leap && month > 2 ? 1 : 0);
}

/// Linear sRGB of chromaticity and luminance.
Rgb rgb_of_chromaticity(double x, double y, double luminance) {
  const double cap_x = luminance * x / y, cap_z = luminance * (1 - x - y) / y;
  const auto sum = [&](double a, double b, double c) { return std::max(0.0, a * cap_x + b * luminance + c * cap_z); };
  return {sum(3.2404542, -1.5371385, -0.4985314), sum(-0.9692660, 1.8760108, 0.0415560),
          sum(0.0556434, -0.2040259, 1.0572252)};
}

}  // namespace

Vec3 direction_of_sun(const DayAndPlace& when) {
  const double j = day_of_year(when.year, when.month, when.day), l = when.latitude * pi / 180;
  // The paper counts longitudes to the west.
  const double solar = when.hour + 0.170 * std::sin(4 * pi * (j - 80) / 373) -
                       0.129 * std::sin(2 * pi * (j - 8) / 355) + (when.longitude - 15 * when.timezone) / 15;
  const double declination = 0.4093 * std::sin(2 * pi * (j - 81) / 368), turn = pi * solar / 12;
  const double up = std::sin(l) * std::sin(declination) - std::cos(l) * std::cos(declination) * std::cos(turn);
  const double west = -std::cos(declination) * std::sin(turn);
  const double south = -(std::cos(l) * std::sin(declination) + std::sin(l) * std::cos(declination) * std::cos(turn));
  return normalized({-west, up, south});
}

double Sky::Perez::operator()(double cos_zenith, double angle) const {
  const double cosine = std::cos(angle);
  return (1 + a * std::exp(b / cos_zenith)) * (1 + c * std::exp(d * angle) + e * cosine * cosine);
}

Sky::Sky(double turbidity, const Vec3& sun) : sun_(normalized(sun)), is_day_(sun_.y > 0) {
  const double t = turbidity, angle = std::acos(std::clamp(sun_.y, 0.0, 1.0));
  luminance_.perez = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
                      -0.0670 * t + 0.3703};
  x_.perez = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
              -0.0033 * t + 0.0452};
  y_.perez = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
              -0.0109 * t + 0.0529};
  const double chi = (4.0 / 9 - t / 120) * (pi - 2 * angle);
  // Thousands of cd / m^2.
  const double luminance = std::max(0.0, (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192);
  const double x = zenith_chromaticity(t, angle,
                                       {{{0.00166, -0.00375, 0.00209, 0},
                                         {-0.02903, 0.06377, -0.03202, 0.00394},
                                         {0.11693, -0.21196, 0.06052, 0.25886}}});
  const double y = zenith_chromaticity(t, angle,
                                       {{{0.00275, -0.00610, 0.00317, 0},
                                         {-0.04214, 0.08970, -0.04153, 0.00516},
                                         {0.15346, -0.26756, 0.06670, 0.26688}}});
  luminance_.zenith = 1000 * luminance / luminance_of_one / luminance_.perez(1, angle);
  x_.zenith = x / x_.perez(1, angle);
  y_.zenith = y / y_.perez(1, angle);
}

Rgb Sky::radiance(const Vec3& view) const {
  if (!is_day_ || view.y <= 0) return {};
  const double angle = std::acos(std::clamp(dot(view, sun_), -1.0, 1.0));
  const auto value = [&](const Channel& channel) { return channel.zenith * channel.perez(view.y, angle); };
  return rgb_of_chromaticity(value(x_), value(y_), std::max(0.0, value(luminance_)));
}

std::shared_ptr<const Texels> Sky::image(int width) const {
  Texels texels;
  texels.file = "sky";
  texels.width = width;
  texels.height = width / 2 + 1;
  texels.format = TexelFormat::real;
  texels.reals.reserve(3 * texels.count());
  for (int row = 0; row < texels.height; ++row) {
    const double theta = pi * row / (texels.height - 1);
    for (int column = 0; column < width; ++column) {
      const double phi = 2 * pi * (column + 0.5) / width;
      const Rgb c = radiance({std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta)});
      for (const double channel : {c.r, c.g, c.b}) texels.reals.push_back(static_cast<float>(channel));
    }
  }
  return std::make_shared<const Texels>(std::move(texels));
}

Rgb radiance_of_sun(double turbidity, const Vec3& sun) {
  const double height = normalized(sun).y;
  if (height <= 0) return {};
  const double degrees = std::acos(std::min(height, 1.0)) * 180 / pi;
  const double mass = 1 / (height + 0.15 * std::pow(93.885 - degrees, -1.253));
  const double beta = std::max(0.0, 0.04608260 * turbidity - 0.04586026);
  SpectrumCurve curve = planck_curve(5778);
  for (std::size_t i = 0; i < curve.values.size(); ++i) {
    const double micrometres = curve.wavelengths[i] / 1000;
    const double molecules = 0.008735 * std::pow(micrometres, -4.08), haze = beta * std::pow(micrometres, -1.3);
    curve.values[i] *= std::exp(-mass * (molecules + haze));
  }
  return rgb_of_emission(curve);
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "image/flip_colour.h"

#include <cmath>

namespace strahl {
namespace {

using ColourMatrix = std::array<Colour, 3>;

/// CIE XYZ of linear RGB: the chromaticities of IEC 61966-2-1 and its white D65 (0.3127, 0.329), without rounding.
constexpr ColourMatrix xyz_from_rgb{{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

constexpr Colour product(const ColourMatrix& m, const Colour& v) {
  Colour result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

constexpr ColourMatrix inverse(const ColourMatrix& m) {
  ColourMatrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {  // Indices in a cycle give a cofactor its sign.
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      result[i][j] = m[j1][i1] * m[j2][i2] - m[j1][i2] * m[j2][i1];
    }
  }
  const double determinant = m[0][0] * result[0][0] + m[0][1] * result[1][0] + m[0][2] * result[2][0];
  for (Colour& row : result) {
    for (double& entry : row) entry /= determinant;
  }
  return result;
}

constexpr Colour white = product(xyz_from_rgb, {1, 1, 1});

/// Each row divided by the white's: XYZ relative to white.
constexpr ColourMatrix relative(ColourMatrix m) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (double& entry : m[i]) entry /= white[i];
  }
  return m;
}

constexpr ColourMatrix relative_from_rgb = relative(xyz_from_rgb);
constexpr ColourMatrix rgb_from_relative = inverse(relative_from_rgb);

/// CIELAB's cube root with its line near black.
double lab_root(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

}  // namespace

Colour ycxcz_from_linear(const Colour& rgb) {
  const Colour xyz = product(relative_from_rgb, rgb);
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Colour linear_from_ycxcz(const Colour& ycxcz) {
  const double y = (ycxcz[0] + 16) / 116;
  return product(rgb_from_relative, {y + ycxcz[1] / 500, y, y - ycxcz[2] / 200});
}

Colour hunt_lab_from_linear(const Colour& rgb) {
  const Colour xyz = product(relative_from_rgb, rgb);
  const double x = lab_root(xyz[0]), y = lab_root(xyz[1]), z = lab_root(xyz[2]);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab_distance(const Colour& a, const Colour& b) {
  return std::fabs(a[0] - b[0]) + std::sqrt((a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

}  // namespace strahl

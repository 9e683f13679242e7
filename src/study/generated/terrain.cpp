// SPDX-License-Identifier: MIT
// Fractal Brownian motion of gradient noise (K. Perlin, "Improving Noise", SIGGRAPH 2002) over a grid: every octave has
// half the size and 0.45 of the height of the one before, down to the grid's cells.
#include <cmath>
#include <cstdint>

#include "study/generated/scenes.h"
#include "study/generated/stage.h"
#include "study/hashed.h"

namespace strahl {
namespace {

double gradient(std::int64_t x, std::int64_t y, double dx, double dy) {
  const std::uint64_t bits = hashed(static_cast<std::uint64_t>(x) << 32 ^ static_cast<std::uint64_t>(y));
  const double gx = hashed_uniform(bits) - 0.5, gy = hashed_uniform(bits + 1) - 0.5;
  return 2 * (gx * dx + gy * dy);
}

double noise(double x, double y) {
  const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
  const double cell_x = std::floor(x), cell_y = std::floor(y), dx = x - cell_x, dy = y - cell_y;
  const auto i = static_cast<std::int64_t>(cell_x), k = static_cast<std::int64_t>(cell_y);
  const double u = fade(dx), v = fade(dy);
  return mix(mix(gradient(i, k, dx, dy), gradient(i + 1, k, dx - 1, dy), u),
             mix(gradient(i, k + 1, dx, dy - 1), gradient(i + 1, k + 1, dx - 1, dy - 1), u), v);
}

double height(double x, double y, int octaves) {
  double sum = 0, amplitude = 1, frequency = 3;
  for (int octave = 0; octave < octaves; ++octave) {
    const double shift = 17 * octave;
    sum += amplitude * noise(frequency * x + shift, frequency * y - shift);
    amplitude *= 0.45;
    frequency *= 2;
  }
  return 0.5 * sum;
}

}  // namespace

Scene terrain(int triangles) {
  const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 2.0))));
  const int octaves = std::max(1, static_cast<int>(std::log2(n / 3.0)));
  Scene scene =
      stage("terrain-" + std::to_string(triangles), {0.5, -0.35, 0.6}, {0.5, 0.4, 0}, {0, 0, 1}, 50, {-1, 0.2, 1.5});
  Mesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const double px = static_cast<double>(x) / n, py = static_cast<double>(y) / n;
      mesh.positions.push_back(to_float({px, py, height(px, py, octaves)}));
    }
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  scene.shapes.emplace_back().geometry = std::move(mesh);
  return scene;
}

}  // namespace strahl

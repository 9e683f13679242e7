// SPDX-License-Identifier: MIT
// Environments for the tests of lights, and their fluence in closed form.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl::test {

struct EnvironmentRow {
  std::string what;
  EnvironmentLight light;
};

/// Grey, of floats; red, green and blue are 1, 1/2 and 1/4 of it. All of it is drawn.
[[nodiscard]] inline EnvironmentLight environment_of(int width, int height, const std::vector<float>& values) {
  EnvironmentLight light;
  light.texels = std::make_shared<const Texels>(texels_of_floats(width, height, 1, values));
  light.scale = {1, 0.5, 0.25};
  light.mis_compensation = false;
  return light;
}

/// Dark but for one texel.
[[nodiscard]] inline EnvironmentLight bright_texel(int width, int height, int column, int row, float value = 1) {
  std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  values[static_cast<std::size_t>(row * width + column)] = value;
  return environment_of(width, height, values);
}

[[nodiscard]] inline EnvironmentLight noisy_environment(int width, int height) {
  std::mt19937 engine(3);
  std::vector<float> values;
  for (int i = 0; i < width * height; ++i) values.push_back(0.25F + static_cast<float>(engine() % 1024) / 1024);
  return environment_of(width, height, values);
}

/// A right-handed turn about (1, 1, 1), and the mirror image of one.
[[nodiscard]] inline EnvironmentLight turned(EnvironmentLight light, bool is_mirrored) {
  light.axes = {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{is_mirrored ? -1.0 : 1.0, 0, 0}};
  return light;
}

/// Whose density numbers on a grid of directions integrate well.
[[nodiscard]] inline std::vector<EnvironmentRow> smooth_environments() {
  return {{"of noise", noisy_environment(6, 5)},
          {"turned", turned(noisy_environment(6, 5), false)},
          {"mirrored", turned(noisy_environment(5, 4), true)},
          {"with one bright texel", bright_texel(16, 9, 5, 3)},
          {"with one bright texel at the seam", bright_texel(16, 9, 15, 4)}};
}

/// The integral of the first channel's radiance over all directions: bilinear in both angles, times the sine of one.
[[nodiscard]] inline double fluence(const EnvironmentLight& light) {
  const TexelDecoder decoded(*light.texels, light.curve);
  const int width = light.texels->width, rows = light.texels->height - 1;
  const double step = std::numbers::pi / rows;
  double sum = 0;
  for (int row = 0; row < rows; ++row) {
    const double from = row * step, to = from + step;
    // Of the sine, and of the sine times the share of the lower row.
    const double all = std::cos(from) - std::cos(to);
    const double lower = (std::sin(to) - std::sin(from)) / step - std::cos(to);
    for (int column = 0; column < width; ++column) {
      const auto at = [&](int r) { return decoded(static_cast<std::size_t>(r * width + column))[0]; };
      sum += at(row) * (all - lower) + at(row + 1) * lower;
    }
  }
  return light.scale.r * sum * 2 * std::numbers::pi / width;
}

}  // namespace strahl::test

// SPDX-License-Identifier: MIT
#include "packing/pack_environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinds/light_reach.h"
#include "kinds/sphere_mean.h"

namespace strahl {
namespace {

using std::numbers::pi;

std::vector<double> luminances(const EnvironmentLight& light) {
  const TexelDecoder decoded(*light.texels, light.curve);
  std::vector<double> all(light.texels->count());
  for (std::size_t n = 0; n < all.size(); ++n) {
    const std::array<double, 3> c = decoded(n);
    all[n] = luminance({c[0], c[1], c[2]});
  }
  return all;
}

/// O. Karlik, M. Sik, P. Vivoda, T. Skrivan, J. Krivanek, "MIS Compensation: Optimizing Sampling Techniques in Multiple
/// Importance Sampling", SIGGRAPH Asia 2019; where all is about as bright as the mean, nothing is left out.
double compensation(double mean, const std::vector<double>& luminances) {
  const double least = *std::min_element(luminances.begin(), luminances.end());
  return mean - least <= 0.01 * mean ? 0 : mean;
}

/// A table that is never asked where there is nothing to draw.
std::vector<Choice> choices_of(const std::vector<double>& weights) {
  const bool is_dark = std::all_of(weights.begin(), weights.end(), [](double weight) { return !(weight > 0); });
  return is_dark ? choice_table(std::vector<double>(weights.size(), 1)) : choice_table(weights);
}

}  // namespace

EnvironmentTables environment_tables(const EnvironmentLight& light, bool is_compensated) {
  const auto width = static_cast<std::size_t>(light.texels->width);
  const auto rows = static_cast<std::size_t>(light.texels->height) - 1;
  std::vector<double> y = luminances(light);
  EnvironmentTables tables;
  const auto mean_of = [&] { return kinds::sphere_mean(*light.texels, [&](std::size_t n) { return y[n]; }); };
  const double mean = mean_of();
  if (is_compensated && light.mis_compensation) tables.floor = compensation(mean, y);
  for (double& one : y) one = std::max(one - tables.floor, 0.0);
  if (mean > 0) tables.drawn = mean_of() / mean;

  std::vector<double> sines(rows), row_weights(rows, 0), cells(width);
  std::vector<Choice> of_cells;
  of_cells.reserve(rows * width);
  double whole = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    sines[row] = std::sin(pi * (static_cast<double>(row) + 0.5) / static_cast<double>(rows));
    const double *upper = &y[row * width], *lower = upper + width;
    for (std::size_t column = 0; column < width; ++column) {
      const std::size_t next = (column + 1) % width;
      cells[column] = (upper[column] + upper[next] + lower[column] + lower[next]) / 4;
      row_weights[row] += sines[row] * cells[column];
    }
    whole += row_weights[row];
    const std::vector<Choice> choices = choices_of(cells);
    of_cells.insert(of_cells.end(), choices.begin(), choices.end());
  }
  tables.choices = choices_of(row_weights);
  tables.choices.insert(tables.choices.end(), of_cells.begin(), of_cells.end());
  // A cell spans 2 pi / width by pi / rows times the sine of its angle.
  const double cells_a_solid_angle = static_cast<double>(rows * width) / (2 * pi * pi);
  for (const double sine : sines) tables.rows.push_back(whole > 0 ? cells_a_solid_angle * sine / whole : 0);
  return tables;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// What the kernels draw directions to an environment from (cl/lights/envmap_lanes.h).
#pragma once

#include <vector>

#include "packing/choice_table.h"
#include "scene/model/scene.h"

namespace strahl {

struct EnvironmentTables {
  double floor = 0;             ///< The luminance that is not drawn.
  double drawn = 1;             ///< The share of the irradiance that is.
  std::vector<double> rows;     ///< Of each row of cells: cl/scene/layout.h, ENVMAP_ROWS.
  std::vector<Choice> choices;  ///< Among the rows of cells, then among the cells of each row.
};

/// is_compensated: whether directions that materials draw find what mis_compensation leaves to them.
[[nodiscard]] EnvironmentTables environment_tables(const EnvironmentLight& light, bool is_compensated);

}  // namespace strahl

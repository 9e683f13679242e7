// SPDX-License-Identifier: MIT
// Plots as SVG: as much as a report of times needs.
#pragma once

#include <string>
#include <vector>

namespace strahl::bench {

/// A place a sample; y below 0 does not occur. NaN y: no sample there.
struct Series {
  std::string name;
  std::vector<double> x, y;
};

/// Lines over x on a logarithmic scale; y from 0.
[[nodiscard]] std::string line_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                                    const std::vector<Series>& series);

/// Groups of bars from 0, series[i].y[group] high, with a line across at `reference`.
[[nodiscard]] std::string bar_plot(const std::string& title, const std::string& y_label,
                                   const std::vector<std::string>& groups, const std::vector<Series>& series,
                                   double reference);

}  // namespace strahl::bench

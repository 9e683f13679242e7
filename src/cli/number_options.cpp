// SPDX-License-Identifier: MIT
#include "cli/number_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "scene/xml/parse_value.h"

namespace strahl::cli {
namespace {

/// `wanted` says what the value must be, and `holds` whether a finite number is that.
CLI::Option* require(CLI::Option* option, const std::string& wanted, const std::function<bool(double)>& holds) {
  const auto fault = [wanted, holds](const std::string& text) {
    const std::optional<double> value = parse_number(text);
    if (value && std::isfinite(*value) && holds(*value)) return std::string();
    return fmt::format("must be {}, not \"{}\"", wanted, text);
  };
  return option->check(fault, "");
}

}  // namespace

CLI::Option* require_finite(CLI::Option* option) {
  return require(option, "a finite number", [](double) { return true; });
}

CLI::Option* require_positive(CLI::Option* option) {
  return require(option, "a finite number > 0", [](double value) { return value > 0; });
}

CLI::Option* require_between(CLI::Option* option, double least, double most) {
  return require(option, fmt::format("a number from {} to {}", least, most),
                 [least, most](double value) { return value >= least && value <= most; });
}

}  // namespace strahl::cli

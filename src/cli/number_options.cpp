// SPDX-License-Identifier: MIT
#include "cli/number_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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

CLI::Option* require_whole(CLI::Option* option) {
  // CLI11 takes a leading 0 for the sign of an octal number, and 0x for one of a hexadecimal.
  const auto as_decimal = [](std::string& text) {
    const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
    if (sign == text.size() || text.find_first_not_of("0123456789", sign) != std::string::npos)
      return fmt::format("must be a whole number, not \"{}\"", text);
    text.erase(sign, std::min(text.find_first_not_of('0', sign), text.size() - 1) - sign);
    return std::string();
  };
  return option->transform(CLI::Validator(as_decimal, ""));
}

}  // namespace strahl::cli

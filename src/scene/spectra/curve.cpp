// SPDX-License-Identifier: MIT
#include "scene/spectra/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "errors.h"
#include "image/file_bytes.h"
#include "scene/spectra/observer_table.h"
#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

constexpr std::uint64_t largest_file = std::uint64_t{1} << 24;

}  // namespace

double SpectrumCurve::at(double wavelength) const {
  const auto after = std::lower_bound(wavelengths.begin(), wavelengths.end(), wavelength);
  if (after == wavelengths.end()) return 0;
  const auto i = static_cast<std::size_t>(after - wavelengths.begin());
  if (wavelengths[i] == wavelength) return values[i];
  if (i == 0) return 0;
  const double share = (wavelength - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

bool is_curve(const SpectrumCurve& curve) {
  const std::vector<double>& w = curve.wavelengths;
  const auto is_finite = [](double x) { return std::isfinite(x); };
  return w.size() >= 2 && w.size() == curve.values.size() && std::all_of(w.begin(), w.end(), is_finite) &&
         std::all_of(curve.values.begin(), curve.values.end(), is_finite) &&
         std::adjacent_find(w.begin(), w.end(), std::greater_equal<>()) == w.end();
}

std::optional<SpectrumCurve> curve_of_pairs(std::string_view text) {
  SpectrumCurve curve;
  for (const std::string_view pair : split_list(text)) {
    const std::size_t colon = pair.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const std::optional<double> wavelength = parse_number(pair.substr(0, colon));
    const std::optional<double> value = parse_number(pair.substr(colon + 1));
    if (!wavelength || !value) return std::nullopt;
    curve.wavelengths.push_back(*wavelength);
    curve.values.push_back(*value);
  }
  return is_curve(curve) ? std::optional(curve) : std::nullopt;
}

SpectrumCurve curve_of_file(const std::string& path) {
  const std::string text = read_file(path, largest_file);
  SpectrumCurve curve;
  int line = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view row = std::string_view(text).substr(at, end - at);
    at = end + 1;
    ++line;
    const std::vector<std::string_view> words = split_list(row.substr(0, row.find('#')));
    if (words.empty()) continue;
    const std::optional<double> wavelength = parse_number(words[0]);
    const std::optional<double> value = words.size() >= 2 ? parse_number(words[1]) : std::nullopt;
    if (!wavelength || !value)
      throw InputError(fmt::format("{}:{}: not a wavelength in nanometres and a value", path, line));
    curve.wavelengths.push_back(*wavelength);
    curve.values.push_back(*value);
  }
  if (!is_curve(curve))
    throw InputError(
        fmt::format("{}: needs finite values at two wavelengths or more that ascend from line to line", path));
  return curve;
}

SpectrumCurve planck_curve(double kelvin, double first, double last) {
  constexpr double h = 6.62607015e-34, c = 299792458.0, k = 1.380649e-23;  // SI, exact since 2019
  SpectrumCurve curve;
  const auto add = [&](double nm) {
    const double lambda = nm * 1e-9;
    curve.wavelengths.push_back(nm);
    curve.values.push_back(1e-9 * 2 * h * c * c / (std::pow(lambda, 5) * std::expm1(h * c / (lambda * k * kelvin))));
  };
  const double end = observer_first + observer_step * static_cast<double>(observer_table.size() - 1);
  const double from = std::max(first, observer_first), to = std::min(last, end);
  add(from);
  for (double nm = observer_first; nm <= end; nm += 1)
    if (nm > from && nm < to) add(nm);
  add(to);
  return curve;
}

}  // namespace strahl

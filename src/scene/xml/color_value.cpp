// SPDX-License-Identifier: MIT
// strahl computes in RGB: a constant spectrum is grey, a tabulated one its mean until spectra come.
#include "scene/xml/color_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

std::string shown(const Rgb& c) {
  return c.r == c.g && c.g == c.b ? fmt::format("{}", c.r) : fmt::format("{}, {}, {}", c.r, c.g, c.b);
}

std::optional<Rgb> checked(const std::optional<Rgb>& color, const XmlElement& element, Diagnostics& diagnostics) {
  const bool finite = color && is_finite(Vec3{color->r, color->g, color->b});
  if (finite) return color;
  diagnostics.error(element.where, fmt::format("\"{}\" in <{}> is not {}", element.text("value"), element.tag,
                                               color ? "finite" : "a colour (1 or 3 numbers, or #rrggbb)"));
  return std::nullopt;
}

std::optional<Rgb> listed_color(std::string_view text) {
  if (const std::optional<Rgb> hex = parse_hex_color(text)) return hex;
  const std::optional<std::vector<double>> values = parse_numbers(text);
  if (!values) return std::nullopt;
  if (values->size() == 1) return Rgb{(*values)[0], (*values)[0], (*values)[0]};
  return values->size() == 3 ? std::optional(Rgb{(*values)[0], (*values)[1], (*values)[2]}) : std::nullopt;
}

std::optional<Rgb> mean_of_pairs(std::string_view text) {
  double sum = 0;
  const std::vector<std::string_view> pairs = split_list(text);
  for (const std::string_view pair : pairs) {
    const std::size_t colon = pair.find(':');
    if (colon == std::string::npos || !parse_number(pair.substr(0, colon))) return std::nullopt;
    const std::optional<double> value = parse_number(pair.substr(colon + 1));
    if (!value) return std::nullopt;
    sum += *value / static_cast<double>(pairs.size());
  }
  return Rgb{sum, sum, sum};
}

std::optional<Rgb> substituted(const XmlElement& element, const std::string& what, const Rgb& substitute,
                               Diagnostics& diagnostics) {
  diagnostics.unknown(element.where,
                      fmt::format("{} is not supported yet; the constant {} takes its place", what, shown(substitute)));
  return substitute;
}

std::optional<Rgb> read_spectrum(const XmlElement& element, const Rgb& substitute, Diagnostics& diagnostics) {
  if (const std::optional<std::string_view> type = element.attribute("type"))
    return substituted(element, fmt::format("<spectrum type=\"{}\">", *type), substitute, diagnostics);
  const std::optional<std::string_view> value = element.attribute("value");
  if (!value) return substituted(element, "a spectrum from a file", substitute, diagnostics);
  if (value->find(':') == std::string::npos) return checked(listed_color(*value), element, diagnostics);
  const std::optional<Rgb> mean = checked(mean_of_pairs(*value), element, diagnostics);
  if (mean)
    diagnostics.unknown(element.where,
                        fmt::format("strahl computes in RGB; the spectrum's mean {} takes its place", mean->r));
  return mean;
}

}  // namespace

std::optional<Rgb> read_color(const XmlElement& element, const Rgb& substitute, Diagnostics& diagnostics) {
  if (element.tag == "spectrum") return read_spectrum(element, substitute, diagnostics);
  if (element.tag == "texture" || element.tag == "volume")
    return substituted(element, fmt::format("<{} type=\"{}\">", element.tag, element.text("type")), substitute,
                       diagnostics);
  if (element.tag == "blackbody") return substituted(element, "<blackbody>", substitute, diagnostics);
  std::optional<Rgb> color = checked(listed_color(element.text("value")), element, diagnostics);
  const bool is_encoded = element.tag == "srgb" && !parse_hex_color(element.text("value"));
  if (color && is_encoded)
    color = Rgb{linear_from_srgb(color->r), linear_from_srgb(color->g), linear_from_srgb(color->b)};
  return color;
}

Rgb clamped_reflectance(const Rgb& reflectance, const SourceLocation& where, std::string_view name,
                        Diagnostics& diagnostics) {
  const auto clamped = [](double x) { return std::clamp(x, 0.0, 1.0); };
  const Rgb inside{clamped(reflectance.r), clamped(reflectance.g), clamped(reflectance.b)};
  if (inside != reflectance)
    diagnostics.warning(
        where, fmt::format("\"{}\" is {}, outside [0, 1]; {} is used", name, shown(reflectance), shown(inside)));
  return inside;
}

}  // namespace strahl

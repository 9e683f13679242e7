// SPDX-License-Identifier: MIT
// strahl computes in RGB: a spectrum becomes what the CIE 1931 standard observer sees of it.
#include "scene/xml/color_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/file_bytes.h"
#include "scene/readers/foreign_plugins.h"
#include "scene/spectra/observer.h"
#include "scene/xml/parse_value.h"
#include "scene/xml/typed_spectrum.h"

namespace strahl {

namespace {

std::string shown(const Rgb& c) {
  return c.r == c.g && c.g == c.b ? fmt::format("{}", c.r) : fmt::format("{}, {}, {}", c.r, c.g, c.b);
}

Rgb scaled(double by, const Rgb& c) { return {by * c.r, by * c.g, by * c.b}; }

std::optional<Rgb> checked(const std::optional<Rgb>& color, const XmlElement& element, Diagnostics& diagnostics) {
  const bool finite = color && is_finite(*color);
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

std::optional<Rgb> constant_spectrum(const XmlElement& element, ColorUse use, Diagnostics& diagnostics) {
  const std::string_view text = element.text("value");
  const std::optional<Rgb> color = checked(listed_color(text), element, diagnostics);
  const bool is_one_number = parse_number(text).has_value();
  return color && is_one_number && use == ColorUse::emission ? std::optional(rgb_of_constant_emission(color->r))
                                                             : color;
}

std::optional<Rgb> read_spectrum(const XmlElement& element, ColorUse use, Diagnostics& diagnostics) {
  const std::optional<std::string_view> value = element.attribute("value"), file = element.attribute("filename");
  if (value.has_value() == file.has_value()) {
    diagnostics.error(element.where, "<spectrum> needs either value or filename");
    return std::nullopt;
  }
  if (value && value->find(':') == std::string_view::npos) return constant_spectrum(element, use, diagnostics);
  std::optional<SpectrumCurve> curve;
  if (value) {
    curve = curve_of_pairs(*value);
    if (!curve)
      diagnostics.error(element.where, fmt::format("\"{}\" in <spectrum> is no list such as \"400:0.1, 700:0.3\" "
                                                   "of two or more, whose values are finite and whose wavelengths "
                                                   "ascend",
                                                   *value));
  } else {
    const std::string path(*file);
    if (const std::string obstacle = unreadable_because(path); !obstacle.empty()) {
      diagnostics.unreadable(element.where, path, obstacle);
      return std::nullopt;
    }
    diagnostics.opened(path);
    try {
      curve = curve_of_file(path);
    } catch (const InputError& fault) {
      diagnostics.error(element.where, fault.what());
    }
  }
  return curve ? std::optional(color_of_curve(*curve, use)) : std::nullopt;
}

/// "5000" or, in Mitsuba 0.x, "5000K".
std::optional<Rgb> read_blackbody(const XmlElement& element, ColorUse use, Diagnostics& diagnostics) {
  std::string_view text = element.text("temperature");
  if (text.ends_with('K') || text.ends_with('k')) text.remove_suffix(1);
  const std::optional<double> kelvin = parse_number(text);
  const std::optional<double> scale = parse_number(element.attribute("scale").value_or("1"));
  if (kelvin && scale && std::isfinite(*scale) && *kelvin > 0 && std::isfinite(*kelvin))
    return scaled(*scale, color_of_curve(planck_curve(*kelvin), use));
  diagnostics.error(element.where, "<blackbody> needs a temperature in kelvin, greater than 0, and a finite scale");
  return std::nullopt;
}

/// Of a <texture>, <spectrum> or <volume> that is no colour.
std::string not_available_here(const XmlElement& element) {
  std::vector<std::string> known = spectrum_types();
#define TEXTURE(name) known.emplace_back(#name);
#include "../../../cl/textures/textures.def"
#undef TEXTURE
  if (element.tag == "volume") known = {"constvolume", "gridvolume"};
  const std::string_view type = element.text("type");
  const bool is_ours = std::find(known.begin(), known.end(), type) != known.end();
  return is_ours ? fmt::format("{} \"{}\" is not supported yet here", element.tag, type)
                 : not_available(element.tag, type, known);
}

}  // namespace

std::optional<Rgb> read_color(const XmlElement& element, ColorUse use, const Rgb& substitute,
                              Diagnostics& diagnostics) {
  if (element.tag == "spectrum" && !element.attribute("type")) return read_spectrum(element, use, diagnostics);
  if (element.tag == "blackbody") return read_blackbody(element, use, diagnostics);
  if (element.tag == "spectrum" || element.tag == "texture" || element.tag == "volume") {
    diagnostics.unknown(element.where, fmt::format("{}; the constant {} takes its place", not_available_here(element),
                                                   shown(substitute)));
    return substitute;
  }
  std::optional<Rgb> color = checked(listed_color(element.text("value")), element, diagnostics);
  const bool is_encoded = element.tag == "srgb" && !parse_hex_color(element.text("value"));
  if (color && is_encoded)
    color = Rgb{linear_from_srgb(color->r), linear_from_srgb(color->g), linear_from_srgb(color->b)};
  return color;
}

Rgb color_of_curve(const SpectrumCurve& curve, ColorUse use) {
  if (use == ColorUse::emission) return rgb_of_emission(curve);
  const Rgb weight = rgb_of_weight(curve);
  if (use != ColorUse::reflectance) return weight;
  return {std::min(weight.r, 1.0), std::min(weight.g, 1.0), std::min(weight.b, 1.0)};
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

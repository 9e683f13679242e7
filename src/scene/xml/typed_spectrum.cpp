// SPDX-License-Identifier: MIT
// Mitsuba 3's spectrum plugins. Its RGB variants evaluate "uniform" and "d65" as greys; curves and black bodies, which
// they lack, become what its spectral variants show of them.
#include "scene/xml/typed_spectrum.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/readers/plugin_table.h"
#include "scene/spectra/curve.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

using SpectrumReader = std::optional<Rgb> (*)(Properties&, ColorUse);

std::optional<Rgb> read_uniform(Properties& properties, ColorUse) {
  properties.accept({"wavelength_min", "wavelength_max"});  // Which Mitsuba's RGB variants leave out.
  return grey(properties.number("value").value_or(1));
}

std::optional<Rgb> read_d65(Properties& properties, ColorUse use) {
  // Those that strahl has are read before (read_texture.h).
  if (const std::vector<const XmlElement*> textures = properties.objects("texture"); !textures.empty())
    return read_color(*textures.front(), use, grey(use == ColorUse::emission ? 1 : 0.5), properties.diagnostics());
  const double scale = properties.number("scale").value_or(1);
  // Whoever asked clamps a reflectance, once it is scaled.
  const ColorUse of_color = use == ColorUse::reflectance ? ColorUse::unclamped : use;
  const Rgb color = properties.color("color", of_color, grey(1)).value_or(grey(1));
  return Rgb{scale * color.r, scale * color.g, scale * color.b};
}

std::optional<Rgb> read_srgb(Properties& properties, ColorUse use) {
  properties.accept({"unbounded"});
  return properties.color("color", use, grey(1)).value_or(grey(1));
}

std::optional<Rgb> read_rawconstant(Properties& properties, ColorUse use) {
  const XmlElement* given = properties.peek("value");
  if (given == nullptr || (given->tag != "vector" && given->tag != "point"))
    return properties.color("value", use, grey(1)).value_or(grey(1));
  const std::optional<Vec3> value = properties.vector("value");
  return value ? std::optional(Rgb{value->x, value->y, value->z}) : std::nullopt;
}

std::optional<Rgb> of_lists(Properties& properties, const SpectrumCurve& curve, ColorUse use) {
  if (is_curve(curve)) return color_of_curve(curve, use);
  properties.diagnostics().error(properties.where(),
                                 fmt::format("{} needs as many finite values as wavelengths, two or "
                                             "more, which ascend",
                                             properties.title()));
  return std::nullopt;
}

std::optional<Rgb> read_regular(Properties& properties, ColorUse use) {
  const double from = properties.number("wavelength_min").value_or(360);
  const double to = properties.number("wavelength_max").value_or(830);
  SpectrumCurve curve;
  curve.values = properties.numbers("values").value_or(std::vector<double>{});
  const std::size_t count = curve.values.size();
  for (std::size_t i = 0; i < count; ++i)
    curve.wavelengths.push_back(
        count == 1 ? from : from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1));
  return of_lists(properties, curve, use);
}

std::optional<Rgb> read_irregular(Properties& properties, ColorUse use) {
  SpectrumCurve curve;
  curve.wavelengths = properties.numbers("wavelengths").value_or(std::vector<double>{});
  curve.values = properties.numbers("values").value_or(std::vector<double>{});
  return of_lists(properties, curve, use);
}

std::optional<Rgb> read_blackbody(Properties& properties, ColorUse use) {
  const double first = std::max(properties.number("wavelength_min").value_or(360), 360.0);
  const double last = std::min(properties.number("wavelength_max").value_or(830), 830.0);
  if (!properties.has("temperature")) {
    properties.diagnostics().error(properties.where(),
                                   fmt::format("{} needs the float \"temperature\"", properties.title()));
    return std::nullopt;
  }
  const std::optional<double> kelvin = properties.positive("temperature");
  if (!(first < last)) {
    properties.diagnostics().error(properties.where(),
                                   fmt::format("{} shines at no wavelength between 360 and 830 nm; wavelength_min must "
                                               "be less than wavelength_max",
                                               properties.title()));
    return std::nullopt;
  }
  return kelvin ? std::optional(color_of_curve(planck_curve(*kelvin, first, last), use)) : std::nullopt;
}

const PluginTable<SpectrumReader>& spectrum_readers() {
  static const PluginTable<SpectrumReader> all{{"uniform", read_uniform},    {"d65", read_d65},
                                               {"srgb", read_srgb},          {"rawconstant", read_rawconstant},
                                               {"regular", read_regular},    {"irregular", read_irregular},
                                               {"blackbody", read_blackbody}};
  return all;
}

}  // namespace

bool is_typed_spectrum(const XmlElement& element) {
  return (element.tag == "spectrum" || element.tag == "texture") &&
         find_plugin(spectrum_readers(), element.text("type")) != nullptr;
}

std::vector<std::string> spectrum_types() { return types_of(spectrum_readers()); }

std::optional<Rgb> read_typed_spectrum(Properties& properties, ColorUse use) {
  const SpectrumReader* reader = find_plugin(spectrum_readers(), properties.type());
  std::optional<Rgb> color = (*reader)(properties, use);
  properties.report_unknown();
  return color;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// A spectrum as measured: values at wavelengths, linear between them and 0 outside.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace strahl {

struct SpectrumCurve {
  std::vector<double> wavelengths;  ///< Nanometres, ascending, at least two.
  std::vector<double> values;       ///< As many, finite.

  [[nodiscard]] double at(double wavelength) const;
};

/// "400:0.1, 700:0.3". None where the text is no such list or the wavelengths do not ascend.
[[nodiscard]] std::optional<SpectrumCurve> curve_of_pairs(std::string_view text);
/// A text file with a wavelength and a value on each line; further columns are ignored, as by Mitsuba, and so is what
/// stands behind a #. Throws InputError with what is wrong and the line.
[[nodiscard]] SpectrumCurve curve_of_file(const std::string& path);
/// Emitted radiance of a black body, W / (m^2 sr nm), every nanometre from 360 to 830, but for what lies outside of
/// [first, last], which must overlap (M. Planck, "Ueber das Gesetz der Energieverteilung im Normalspectrum", 1901).
[[nodiscard]] SpectrumCurve planck_curve(double kelvin, double first = 360, double last = 830);

/// Finite values at two ascending wavelengths or more: between one and nothing there is no light.
[[nodiscard]] bool is_curve(const SpectrumCurve& curve);

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Values of each pixel that are written beside the picture ("arbitrary output variables"): of its first sample, or of
// all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace strahl {

/// normal: the shading normal; geo_normal: that of the surface itself. numeric_error: how far the hit's t is off, in
/// ulps of float (render/numeric_error.h). Of all samples: xyz, the mean radiance in CIE 1931's X, Y, Z; xyz_squared,
/// the mean of their squares.
enum class Aov {
  depth,
  normal,
  position,
  uv,
  shape_id,
  primitive_id,
  numeric_error,
  albedo,
  geo_normal,
  xyz,
  xyz_squared
};

[[nodiscard]] constexpr bool is_of_first_sample(Aov aov) { return aov != Aov::xyz && aov != Aov::xyz_squared; }

/// One that a scene asks for (integrators aov and moment), and the layer of an EXR file that holds it.
struct NamedAov {
  std::string name;
  Aov aov = Aov::depth;
  friend bool operator==(const NamedAov&, const NamedAov&) = default;
};

/// In bytes. A file of OpenEXR cuts names of channels that are longer than 255.
inline constexpr std::size_t longest_layer_name = 250;

/// Its channels, named as Mitsuba's: "NAME.T" of a depth, X Y Z of position, normal and xyz, U V, R G B of albedo, I of
/// ids.
[[nodiscard]] std::vector<std::string> channels_of(const NamedAov& named);

/// Why a file could not hold them side by side, a sentence each: two have a channel in common, or one is
/// numeric_error, which has no such name, or has a name that is too long.
[[nodiscard]] std::vector<std::string> aov_faults(const std::vector<NamedAov>& aovs);

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Values of the first sample of each pixel that are written beside the picture ("arbitrary output variables").
#pragma once

#include <string>
#include <vector>

namespace strahl {

/// normal: the shading normal. numeric_error: how far the hit's t is off, in ulps of float (render/numeric_error.h).
enum class Aov { depth, normal, position, uv, shape_id, primitive_id, numeric_error, albedo };

/// One that a scene asks for (integrator aov), and the layer of an EXR file that holds it.
struct NamedAov {
  std::string name;
  Aov aov = Aov::depth;
  friend bool operator==(const NamedAov&, const NamedAov&) = default;
};

/// Its channels, named as Mitsuba's: "NAME.T" of a depth, X Y Z of position and normal, U V, R G B of albedo, I of ids.
[[nodiscard]] std::vector<std::string> channels_of(const NamedAov& named);

}  // namespace strahl

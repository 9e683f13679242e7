// SPDX-License-Identifier: MIT
// The properties of each integrator that the host needs, one row each (integrators.cpp). An entry of
// cl/integrators/integrators.def without a row does not compile.
#pragma once

#include <string>
#include <vector>

namespace strahl::kinds {

/// How paths continue from a surface.
enum class Follows {
  nothing,
  one_way,  ///< One direction that the material draws; only emission counts there.
  mirrors,  ///< Mirror reflections, as long as there are mirrors.
  paths     ///< Directions that the material draws, until Russian roulette ends the path.
};

/// Point and directional lights.
enum class Lamps {
  unused,
  taken,  ///< All of them light every surface; of the other lights one is drawn.
  drawn   ///< One of all lights is drawn.
};

struct IntegratorFacts {
  const char* name;
  Lamps lamps = Lamps::unused;  ///< Other than `unused`: materials reflect light.
  Follows follows = Follows::nothing;
  bool shows_emission = false;  ///< Emitters are visible.
  bool reads_shading = false;   ///< Interpolated normals change the picture.
  bool asks_openness = false;   ///< Draws ambient-occlusion rays.
  bool is_noiseless = false;    ///< A ray's value is exact: one sample by default.
  bool is_length = false;       ///< The picture is a distance, not light.
  bool goes_through = false;    ///< Media count, and light goes through masks unbent.
  bool from_lights = false;     ///< Paths begin on lights and add to any pixels (docs/decisions/0032-light-tracing.md).
  bool from_camera = false;     ///< And others on the camera, which meet them (docs/decisions/0033-bidirectional.md).

  /// The kernel file of its programs, below cl/.
  [[nodiscard]] const char* kernel() const {
    if (!from_lights) return "kernels/render.cl";
    return from_camera ? "kernels/bidirectional.cl" : "kernels/light_tracing.cl";
  }
  [[nodiscard]] bool is_lit() const { return lamps != Lamps::unused; }
  /// max_depth limits more than the first surface's light.
  [[nodiscard]] bool has_depth() const { return follows == Follows::mirrors || follows == Follows::paths; }
  /// Directions that materials draw find emission too, weighted against lights that are drawn.
  [[nodiscard]] bool finds_emission() const {
    return !from_lights && (follows == Follows::paths || follows == Follows::one_way);
  }
};

/// Throws std::logic_error for a name that is no entry.
[[nodiscard]] const IntegratorFacts& integrator(const std::string& name);

/// Every entry, in the list's order.
[[nodiscard]] const std::vector<std::string>& integrator_names();

}  // namespace strahl::kinds

// SPDX-License-Identifier: MIT
// The properties of each kind of light other than shapes that the host needs, one row each (light_rows.h). A kind of
// Light::emitter without a row does not compile.
#pragma once

#include <string>
#include <vector>

#include "kinds/light_reach.h"
#include "kinds/map_vec3.h"
#include "scene/model/scene.h"

namespace strahl {
struct UploadFrame;
}

namespace strahl::kinds {

struct LightFacts {
  const char* entry;      ///< Of cl/lights/lights.def.
  bool is_delta = false;  ///< A single direction at each point, so no ray hits it (Lamps in kinds/integrators.h).
  bool is_beam = false;   ///< A single direction at each of its places: only paths that begin there find its light.
  bool is_far = false;    ///< Infinitely far away: it reaches every point alike.
  bool is_background = false;  ///< Rays that leave the scene see it; a scene has at most one, and a sun.
  bool is_sun = false;         ///< It stands before the other.
  bool is_even = false;        ///< The same from all directions.
  bool is_alike = false;       ///< Kernels ask several of them together (cl/scene/layout.h, LIGHT_ALIKE).
};

[[nodiscard]] const LightFacts& light(const Light& light);

/// Whether directions that the scene's materials draw find all light, and none of it by far too seldom: none of them
/// has a lobe that it hardly draws.
[[nodiscard]] bool finds_all_emission(const Scene& scene);

/// Whether directions to it are drawn. To one of sampling_weight 0 they are not, nor, where directions that materials
/// draw find all light, to one that is even: materials do so about in proportion to what they reflect of it
/// (docs/decisions/0028-many-lights.md).
[[nodiscard]] bool is_drawn(const Light& light, const Scene& scene);

/// Its parameters, as its file in cl/lights says, in the frame's units.
[[nodiscard]] std::vector<double> light_reals(const Light& light, const UploadFrame& frame);

[[nodiscard]] LightReach light_reach(const Light& light, const UploadFrame& frame);

/// Its intensity, irradiance or radiance; of an image what multiplies it.
[[nodiscard]] const Rgb& light_colour(const Light& light);
[[nodiscard]] Rgb& light_colour(Light& light);
/// Index of the texture that multiplies that; -1: none.
[[nodiscard]] int light_texture(const Light& light);
/// Of all directions, channel by channel.
[[nodiscard]] Rgb brightest(const Light& light);
[[nodiscard]] bool gives_light(const Light& light);
[[nodiscard]] bool gives_light(const Rgb& radiance);
/// By its radiance, not as a beam.
[[nodiscard]] bool gives_light(const Shape& shape);
/// Whether a ray can hit it or see it in the background.
[[nodiscard]] bool light_glows(const Light& light);

/// Moves its positions. point: maps a position.
void move(Light& light, const MapVec3& point);
/// Changes the unit of length by a factor; surfaces keep their brightness.
void scale(Light& light, double factor);
/// Mirrors its directions. flip_x: x becomes -x.
void mirror(Light& light, const MapVec3& flip_x);

/// A description of its fault; empty where there is none.
[[nodiscard]] std::vector<std::string> light_faults(const Light& light);

}  // namespace strahl::kinds

// SPDX-License-Identifier: MIT
// The robust tier's headers compiled for the host: one primitive alone, and kernels/intersect.cl as a function.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace strahl::test {

/// Routes to the same bits: wide arithmetic in double words, as on devices without doubles, or in doubles; and exact
/// decisions alone (docs/decisions/0023-correctly-rounded-t.md).
enum class Route { double_words, doubles, exact };

/// t of the nearest hit in units of the direction as given, infinite for a miss. kind, planes: of shapes.def, one
/// primitive; ray: RAY_REALS of cl/scene/layout.h; has_left: the ray has just left the primitive.
[[nodiscard]] float robust_t(std::string_view kind, std::span<const float> planes, std::span<const float> ray,
                             bool has_left, Route = Route::double_words);

/// Whether wide arithmetic tells t of a triangle or a sphere that the ray hits, so that nothing is decided exactly.
[[nodiscard]] bool robust_is_told(std::string_view kind, std::span<const float> planes, std::span<const float> ray,
                                  Route);

/// x, y, z and radius of the ball that a primitive lies in (cl/shapes/ball.h). Throws std::logic_error for an unknown
/// kind.
[[nodiscard]] std::array<float, 4> robust_ball(std::string_view kind, std::span<const float> planes);

/// Every entry and feature is active: for scenes packed with RenderSettings::generic at that width.
void robust_intersect(int lanes, const float* geometry, const float* shading, const std::int32_t* index,
                      const float* rays, const std::int32_t* left, std::size_t count, float* hits, std::int32_t* ids);

/// One route's own, of a unit each (kernels_body.h).
#define ROUTE_KERNELS(route)                                                                                       \
  namespace route {                                                                                                \
  float robust_t(std::string_view kind, std::span<const float> planes, std::span<const float> ray, bool has_left); \
  bool robust_is_told(std::string_view kind, std::span<const float> planes, std::span<const float> ray);           \
  }
ROUTE_KERNELS(double_words)
ROUTE_KERNELS(doubles)
ROUTE_KERNELS(exact)
#undef ROUTE_KERNELS

namespace double_words {
std::array<float, 4> robust_ball(std::string_view kind, std::span<const float> planes);
void robust_intersect(int lanes, const float* geometry, const float* shading, const std::int32_t* index,
                      const float* rays, const std::int32_t* left, std::size_t count, float* hits, std::int32_t* ids);
}  // namespace double_words

}  // namespace strahl::test

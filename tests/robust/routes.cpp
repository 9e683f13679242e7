// SPDX-License-Identifier: MIT
#include "robust/kernels.h"

namespace strahl::test {

float robust_t(std::string_view kind, std::span<const float> planes, std::span<const float> ray, bool has_left,
               Route route) {
  if (route == Route::doubles) return doubles::robust_t(kind, planes, ray, has_left);
  if (route == Route::exact) return exact::robust_t(kind, planes, ray, has_left);
  return double_words::robust_t(kind, planes, ray, has_left);
}

bool robust_is_told(std::string_view kind, std::span<const float> planes, std::span<const float> ray, Route route) {
  if (route == Route::doubles) return doubles::robust_is_told(kind, planes, ray);
  if (route == Route::exact) return exact::robust_is_told(kind, planes, ray);
  return double_words::robust_is_told(kind, planes, ray);
}

std::array<float, 4> robust_ball(std::string_view kind, std::span<const float> planes) {
  return double_words::robust_ball(kind, planes);
}

void robust_intersect(int lanes, const float* geometry, const float* shading, const std::int32_t* index,
                      const float* rays, const std::int32_t* left, std::size_t count, float* hits, std::int32_t* ids) {
  double_words::robust_intersect(lanes, geometry, shading, index, rays, left, count, hits, ids);
}

}  // namespace strahl::test

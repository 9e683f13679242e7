// SPDX-License-Identifier: MIT
// Lights of one tier; needs REAL_BITS. No guard: once a unit.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "physics/light_tiers.h"

#define HAS_HIDE_EMITTERS 1
#define HAS_ERROR_SUMS 1

// Internal to the unit: the headers of every tier give their functions the same names.
namespace {
namespace tier {
#include "math/vec3.h"
#define LANES 1
#include "physics/shading_width.h"
}  // namespace tier
}  // namespace

namespace strahl::test {

DrawnLight<tier::real> drawn_light(const HostBuffers<tier::real>& buffers, std::uint32_t sample, int depth,
                                   const Triple<tier::real>& from) {
  using namespace tier;
  const Scene scene{buffers.geometry, buffers.shading, buffers.index, nullptr, nullptr};
  Paths_w_1 path;
  paths_none_w_1(&path);
  path.depth = depth;
  path.sample = sample_begin_w_1(&scene, 0, sample);
  const LightNumbers_w_1 numbers = light_numbers_w_1(&scene, &path.sample, depth);
  DrawnLight<real> drawn;
  const real3 at = vec3(from[0], from[1], from[2]);
  drawn.light = choose_light_w_1(&scene, &path.sample, depth, at).light;
  const LightSample_w_1 light = light_sample_w_1(&scene, ~0, drawn.light, at, numbers);
  drawn.towards = {light.towards.x, light.towards.y, light.towards.z};
  drawn.t_max = light.t_max;
  drawn.id = light.aim;
  drawn.radiance = {light.radiance.x, light.radiance.y, light.radiance.z};
  drawn.density = light.density;
  drawn.is_delta = light.is_delta != 0;
  return drawn;
}

}  // namespace strahl::test

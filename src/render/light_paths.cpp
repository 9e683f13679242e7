// SPDX-License-Identifier: MIT
#include "render/light_paths.h"

#include <fmt/format.h>

#include <algorithm>

#include "errors.h"
#include "kinds/integrators.h"
#include "kinds/lights.h"
#include "packing/cl_layout.h"
#include "settings/sampling.h"

namespace strahl {
namespace {

bool is_far(const Light& light) { return kinds::light(light).is_far && kinds::gives_light(light); }

/// Far lights enter through a disc as large as what is bounded, and an infinite area has no place to begin on.
void require_finite(const Scene& scene) {
  const auto far = std::find_if(scene.lights.begin(), scene.lights.end(), is_far);
  for (const Shape& shape : scene.shapes) {
    if (bounds(shape)) continue;
    if (far != scene.lights.end())
      throw SceneError(
          {{Severity::error, shape.where,
            fmt::format("integrator {} cannot light an infinite shape from afar (a light of type {}): take "
                        "a large finite one, or integrator path",
                        scene.integrator.name, kinds::light(*far).entry)}});
    if (shape.radiance || shape.exitance)
      throw SceneError({{Severity::error, shape.where,
                         fmt::format("integrator {} cannot begin paths on an emitter of infinite area: take a large "
                                     "finite one, or integrator path",
                                     scene.integrator.name)}});
  }
}

/// Which shapes a vertex is within is not kept, so that it could be joined with others.
void require_no_priorities(const Scene& scene) {
  for (const Shape& shape : scene.shapes)
    if (shape.priority)
      throw SceneError({{Severity::error, shape.where,
                         fmt::format("integrator {} does not know glass that overlaps by priority: leave the priority "
                                     "out, or take integrator path",
                                     scene.integrator.name)}});
}

}  // namespace

void require_light_paths(const Scene& scene, const RenderSettings& settings) {
  const std::string& name = scene.integrator.name;
  if (!kinds::integrator(name).from_lights) return;
  const auto refuse = [&](const std::string& what) {
    throw UsageError(fmt::format("integrator {} begins its paths on lights: {}", name, what));
  };
  if (!settings.aovs.empty()) refuse("--aov needs a camera ray in every pixel; take integrator path for the values");
  if (settings.texture_lod) refuse("--texture-lod needs the width of camera rays");
  if (const std::string choice = settings.light_choice.value_or("power"); choice == "each" || choice == "tree")
    refuse("lights are weighed by " + choice + " at a point, and there is none; --light-choice power or uniform");
  if (resolve_sampling(scene).kind == SamplerKind::centre)
    refuse("they never meet the pixels' centres alone; take another sampler");
  if (!scene.media.empty())
    throw SceneError({{Severity::error, scene.media.front().where,
                       fmt::format("integrator {} follows light between surfaces only, and here is a medium: take "
                                   "integrator volpath",
                                   name)}});
  if (kinds::integrator(name).from_camera) require_no_priorities(scene);
  require_finite(scene);
}

int most_light_paths(const Window& window, bool has_error_sums) {
  const std::int64_t pixels = std::max<std::int64_t>(1, std::int64_t{window.width()} * window.height());
  const std::int64_t sums = has_error_sums ? layout::FILM_SUBSUMS : 1;
  return static_cast<int>(std::clamp<std::int64_t>((std::int64_t{1} << 31) / pixels * sums, 1, max_spp));
}

void require_room_for_splats(const DeviceInfo& device, std::uint64_t bytes, std::uint64_t memory_left) {
  if (bytes <= std::min(device.max_allocation, memory_left)) return;
  const std::uint64_t scene = device.global_memory - std::min(device.global_memory, memory_left);
  throw NoDeviceError(
      fmt::format("light paths may end in any pixel, so their film is in memory as a whole: {} KiB, and {} has {} KiB "
                  "left of {} and allocates {} KiB at a time; choose a smaller picture, a part of it (--crop), "
                  "--no-error (a quarter of the memory) or {}",
                  bytes >> 10, device.text(), memory_left >> 10, device.memory_text(), device.max_allocation >> 10,
                  device.room_for(scene + bytes)));
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "render/light_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "errors.h"
#include "kinds/integrators.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "scene/light_path_fault.h"
#include "settings/sampling.h"

namespace strahl {
namespace {

/// In pixels: 64 steps of the numbers that tell where light paths end, at the picture's far end. Of fewer, which lie on
/// both borders, a narrow filter would take too many.
double least_splat_radius(const Film& film, Precision precision) {
  if (precision == Precision::fp64) return 0x1p-10;
  const auto side = std::bit_ceil(static_cast<unsigned>(std::max({1, film.width, film.height})));
  return std::max(0x1p-10, 64 * 0x1p-24 * side);
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
  if (settings.disabled.contains("PIXEL_FILTER"))
    refuse("they never meet the pixels' centres alone; leave --disable PIXEL_FILTER out");
  const double radius = filter_densities(scene.film.filter).half_width;
  if (const double least = least_splat_radius(scene.film, settings.precision); radius < least)
    throw SceneError({{Severity::error, scene.film.where,
                       fmt::format("integrator {} draws each path's pixel by the filter's density, and a radius of {} "
                                   "pixels is below 1/{}: widen the rfilter, or take integrator path",
                                   name, radius, 1 / least)}});
  if (const std::optional<Diagnostic> fault = light_path_fault(scene, name)) throw SceneError({*fault});
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

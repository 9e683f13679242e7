// SPDX-License-Identifier: MIT
#include "render/numeric_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "errors.h"
#include "packing/cl_layout.h"
#include "render/intersector.h"

namespace strahl {
namespace {

/// Pixels at a time: rays and hits take a few hundred bytes each.
constexpr std::size_t chunk_pixels = std::size_t{1} << 17;

/// The direction stays, so that t changes by the frame's scale alone.
Ray world_ray(const double* real, const UploadFrame& frame) {
  const auto vector = [real](int at) { return Vec3{real[at], real[at + 1], real[at + 2]}; };
  Ray ray;
  ray.origin = frame.origin + 1 / frame.scale * vector(layout::RAY_O);
  ray.direction = vector(layout::RAY_D);
  ray.t_min = real[layout::RAY_T_MIN] / frame.scale;
  ray.t_max = real[layout::RAY_T_MAX] / frame.scale;
  return ray;
}

double float_ulp(double x) { return std::ldexp(1.0, std::max(std::ilogb(x), -126) - 23); }

double error(bool is_hit, double t, const Hit& exact) {
  if (is_hit != (exact.shape >= 0)) return std::numeric_limits<double>::infinity();
  return is_hit ? std::fabs(t - exact.t) / float_ulp(exact.t) : 0;
}

RenderSettings in_double(const RenderSettings& of_picture) {
  RenderSettings settings;
  settings.precision = Precision::fp64;
  settings.disabled = of_picture.disabled;
  settings.loop_turns = of_picture.loop_turns;
  return settings;
}

}  // namespace

void require_numeric_error(const Device& device, const Scene& scene, const RenderSettings& of_picture,
                           const MemoryNeed& picture) {
  const DeviceInfo& info = device.info();
  if (!info.fp64)
    throw NoDeviceError(
        fmt::format("the AOV numeric_error holds every hit against double precision, which {} has not", info.text()));
  const MemoryNeed need = Intersector::least_memory(device, scene, in_double(of_picture));
  if (!fits(picture, info)) return;  // Which is said without this layer, too.
  if (fits(need, info) && need.total() + picture.total() <= info.global_memory) return;
  throw NoDeviceError(
      fmt::format("the AOV numeric_error has the scene in memory a second time, in double precision: at least {} KiB "
                  "beside {} KiB, and {} has {}, {} KiB in one buffer; leave that AOV out, or choose {}",
                  need.total() >> 10, picture.total() >> 10, info.text(), info.memory_text(), info.max_allocation >> 10,
                  info.room_for(need.total() + picture.total())));
}

void replace_t_by_its_error(const Device& device, const Scene& scene, const UploadFrame& frame,
                            const RenderSettings& of_picture, std::vector<double>& reals,
                            const std::vector<std::int32_t>& ints) {
  Intersector exact(device, scene, in_double(of_picture));
  const std::size_t pixels = ints.size() / layout::AOV_INTS;
  for (std::size_t first = 0; first < pixels; first += chunk_pixels) {
    const std::size_t last = std::min(first + chunk_pixels, pixels);
    std::vector<Ray> rays;
    for (std::size_t pixel = first; pixel < last; ++pixel)
      rays.push_back(world_ray(&reals[pixel * layout::AOV_REALS + layout::AOV_RAY], frame));
    const std::vector<Hit> hits = exact.trace(rays);
    for (std::size_t pixel = first; pixel < last; ++pixel) {
      double& t = reals[pixel * layout::AOV_REALS + layout::AOV_T];
      const bool is_hit = ints[pixel * layout::AOV_INTS + layout::AOV_SHAPE] >= 0;
      t = error(is_hit, t / frame.scale, hits[pixel - first]);
    }
  }
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "opencl/tuned_width.h"

#include "opencl/program.h"
#include "opencl/program_cache.h"

namespace strahl {
namespace {

constexpr const char* tuned = "tuned-width";

std::string key_of(const Device& device, Precision precision) {
  return std::string(tuned) + "\n" + precision_name(precision) + "\n" + driver_key(device);
}

}  // namespace

std::optional<int> tuned_width(const Device& device, Precision precision) {
  const std::vector<unsigned char> stored = read_cached_binary(tuned, key_of(device, precision));
  if (stored.size() != 1) return std::nullopt;
  const int width = stored[0];
  const bool is_one = width == 2 || width == 4 || width == 8 || (width == 16 && precision != Precision::fp64);
  return is_one ? std::optional(width) : std::nullopt;
}

void remember_width(const Device& device, Precision precision, int width) {
  write_cached_binary(tuned, key_of(device, precision), {static_cast<unsigned char>(width)});
}

Width width_on(const Device& device, RenderSettings settings) {
  if (!settings.lanes && !settings.bvh_width) settings.bvh_width = tuned_width(device, settings.precision);
  return width_of(settings, device.info().native_vector_width);
}

}  // namespace strahl

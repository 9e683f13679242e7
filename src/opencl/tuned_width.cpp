// SPDX-License-Identifier: MIT
#include "opencl/tuned_width.h"

#include <fmt/format.h>

#include "opencl/program.h"
#include "opencl/program_cache.h"
#include "settings/require_settings.h"

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
  return is_tree_width(width, precision) ? std::optional(width) : std::nullopt;
}

void remember_width(const Device& device, Precision precision, int width) {
  if (write_cached_binary(tuned, key_of(device, precision), {static_cast<unsigned char>(width)})) return;
  const std::string directory = program_cache_directory();
  const std::string fault = directory.empty() ? program_cache_fault() : "";
  throw Error(fmt::format(
      "widths are not remembered: {}",
      !fault.empty()      ? fault
      : directory.empty() ? "there is no folder for the program cache; name one with STRAHL_CACHE_DIR"
                          : fmt::format("the program cache \"{}\" cannot be written to; make room or give permission "
                                        "there, or name another folder with STRAHL_CACHE_DIR",
                                        directory)));
}

Width width_on(const Device& device, RenderSettings settings) {
  if (!settings.lanes && !settings.bvh_width) settings.bvh_width = tuned_width(device, settings.precision);
  return width_of(settings, device.info().native_vector_width);
}

}  // namespace strahl

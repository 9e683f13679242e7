// SPDX-License-Identifier: MIT
// `strahl devices`: what there is to compute on, and why something is not.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/console.h"
#include "json_text.h"
#include "opencl/device.h"
#include "opencl/program.h"

namespace strahl::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* devices_footer = R"(
Examples:
  strahl devices                  the default device is marked with *
  strahl devices --json
  strahl devices --clear-cache    removes every cached program

Exit code 4 where there is no usable device.)";

struct DevicesOptions {
  bool json = false;
  bool clear_cache = false;
};

std::string index_of(const DeviceInfo& device) {
  return fmt::format("{}:{}", device.platform_index, device.device_index);
}

/// What a call without -d would use, or why there is none.
struct Default {
  std::string index;
  std::optional<NoDeviceError> error;
};

Default find_default() {
  try {
    return {index_of(Device::open("").info()), {}};
  } catch (const NoDeviceError& error) {
    return {{}, error};
  }
}

Json json_of(const DeviceInfo& device) {
  return {{"index", index_of(device)},
          {"name", device.name},
          {"vendor", device.vendor},
          {"version", device.version},
          {"driver", device.driver},
          {"type", device.type},
          {"fp64", device.fp64},
          {"fma", device.fma},
          {"compute_units", device.compute_units},
          {"clock_mhz", device.clock_mhz},
          {"global_memory", device.global_memory},
          {"max_allocation", device.max_allocation},
          {"shares_host_memory", device.shares_host_memory},
          {"max_work_group", device.max_work_group},
          {"native_vector_width", device.native_vector_width},
          {"available", device.available},
          {"fault", device.fault.empty() ? Json(nullptr) : Json(device.fault)}};
}

std::string json_of(const std::vector<PlatformInfo>& platforms, const std::string& default_index) {
  Json list = Json::array();
  for (const PlatformInfo& platform : platforms) {
    Json devices = Json::array();
    for (const DeviceInfo& device : platform.devices) devices.push_back(json_of(device));
    list.push_back({{"index", platform.index},
                    {"name", platform.name},
                    {"version", platform.version},
                    {"skipped", platform.skipped.empty() ? Json(nullptr) : Json(platform.skipped)},
                    {"note", platform.note.empty() ? Json(nullptr) : Json(platform.note)},
                    {"devices", devices}});
  }
  const Json json = {{"platforms", list}, {"default", default_index.empty() ? Json(nullptr) : Json(default_index)}};
  return json_text(json);
}

std::string text_of(const PlatformInfo& platform, const std::string& default_index) {
  std::string text = fmt::format("platform {}: {}, {}\n", platform.index, platform.name, platform.version);
  for (const DeviceInfo& device : platform.devices) {
    text += fmt::format("{} {:<5} {}{}\n", index_of(device) == default_index ? '*' : ' ', index_of(device), device.name,
                        device.available ? "" : " (not available)");
    if (!device.fault.empty()) {
      text += fmt::format("        {}\n", device.fault);
      continue;
    }
    text += fmt::format("        {} · {} · driver {}\n", device.type, device.version, device.driver);
    text += fmt::format("        {}{} · {} compute units · {:.1f} GiB · native vector width {}\n",
                        device.fp64 ? "fp64" : "no fp64", device.fma ? "" : " · no fma", device.compute_units,
                        static_cast<double>(device.global_memory) / (1 << 30), device.native_vector_width);
  }
  if (!platform.note.empty()) text += fmt::format("  note: {}\n", platform.note);
  if (!platform.skipped.empty()) text += fmt::format("  skipped: {}\n", platform.skipped);
  return text;
}

ExitCode devices(const DevicesOptions& options) {
  if (options.clear_cache) {
    const std::string directory = program_cache_directory();
    const std::size_t removed = clear_program_cache();
    if (options.json)
      print(json_text(Json{{"removed", removed}, {"directory", directory}}));
    else
      print(fmt::format("removed {} cached program{} from {}\n", removed, removed == 1 ? "" : "s", directory));
    return ExitCode::ok;
  }
  const std::vector<PlatformInfo> platforms = list_platforms();
  const Default chosen = find_default();
  if (options.json) {
    print(json_of(platforms, chosen.index));
  } else {
    for (const PlatformInfo& platform : platforms) print(text_of(platform, chosen.index));
  }
  if (chosen.error) throw *chosen.error;
  return ExitCode::ok;
}

}  // namespace

Command add_devices(CLI::App& app) {
  const auto options = std::make_shared<DevicesOptions>();
  app.add_flag("--json", options->json, "For programs");
  app.add_flag("--clear-cache", options->clear_cache, "Remove every cached program instead");
  app.footer(devices_footer);
  return [options] { return devices(*options); };
}

}  // namespace strahl::cli

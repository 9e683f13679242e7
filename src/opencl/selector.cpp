// SPDX-License-Identifier: MIT
// The grammar of device selectors and the order of preference.
#include "opencl/selector.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <tuple>

namespace strahl {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool contains(const std::string& text, const std::string& lower_part) {
  return lower(text).find(lower_part) != std::string::npos;
}

std::optional<int> index_in(const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value < 0) return std::nullopt;
  return value;
}

/// A number alone is an index where a platform has it, and a part of a name otherwise.
DeviceSelector decided(DeviceSelector selector, const std::vector<PlatformInfo>& platforms) {
  if (!selector.platform || selector.name.empty()) return selector;
  const auto has_index = [&](const PlatformInfo& platform) { return platform.index == selector.platform; };
  if (std::any_of(platforms.begin(), platforms.end(), has_index))
    selector.name.clear();
  else
    selector.platform.reset();
  return selector;
}

bool name_matches(const DeviceSelector& selector, const PlatformInfo& platform) {
  return !selector.name.empty() && contains(platform.name, selector.name);
}

bool means(const DeviceSelector& selector, const DeviceInfo& device) {
  if (selector.device) return device.device_index == *selector.device;
  if (!selector.type.empty()) return device.type == selector.type;
  return contains(device.name, selector.name) || contains(device.vendor, selector.name);
}

/// Smaller is better.
auto rank(const DeviceInfo& device) {
  const int type = device.type == "GPU" ? 0 : device.type == "CPU" ? 1 : 2;
  // Drivers that do not know the clock say 0 (llvmpipe): still a device, only the slowest of its type.
  const auto speed = -static_cast<long long>(device.compute_units) * static_cast<long long>(device.clock_mhz);
  // Vendors count their units differently: between one that is a part of the processor and a card they decide nothing.
  const bool is_part_of_processor = type == 0 && device.shares_host_memory;
  return std::make_tuple(!device.available, type, is_part_of_processor, speed, device.platform_index,
                         device.device_index);
}

}  // namespace

DeviceSelector parse_selector(const std::string& text) {
  DeviceSelector selector;
  const auto colon = text.find(':');
  if (const auto platform = index_in(text.substr(0, colon))) {
    const auto device = colon == std::string::npos ? std::nullopt : index_in(text.substr(colon + 1));
    if (colon == std::string::npos || device) {
      selector.platform = platform;
      selector.device = device;
      if (colon == std::string::npos) selector.name = text;
      return selector;
    }
  }
  selector.name = lower(text);
  if (selector.name == "cpu" || selector.name == "gpu") {
    selector.type = selector.name == "cpu" ? "CPU" : "GPU";
    selector.name.clear();
  } else if (selector.name == "pocl") {
    selector.name = "portable computing language";
    selector.names_platform = true;
  } else if (selector.name == "intel") {
    // Not the processor: on an Intel CPU, PoCL's device is called Intel too.
    selector.names_platform = true;
  }
  return selector;
}

std::vector<std::size_t> platforms_to_ask(const DeviceSelector& given, const std::vector<PlatformInfo>& platforms) {
  const DeviceSelector selector = decided(given, platforms);
  std::vector<std::size_t> asked;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < platforms.size(); ++i) {
    all.push_back(i);
    if (selector.platform == platforms[i].index || name_matches(selector, platforms[i])) asked.push_back(i);
  }
  const bool only_platforms = selector.platform || selector.names_platform;
  return asked.empty() && !only_platforms ? all : asked;
}

std::vector<DeviceInfo> matching_devices(const DeviceSelector& given, const std::vector<PlatformInfo>& platforms) {
  const DeviceSelector selector = decided(given, platforms);
  const std::vector<std::size_t> asked = platforms_to_ask(selector, platforms);
  std::vector<DeviceInfo> found;
  for (const std::size_t i : asked) {
    const bool whole_platform = name_matches(selector, platforms[i]) || (selector.platform && !selector.device);
    for (const DeviceInfo& device : platforms[i].devices) {
      if (whole_platform || means(selector, device)) found.push_back(device);
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return found;
}

}  // namespace strahl

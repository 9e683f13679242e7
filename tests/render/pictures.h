// SPDX-License-Identifier: MIT
// What the render tests share: the project's scenes in small, all AOVs, and comparison of every bit.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/loader.h"
#include "support/devices.h"

namespace strahl::test {

inline const std::filesystem::path scene_folder = STRAHL_SOURCE_DIR "/scenes";

/// Tiers that keep closed forms to rounding.
inline constexpr std::array exact_tiers{Precision::stable, Precision::robust, Precision::fp64};

/// STRAHL_ALL_TIERS, which entries of the label slow set.
inline bool is_of_all_tiers() { return std::getenv("STRAHL_ALL_TIERS") != nullptr; }

/// Those of them that a run asks where the tiers differ in their numbers alone: robust, all with STRAHL_ALL_TIERS.
inline std::vector<Precision> asked_tiers() {
  if (!is_of_all_tiers()) return {Precision::robust};
  return {exact_tiers.begin(), exact_tiers.end()};
}

inline Scene small_scene(const std::filesystem::path& path, int width, int height, int spp) {
  Scene scene = load_scene(path.string()).scene;
  scene.film.width = width;
  scene.film.height = height;
  scene.film.crop.reset();
  scene.sampler.sample_count = spp;
  return scene;
}

inline RenderSettings all_aovs(Precision precision = Precision::robust) {
  RenderSettings settings;
  settings.precision = precision;
  settings.aovs = {Aov::depth,  Aov::normal,     Aov::position, Aov::uv,
                   Aov::albedo, Aov::geo_normal, Aov::shape_id, Aov::primitive_id};
  return settings;
}

/// By the program with every effect, which test_generic holds to those of the scenes: one to compile instead of one for
/// each scene.
inline RenderSettings generic_settings(Precision precision = Precision::robust) {
  RenderSettings settings;
  settings.precision = precision;
  settings.generic = true;
  return settings;
}

/// RenderSettings::disabled so that each sample counts in one pixel, drawn from its filter.
inline const std::set<std::string> without_sharing{"SHARED_SAMPLES"};

/// Its number, or the test fails.
inline int channel_of(const Image& image, const std::string& name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  INFO(name);
  REQUIRE(found != image.channels.end());
  return static_cast<int>(found - image.channels.begin());
}

/// A device that is opened once keeps what it has built.
inline RenderResult render(const std::string& device, const Scene& scene, const RenderSettings& settings) {
  static std::map<std::pair<std::string, bool>, Device> opened;
  const std::pair key{device, settings.precision == Precision::fp64};
  auto at = opened.find(key);
  if (at == opened.end()) at = opened.emplace(key, Device::open(device, {key.second})).first;
  return Renderer(at->second, scene, settings).render();
}

/// Every float has the same bits: -0 differs from 0 and a NaN equals itself.
inline bool same_bits(const Image& a, const Image& b) {
  // std::memcmp wants no null pointers, not even of nothing.
  return a.width == b.width && a.height == b.height && a.channels == b.channels && a.data.size() == b.data.size() &&
         (a.data.empty() || std::memcmp(a.data.data(), b.data.data(), a.data.size() * sizeof(float)) == 0);
}

inline bool same_bits(const RenderResult& a, const RenderResult& b) {
  return same_bits(a.color, b.color) && same_bits(a.aov, b.aov);
}

inline std::size_t lit_pixels(const Image& image) {
  std::size_t lit = 0;
  for (std::size_t i = 0; i + 2 < image.data.size(); i += 3)
    if (image.data[i] + image.data[i + 1] + image.data[i + 2] > 0) ++lit;
  return lit;
}

}  // namespace strahl::test

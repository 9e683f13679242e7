// SPDX-License-Identifier: MIT
// Scenes for the questions of transport_tiers.h, and the numbers that they are asked with.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <random>
#include <variant>
#include <vector>

#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "physics/statistics.h"
#include "physics/transport_tiers.h"
#include "program/kernel_source.h"

namespace strahl::test {

[[nodiscard]] inline Triad triad(const Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Vec3 vec(const Triad& v) { return {v[0], v[1], v[2]}; }

/// A scene as a tier reads it.
class TierScene {
 public:
  TierScene(const Scene& scene, bool is_double, int lanes, RenderSettings settings = {}) {
    settings.generic = true;
    Features features = features_of(scene, settings);
    // Compiled on the host, all integrators stand side by side, whatever kernel they are of.
    for (const std::string& name : list_entries("integrators")) features.entries["integrators"].insert(name);
    const PackOptions options{lanes, UploadFrame{}, 0};
    if (is_double)
      packed_ = pack_scene<double>(scene, features, options);
    else
      packed_ = pack_scene<float>(scene, features, options);
  }
  TierScene(const Scene& scene, const TransportTier& tier, const RenderSettings& settings = {})
      : TierScene(scene, std::string(tier.name) == "double", tier.lanes, settings) {}

  [[nodiscard]] TierBuffers buffers() const {
    return std::visit(
        [](const auto& packed) {
          return TierBuffers{packed.geometry.data(), packed.shading.data(), packed.index.data()};
        },
        packed_);
  }
  [[nodiscard]] int index(int at) const {
    return std::visit([&](const auto& packed) { return packed.index.at(static_cast<std::size_t>(at)); }, packed_);
  }
  /// LIGHT_... of a row of the table of lights.
  [[nodiscard]] int light(int row, int entry) const {
    return index(index(layout::HEADER_LIGHTS) + row * layout::LIGHT_INTS + entry);
  }

 private:
  std::variant<PackedScene<float>, PackedScene<double>> packed_;
};

/// All lights are drawn.
[[nodiscard]] inline Scene empty_scene() {
  Scene scene;
  scene.integrator.name = "path";
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 16;
  return scene;
}

[[nodiscard]] inline std::vector<PlaceNumbers> place_numbers(std::size_t count) {
  std::mt19937_64 engine(11), texels(12);
  std::vector<PlaceNumbers> numbers(count);
  for (PlaceNumbers& n : numbers)
    n = {static_cast<std::uint32_t>(engine()), unit_number(engine), unit_number(engine),
         static_cast<std::uint32_t>(texels()), static_cast<std::uint32_t>(texels())};
  return numbers;
}

/// To the bit.
inline void check_same(const LightDraw& a, const LightDraw& b) {
  CHECK(a.towards == b.towards);
  CHECK(a.radiance == b.radiance);
  CHECK(a.t_max == b.t_max);
  CHECK(a.density == b.density);
  CHECK(a.is_delta == b.is_delta);
  CHECK(a.aim == b.aim);
}

}  // namespace strahl::test

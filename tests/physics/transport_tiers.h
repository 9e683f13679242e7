// SPDX-License-Identifier: MIT
// cl/lights, areas, choosers, textures, packets and integrators on the host, tiers and widths side by side;
// compiled in transport_<tier>.cpp with every entry and feature active, so scenes are packed with
// RenderSettings::generic, for the tier's width.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "physics/tiers.h"

namespace strahl::test {

/// The buffers of cl/scene/layout.h, in the tier's reals.
struct TierBuffers {
  const void* geometry;
  const void* shading;
  const std::int32_t* index;
};

/// The numbers with which a light draws a place or a direction.
struct PlaceNumbers {
  std::uint32_t item;
  double u, v;
  std::uint32_t row = 0, column = 0;
};

/// The sample of a light, as seen from a point: cl/lights/light_sample_lanes.h.
struct LightDraw {
  Triad towards, radiance;
  double t_max, density;
  bool is_delta;
  int aim;
};

/// A place on a light that has an area: cl/areas/area_point_lanes.h.
struct AreaDraw {
  Triad position, normal;
  double density;
  double bound;  ///< On the rounding of the place and of the point that sees it.
};

/// The light that a direction hits.
struct Sight {
  Triad radiance;
  int light;       ///< -1: none that could be drawn.
  double density;  ///< The density with which that light draws the direction.
  Triad position;  ///< Undefined where light < 0, and for the background.
};

struct LightPick {
  int light;
  double rarity, told;  ///< As drawn, and as stated for the drawn light.
};

struct TexturePlace {
  double u, v, footprint;
};

/// A point of a surface whose normal is z, seen from `out`, and the number with which blends are drawn there.
struct SeenPlace {
  double u, v, number;
  Triad out;
};

/// cl/materials/rows_lanes.h
struct DrawnRow {
  int row;  ///< Index into Scene::materials.
  Triad normal;
  double opacity;
};

/// Light from wi there, by the scene's material and by a draw with u and v.
struct Lit {
  Triad value;
  double density;
  Triad drawn, weight;
  double drawn_density;
  int lobe;
};

/// Texture coordinates where a ray ends, and their gradients.
struct Mapped {
  Triad position;
  double u, v;
  Triad grad_u, grad_v;
};

struct GivenRay {
  Triad o, d;
  double t_min, t_max;
  int departed = -1;  ///< Scene-wide id of the primitive that it leaves.
};

struct FoundHit {
  double t;
  int id, kind;  ///< kind -1: nothing is hit, and no more is known.
};

struct TransportTier {
  const char* name;
  int lanes;
  /// lights: of all draws, or one for each.
  std::vector<LightDraw> (*draw)(const TierBuffers& scene, const std::vector<int>& lights, const Triad& from,
                                 const std::vector<PlaceNumbers>& numbers);
  /// Of a light of kind `area`.
  std::vector<AreaDraw> (*places)(const TierBuffers& scene, int light, const Triad& from,
                                  const std::vector<PlaceNumbers>& numbers);
  /// Of `items`, by the table behind the `first` items of others (CHOICE_INTS an item).
  std::vector<int> (*choose)(const std::vector<std::int32_t>& tables, int first, unsigned items,
                             const std::vector<std::uint32_t>& numbers);
  /// As seen by an integrator's ray that a material has drawn.
  std::vector<Sight> (*look)(const TierBuffers& scene, const Triad& from, const std::vector<Triad>& directions);
  /// The density of a light in a direction that leads to none of its surfaces.
  double (*density)(const TierBuffers& scene, int light, const Triad& from, const Triad& direction);
  /// By `count` samples of pixel 0.
  std::vector<LightPick> (*pick)(const TierBuffers& scene, const Triad& from, std::uint32_t count);
  double (*rarity)(const TierBuffers& scene, int light, const Triad& from);
  /// On part 0.
  std::vector<Triad> (*texture)(const TierBuffers& scene, int texture, const std::vector<TexturePlace>& points);
  /// The materials of part 0.
  std::vector<DrawnRow> (*rows)(const TierBuffers& scene, const std::vector<SeenPlace>& places);
  /// At those places, whose u grows along x and v along y; numbers: of each place's draw.
  std::vector<Lit> (*lit)(const TierBuffers& scene, const std::vector<SeenPlace>& places, const std::vector<Triad>& wi,
                          const std::vector<Triad>& numbers);
  std::vector<Mapped> (*mapped)(const TierBuffers& scene, const std::vector<GivenRay>& rays);
  /// Turns of the vectors (u, v), in lanes and by the function for one.
  std::vector<double> (*angles)(const std::vector<TexturePlace>& vectors);
  std::vector<double> (*angles_alone)(const std::vector<TexturePlace>& vectors);
  /// Radiance along the ray by the scene's integrator, sample by sample of pixel 0.
  std::vector<Triad> (*radiance)(const TierBuffers& scene, const GivenRay& ray, std::uint32_t samples);
  /// What an integrator whose paths begin on lights adds to a film of one pixel: words of cl/film/splat.h.
  std::vector<std::int64_t> (*splats)(const TierBuffers& scene, std::uint32_t samples);
};

/// Nearest, or any. The scene is packed for as many lanes as there are.
using FindHits = std::vector<FoundHit> (*)(const TierBuffers& scene, const std::vector<GivenRay>& rays, bool any);

/// Bits of the lanes that find_surfaces walks for paths in the lanes `alive`, before any ray was made in the others,
/// and after all lanes had followed `ray`.
using WalkedLanes = std::array<unsigned, 2> (*)(const TierBuffers& scene, const GivenRay& ray, unsigned alive);

struct PacketTier {
  const char* name;
  FindHits alone;                     ///< Ray by ray, at width 1.
  std::map<int, FindHits> packets;    ///< By the number of lanes.
  std::map<int, WalkedLanes> walked;  ///< The same.
};

[[nodiscard]] std::vector<TransportTier> transport_fast();
[[nodiscard]] std::vector<TransportTier> transport_stable();
[[nodiscard]] std::vector<TransportTier> transport_robust();
[[nodiscard]] std::vector<TransportTier> transport_double();
[[nodiscard]] std::vector<TransportTier> transport_media();  ///< In double, of programs with media.
[[nodiscard]] PacketTier packets_stable();
[[nodiscard]] PacketTier packets_robust();

[[nodiscard]] inline std::vector<TransportTier> transport_tiers() {
  std::vector<TransportTier> all;
  for (const auto& tiers : {transport_fast(), transport_stable(), transport_robust(), transport_double()})
    all.insert(all.end(), tiers.begin(), tiers.end());
  return all;
}

}  // namespace strahl::test

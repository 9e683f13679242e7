// SPDX-License-Identifier: MIT
// The properties of each kind of material in one place: its name, its lobes, and its parameters as the kernels read
// them. Features, packing, validation and warnings use them.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

namespace lobes {
#include "../../cl/materials/lobes.h"
}

/// A parameter: a slot of the material's row (cl/scene/layout.h).
struct MaterialSlot {
  const char* name;             ///< As in scene files.
  std::array<double, 3> reals;  ///< What the kernels read where there is no texture.
  int texture = -1;             ///< Index into Scene::textures; -1: none.
  bool is_share = true;         ///< A share of the light: within [0, 1]. Faults of the others are in MaterialFacts.
  bool is_colour = true;        ///< Of a share: false of an opacity and of a blend's weight.
  bool has_length = false;      ///< The last real is a length of the scene.
};

struct MaterialFacts {
  std::string kind;  ///< An entry of cl/materials/materials.def; else its name in scene files.
  int lobes = 0;     ///< lobes::LOBE_...: those that it may have.
  std::vector<MaterialSlot> slots;
  std::optional<MaterialSlot> opacity;  ///< Of a mask.
  std::vector<std::string> flags;       ///< Features (cl/features.def) that it calls for.
  std::vector<std::string> faults;      ///< Descriptions of its faults, except for shares outside [0, 1].
  bool is_twosided = false;             ///< Its back looks as its front does.
  bool is_boundary = false;             ///< Of two media: shapes of it may have a priority.
  bool is_coat = false;                 ///< The one inside it lies below it.
  bool is_metal = false;                ///< Its second and third slot are eta and k.
  int scale_slot = -1;                  ///< Its last real multiplies slots 0 and 1, which may be textures; -1: none.
  bool draws_all = true;                ///< It draws each lobe that it has about as often as that counts.
  bool has_along = false;               ///< It scatters differently along u and across; calls for TANGENT.
  std::vector<int> nested;              ///< Indices of the materials inside it: of a blend two, else one.

  [[nodiscard]] bool has_lobe(int lobe) const { return (lobes & lobe) == lobe; }
};

/// What both parts of a material are multiplied by, which at their brightest reflect that much together: as in Mitsuba
/// 0.x, 1 where that is at most 1, else so that 0.99 is left.
[[nodiscard]] double scale_of_parts(const Rgb& together);

[[nodiscard]] MaterialFacts material_facts(const Material& material);

/// So many are within each other at the most: readers and programs walk from one to the next.
inline constexpr int deepest_material = 256;

/// Indices of the materials inside it, and inside those, each once, however often it is referred to. with_backs: what
/// their other sides show, too. Indices that are none of the scene's are left out.
[[nodiscard]] std::vector<int> materials_inside(const Scene& scene, const Material& material, bool with_backs = false);

/// Whether one of materials_inside() is so.
template <typename IsSo>
[[nodiscard]] bool any_inside(const Scene& scene, const Material& material, const IsSo& is_so,
                              bool with_backs = false) {
  return std::ranges::any_of(materials_inside(scene, material, with_backs),
                             [&](int inside) { return is_so(scene.materials[static_cast<std::size_t>(inside)]); });
}

/// Whether a material of the scene, or one inside it or behind, is a Bsdf.
template <typename Bsdf>
[[nodiscard]] bool is_or_holds(const Scene& scene, int index) {
  const Material& material = scene.materials.at(static_cast<std::size_t>(index));
  const auto is_one = [](const Material& each) { return std::holds_alternative<Bsdf>(each.bsdf); };
  return is_one(material) || any_inside(scene, material, is_one, true);
}

/// Lobes of the material, or of those inside it.
[[nodiscard]] int lobes_of(const Scene& scene, const Material& material);

[[nodiscard]] bool transmits(const Scene& scene, const Material& material);

/// Whether a lobe of a material of the scene has all of these properties.
[[nodiscard]] bool has_lobe(const Scene& scene, int lobe);

}  // namespace strahl

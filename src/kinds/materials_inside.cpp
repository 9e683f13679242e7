// SPDX-License-Identifier: MIT
// Materials within materials.
#include <algorithm>
#include <set>

#include "kinds/materials.h"

namespace strahl {

std::vector<int> materials_inside(const Scene& scene, const Material& material, bool with_backs) {
  std::vector<int> found;
  std::set<int> seen;
  const auto add = [&](int index) {
    const bool is_there = index >= 0 && static_cast<std::size_t>(index) < scene.materials.size();
    if (is_there && seen.insert(index).second) found.push_back(index);
  };
  const auto add_inside = [&](const Material& outer) {
    if (with_backs) add(outer.back);
    for (const int nested : material_facts(outer).nested) add(nested);
  };
  add_inside(material);
  for (std::size_t i = 0; i < found.size(); ++i) add_inside(scene.materials[static_cast<std::size_t>(found[i])]);
  return found;
}

int lobes_of(const Scene& scene, const Material& material) {
  int all = material_facts(material).lobes;
  for (const int inside : materials_inside(scene, material))
    all |= material_facts(scene.materials[static_cast<std::size_t>(inside)]).lobes;
  return all;
}

bool transmits(const Scene& scene, const Material& material) {
  return (lobes_of(scene, material) & lobes::LOBE_TRANSMIT) != 0;
}

bool has_lobe(const Scene& scene, int lobe) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [&](const Material& material) { return material_facts(material).has_lobe(lobe); });
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "kinds/lobes_inside.h"

#include "kinds/materials.h"

namespace strahl {

int LobesInside::of_known(const Material& material) const {
  const MaterialFacts facts = material_facts(material);
  int all = facts.lobes;
  for (const int nested : facts.nested)
    if (nested >= 0 && static_cast<std::size_t>(nested) < known_.size())
      all |= known_[static_cast<std::size_t>(nested)];
  return all;
}

int LobesInside::of(const Scene& scene, const Material& material) {
  while (known_.size() < scene.materials.size()) known_.push_back(of_known(scene.materials[known_.size()]));
  return of_known(material);
}

bool LobesInside::transmits(const Scene& scene, const Material& material) {
  return (of(scene, material) & lobes::LOBE_TRANSMIT) != 0;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Lobes: how a material scatters light. A lobe has a side and a spread. A set of lobes is a set of sides and spreads,
// such as the lobes of a material or those that may be drawn; a lobe is in the set if both its side and its spread are.
#ifndef STRAHL_MATERIALS_LOBES_H
#define STRAHL_MATERIALS_LOBES_H

enum {
  LOBE_REFLECT = 1,   ///< Stays on the side that the ray came from.
  LOBE_TRANSMIT = 2,  ///< Goes through.
  LOBE_DIFFUSE = 4,
  LOBE_GLOSSY = 8,
  LOBE_DELTA = 16,    ///< A single direction: no drawn light lies in it.
  LOBE_ONE_WAY = 32,  ///< Of a material's set: it scatters otherwise where the light comes the other way.

  LOBE_SIDES = LOBE_REFLECT | LOBE_TRANSMIT,
  LOBE_SPREADS = LOBE_DIFFUSE | LOBE_GLOSSY | LOBE_DELTA,
  LOBES_ALL = LOBE_SIDES | LOBE_SPREADS,
  LOBES_DELTA = LOBE_SIDES | LOBE_DELTA
};

#endif

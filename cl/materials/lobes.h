// SPDX-License-Identifier: MIT
// Lobes: what a material does with light, by the side that ways on are on and by how they spread. Several together:
// those that a material has, or that may be drawn. A lobe is among them where its side and its spread are.
#ifndef STRAHL_MATERIALS_LOBES_H
#define STRAHL_MATERIALS_LOBES_H

enum {
  LOBE_REFLECT = 1,   ///< Stays on the side that the ray came from.
  LOBE_TRANSMIT = 2,  ///< Goes through.
  LOBE_DIFFUSE = 4,
  LOBE_GLOSSY = 8,
  LOBE_DELTA = 16,  ///< One direction alone: no light that was drawn lies in it.

  LOBE_SIDES = LOBE_REFLECT | LOBE_TRANSMIT,
  LOBE_SPREADS = LOBE_DIFFUSE | LOBE_GLOSSY | LOBE_DELTA,
  LOBES_ALL = LOBE_SIDES | LOBE_SPREADS,
  LOBES_DELTA = LOBE_SIDES | LOBE_DELTA
};

#endif

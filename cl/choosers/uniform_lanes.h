// SPDX-License-Identifier: MIT
// Every light alike.

FN realw LANED(uniform_rarity)(const Scene* scene, intw lights, real3w from) {
  (void)lights;
  (void)from;
  return splat_w((real)lights_drawn_from(scene));
}

FN LANED(LightChoice) LANED(uniform_choose)(const Scene* scene, real3w from, uintw number) {
  LANED(LightChoice) choice;
  intw first = splat_int_w(scene->index[HEADER_LIGHTS_TAKEN]);
  choice.light = first + int_of_uint_w(high_product_w(number, splat_uint_w((uint)lights_drawn_from(scene))));
  choice.rarity = LANED(uniform_rarity)(scene, choice.light, from);
  return choice;
}

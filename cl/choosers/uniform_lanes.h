// SPDX-License-Identifier: MIT
// Every light has the same probability.

FN realw uniform_rarity_w(const Scene* scene, intw lights, real3w from) {
  (void)lights;
  (void)from;
  return splat_w((real)lights_drawn_from(scene));
}

FN LightChoice_w uniform_choose_w(const Scene* scene, real3w from, uintw number) {
  LightChoice_w choice;
  intw first = splat_int_w(scene->index[HEADER_LIGHTS_TAKEN]);
  choice.light = first + int_of_uint_w(high_product_w(number, splat_uint_w((uint)lights_drawn_from(scene))));
  choice.rarity = uniform_rarity_w(scene, choice.light, from);
  return choice;
}

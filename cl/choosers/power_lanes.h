// SPDX-License-Identifier: MIT
// A light's probability is its share of the power of all lights that are drawn. HEADER_CHOICES -> index: the
// table of shares (CHOICE_INTS a light); HEADER_CHANCES -> shading: one over each light's share.

FN realw power_rarity_w(const Scene* scene, intw lights, real3w from) {
  (void)from;
  intw first = splat_int_w(scene->index[HEADER_LIGHTS_TAKEN]);
  intw item = sel_int_w(lt_int_w(lights, first), splat_int_w(0), lights - first);
  return gather_w(scene->shading + scene->index[HEADER_CHANCES], item);
}

FN LightChoice_w power_choose_w(const Scene* scene, real3w from, uintw number) {
  LightChoice_w choice;
  GLOBAL const int* table = scene->index + scene->index[HEADER_CHOICES];
  intw item = chosen_item_w(table, splat_int_w(0), (uint)lights_drawn_from(scene), number);
  choice.light = splat_int_w(scene->index[HEADER_LIGHTS_TAKEN]) + item;
  choice.rarity = power_rarity_w(scene, choice.light, from);
  return choice;
}

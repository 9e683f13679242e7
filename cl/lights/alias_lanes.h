// SPDX-License-Identifier: MIT
// One of several items by A. Walker's table (scene/layout.h, CHOICE_...). One width; no guard.

/// choices: -> index, the first of the tables. first: of each lane's table, counted in items.
FN intw alias_item_w(GLOBAL const int* choices, intw first, uint items, uintw numbers) {
  uintw item = high_product_w(numbers, splat_uint_w(items)), rest = numbers * items;
  intw choice = (first + int_of_uint_w(item)) * (int)CHOICE_INTS;
  maskw is_kept = lt_uint_w(rest, uint_of_int_w(gather_int_w(choices + CHOICE_LIMIT, choice)));
  return sel_int_w(is_kept, int_of_uint_w(item), gather_int_w(choices + CHOICE_OTHER, choice));
}

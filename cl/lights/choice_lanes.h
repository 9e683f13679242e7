// SPDX-License-Identifier: MIT
// One of several items, by inversion: the smallest whose last number (scene/layout.h, CHOICE_...) is not below a random
// one. Near numbers lead to near items, so that numbers that are spread evenly choose places that are. Where to look is
// told by a guide table: H.-C. Chen, Y. Asau, "On Generating Random Variates from an Empirical Distribution", AIIE
// Transactions 6(2), 1974. One width; no guard.

/// choices: -> index, the first of the tables. first: of each lane's table, counted in items.
FN intw chosen_item_w(GLOBAL const int* choices, intw first, uint items, uintw numbers) {
  intw one = splat_int_w(1), last = splat_int_w((int)items - 1);
  intw part = int_of_uint_w(high_product_w(numbers, splat_uint_w(items)));
  maskw is_before = lt_int_w(part, last);
  intw next = sel_int_w(is_before, part + one, part);
  intw low = gather_int_w(choices + CHOICE_GUIDE, (first + part) * (int)CHOICE_INTS);
  intw high = gather_int_w(choices + CHOICE_GUIDE, (first + next) * (int)CHOICE_INTS);
  high = sel_int_w(is_before, high, last);
  maskw is_open = lt_int_w(low, high);
  while (any_w(is_open)) {
    intw middle = sel_int_w(is_open, low + int_of_uint_w(uint_of_int_w(high - low) >> 1u), low);
    uintw end = uint_of_int_w(gather_int_w(choices + CHOICE_LAST, (first + middle) * (int)CHOICE_INTS));
    maskw is_beyond = lt_uint_w(end, numbers);
    low = sel_int_w(is_open & is_beyond, middle + one, low);
    high = sel_int_w(is_open & ~is_beyond, middle, high);
    is_open = lt_int_w(low, high);
  }
  return low;
}

// SPDX-License-Identifier: MIT
// A binary tree of lights, walked from its root: each child is taken in proportion to what its lights may bring to the
// point, by their strength, distance and direction (A. Conty Estevez, C. Kulla, "Importance Sampling of Many Lights
// with Adaptive Tree Splitting", HPG 2018; without the splitting). A light's probability is the product along its way.
// Layout: scene/layout.h, LIGHT_CHILD_....

typedef struct {
  realw left, right;  ///< Their sum is 1.
} LightShares_w;

enum { LIGHT_NODE_REALS_w = 2 * LIGHT_CHILD_REALS };

/// pair: receives both children of each lane's node.
FN void light_node_w(GLOBAL const real* children, intw node, PRIVATE realw* pair) {
  gather_row_w(children, node * (int)LIGHT_NODE_REALS_w, LIGHT_NODE_REALS_w, pair);
}

/// Of the lights of both children.
FN realw importance_of_node_w(GLOBAL const real* children, intw node, real3w from) {
  realw pair[LIGHT_NODE_REALS_w];
  light_node_w(children, node, pair);
  return light_importance_w(pair, from) + light_importance_w(pair + LIGHT_CHILD_REALS, from);
}

/// Of a node's children. Where no light of either reaches the point, or numbers overflow, both are equal. Where one
/// holds lights from afar (the left one) and the other near ones, the children of the latter give its importance: a
/// light far out makes the ball around all near ones too wide to tell. Each of the two has an eighth at least.
FN LightShares_w light_shares_w(GLOBAL const real* children, GLOBAL const int* links, intw node, real3w from) {
  realw pair[LIGHT_NODE_REALS_w];
  light_node_w(children, node, pair);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), even = splat_w(R(0.5));
  realw left = light_importance_w(pair, from);
  realw right = light_importance_w(pair + LIGHT_CHILD_REALS, from);
  maskw is_mixed = lt_w(pair[LIGHT_CHILD_RADIUS2], zero) & ~lt_w(pair[LIGHT_CHILD_REALS + LIGHT_CHILD_RADIUS2], zero);
  if (any_w(is_mixed)) {
    intw next = gather_int_w(links + 1, node + node);
    maskw is_node = is_mixed & ~lt_int_w(next, splat_int_w(0));
    if (any_w(is_node))
      right = sel_w(is_node, importance_of_node_w(children, sel_int_w(is_node, next, splat_int_w(0)), from), right);
  }
  realw both = left + right;
  maskw is_sound = lt_w(zero, both) & lt_w(both, splat_w(REAL_MAX));
  LightShares_w shares;
  shares.left = sel_w(is_sound, left / both, even);
  shares.right = sel_w(is_sound, right / both, even);
  realw far = share_afar_w(shares.left);
  shares.left = sel_w(is_mixed, far, shares.left);
  shares.right = sel_w(is_mixed, one - far, shares.right);
  return shares;
}

/// One over the product of the shares along the ways to the lights.
FN realw tree_rarity_w(const Scene* scene, intw lights, real3w from) {
  GLOBAL const real* children = scene->shading + scene->index[HEADER_CHANCES];
  GLOBAL const int* ways = scene->index + scene->index[HEADER_CHOICES];
  GLOBAL const int* links = ways + lights_drawn_from(scene);
  intw first = splat_int_w(scene->index[HEADER_LIGHTS_TAKEN]), node = splat_int_w(0);
  intw way = gather_int_w(ways, sel_int_w(lt_int_w(lights, first), splat_int_w(0), lights - first));
  realw chance = splat_w(R(1.0));
  for (maskw walks = ~none_w(); any_w(walks);) {
    LightShares_w shares = light_shares_w(children, links, node, from);
    maskw is_right = nonzero_w(way & splat_int_w(1));
    chance = sel_w(walks, chance * sel_w(is_right, shares.right, shares.left), chance);
    intw link = gather_int_w(links, node + node + (way & splat_int_w(1)));
    walks = walks & ~lt_int_w(link, splat_int_w(0));
    node = sel_int_w(walks, link, node);
    way = way >> 1;
  }
  return splat_w(R(1.0)) / chance;
}

/// x in [0, 1) times 2^32; bits: fill what a real cannot hold.
FN uintw number_of_share_w(realw x, uintw bits) {
  intw upper = int_of_real_w(min_w(x, splat_w(R(0.999999940395355224609375))) * splat_w(R(0x1p31)));
  return (uint_of_int_w(upper) << 1) ^ bits;
}

/// What is left of a number, of which all below `from` were of `share`, spread over 32 bits again. The number keeps its
/// order; bits that it lacks come from its hash (the output function of M. O'Neill, "PCG", 2014).
FN uintw number_again_w(uintw number, uintw from, realw share) {
  uintw bits = number * 747796405u + 2891336453u;
  bits = ((bits >> ((bits >> 28) + 4u)) ^ bits) * 277803737u;
  bits = (bits >> 22) ^ bits;
  realw x = (real_of_uint_w(number - from) + random_unit_w(bits)) * splat_w(R(0x1p-32)) / share;
  return number_of_share_w(x, bits & 0xffu);
}

FN LightChoice_w tree_choose_w(const Scene* scene, real3w from, uintw number) {
  GLOBAL const real* children = scene->shading + scene->index[HEADER_CHANCES];
  GLOBAL const int* links = scene->index + scene->index[HEADER_CHOICES] + lights_drawn_from(scene);
  intw first = splat_int_w(scene->index[HEADER_LIGHTS_TAKEN]), node = splat_int_w(0), zero = splat_int_w(0);
  LightChoice_w choice;
  choice.light = first;
  realw chance = splat_w(R(1.0)), one = splat_w(R(1.0));
  for (maskw walks = ~none_w(); any_w(walks);) {
    LightShares_w shares = light_shares_w(children, links, node, from);
    uintw limit = number_of_share_w(shares.left, splat_uint_w(0u));
    maskw is_left = lt_uint_w(number, limit) | le_w(one, shares.left);
    realw share = sel_w(is_left, shares.left, shares.right);
    chance = sel_w(walks, chance * share, chance);
    number = number_again_w(number, uint_of_int_w(sel_int_w(is_left, zero, int_of_uint_w(limit))), share);
    intw link = gather_int_w(links, node + node + sel_int_w(is_left, zero, splat_int_w(1)));
    maskw is_light = walks & lt_int_w(link, zero);
    choice.light = sel_int_w(is_light, first - link - splat_int_w(1), choice.light);
    walks = walks & ~is_light;
    node = sel_int_w(walks, link, node);
  }
  choice.rarity = one / chance;
  return choice;
}

// SPDX-License-Identifier: MIT
// A light's probability is its share of what all lights may bring to the point. Each is asked, so these are few. Those
// from afar and near ones have an eighth of the whole at least, as in the tree. HEADER_CHANCES -> shading:
// LIGHT_CHILD_REALS a light.

FN int is_light_afar_w(GLOBAL const real* child) { return child[LIGHT_CHILD_RADIUS2] < R(0.0); }

FN realw importance_of_light_w(GLOBAL const real* child, real3w from) {
  realw light[LIGHT_CHILD_REALS];
  UNROLLED
  for (int k = 0; k < LIGHT_CHILD_REALS; ++k) light[k] = splat_w(child[k]);
  return light_importance_w(light, from);
}

/// Of the first lights, as many as are chosen among this way where nobody asks for it.
enum { KEPT_IMPORTANCES_w = 32 };
typedef struct {
  realw of[KEPT_IMPORTANCES_w];
} Importances_w;

typedef struct {
  realw far, near;  ///< The probability per importance of a light from afar, and of a near one, ...
  realw even;       ///< ... or of any light, where no light reaches the point, or numbers overflow; else 0.
} LightRates_w;

/// kept: receives the importances.
FN LightRates_w light_rates_w(const Scene* scene, GLOBAL const real* children, real3w from,
                              PRIVATE Importances_w* kept) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), far = zero, near = zero;
  int count = lights_drawn_from(scene);
  for (int i = 0; i < count; ++i) {
    GLOBAL const real* child = children + i * LIGHT_CHILD_REALS;
    realw importance = importance_of_light_w(child, from);
    if (i < KEPT_IMPORTANCES_w) kept->of[i] = importance;
    if (is_light_afar_w(child))
      far = far + importance;
    else
      near = near + importance;
  }
  realw both = far + near, share = share_afar_w(far / both);
  share = sel_w(lt_w(zero, near), share, one);
  share = sel_w(lt_w(zero, far), share, zero);
  LightRates_w rates;
  rates.far = sel_w(lt_w(zero, far), share / far, zero);
  rates.near = sel_w(lt_w(zero, near), (one - share) / near, zero);
  // Of sums below about 1e-39 the rates overflow in single precision.
  realw largest = splat_w(REAL_MAX);
  maskw is_sound = lt_w(zero, both) & lt_w(both, largest) & lt_w(rates.far, largest) & lt_w(rates.near, largest);
  rates.far = sel_w(is_sound, rates.far, zero);
  rates.near = sel_w(is_sound, rates.near, zero);
  rates.even = sel_w(is_sound, zero, splat_w(R(1.0) / (real)count));
  return rates;
}

/// Of light i.
FN realw chance_of_light_w(GLOBAL const real* children, int i, const LightRates_w* rates, const Importances_w* kept,
                           real3w from) {
  GLOBAL const real* child = children + i * LIGHT_CHILD_REALS;
  realw rate = is_light_afar_w(child) ? rates->far : rates->near;
  realw importance = i < KEPT_IMPORTANCES_w ? kept->of[i] : importance_of_light_w(child, from);
  maskw is_sound = ~lt_w(splat_w(R(0.0)), rates->even);
  return sel_w(is_sound, rate * importance, rates->even);
}

FN realw each_rarity_w(const Scene* scene, intw lights, real3w from) {
  GLOBAL const real* children = scene->shading + scene->index[HEADER_CHANCES];
  int first = scene->index[HEADER_LIGHTS_TAKEN], count = lights_drawn_from(scene);
  Importances_w kept;
  LightRates_w rates = light_rates_w(scene, children, from, &kept);
  realw chance = splat_w(R(1.0));
  for (int i = 0; i < count; ++i) {
    maskw of_light = ~nonzero_w(lights - splat_int_w(first + i));
    if (!any_w(of_light)) continue;
    chance = sel_w(of_light, chance_of_light_w(children, i, &rates, &kept, from), chance);
  }
  return splat_w(R(1.0)) / chance;
}

FN LightChoice_w each_choose_w(const Scene* scene, real3w from, uintw number) {
  GLOBAL const real* children = scene->shading + scene->index[HEADER_CHANCES];
  int first = scene->index[HEADER_LIGHTS_TAKEN], count = lights_drawn_from(scene);
  Importances_w kept;
  LightRates_w rates = light_rates_w(scene, children, from, &kept);
  realw zero = splat_w(R(0.0)), x = random_unit_w(number), below = zero, chosen = splat_w(R(1.0));
  LightChoice_w choice;
  choice.light = splat_int_w(first);
  for (int i = 0; i < count; ++i) {
    realw chance = chance_of_light_w(children, i, &rates, &kept, from);
    // The last one whose part of [0, 1) begins at x or before.
    maskw is_chosen = lt_w(zero, chance) & le_w(below, x);
    choice.light = sel_int_w(is_chosen, splat_int_w(first + i), choice.light);
    chosen = sel_w(is_chosen, chance, chosen);
    below = below + chance;
  }
  choice.rarity = splat_w(R(1.0)) / chosen;
  return choice;
}

// SPDX-License-Identifier: MIT
// Light at the surfaces of paths: the emission that their rays hit, and the light of lights that are drawn or taken,
// weighted by multiple importance sampling. One width; no guard.

/// The light that the header names along the paths' rays that leave the scene. Where none does, as in most rooms, it is
/// not looked for.
FN FoundLight_w light_afar_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, int header) {
  if (!any_w(path->alive & ~s->hit)) return no_light_found_w();
  return far_light_w(scene, header, real3_at_w(path->rays.planes + RAY_PLANE_D));
}

/// The light along the paths' rays: the emission of the surfaces hit, or the background where nothing is hit.
FN FoundLight_w light_along_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s) {
  FoundLight_w found = light_afar_w(scene, path, s, HEADER_BACKGROUND);
  found.radiance = sel3_w(s->hit, emitted_radiance_w(scene, s), found.radiance);
  return found;
}

/// Of the sun, before the background, where nothing is hit.
FN FoundLight_w sun_along_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s) {
  FoundLight_w found = light_afar_w(scene, path, s, HEADER_SUN);
  found.radiance = sel3_w(s->hit, splat3_w(vec3(R(0.0), R(0.0), R(0.0))), found.radiance);
  return found;
}

/// hide_emitters hides emitters from camera rays only.
FN maskw is_light_shown_w(const Scene* scene, const Paths_w* path) {
  return hides_emitters(scene) ? path->alive & lt_int_w(splat_int_w(0), path->depth) : path->alive;
}

/// The weight of a direction that was drawn with `density`; the other technique draws it with density `other`.
FN realw balance_w(realw density, realw other) {
  realw ratio = other / density, one = splat_w(R(1.0));
  return one / fma_w(ratio, ratio, one);
}

/// The density with which `lights` draw what the paths' rays have found of them, in the lanes of `which`.
FN realw found_density_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which, intw lights,
                         const FoundLight_w* found) {
  which = which & s->hit;
  real3w towards = sub3_w(s->position, path->from);
  return sel_w(which, light_density_w(scene, which, lights, path->from, towards, s), found->density);
}

/// The radiance that the paths' rays have found, of the light that the header names where nothing is hit, weighted
/// against the density with which the path's last vertex draws this light.
FN void path_add_found_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, int header, FoundLight_w found) {
  realw zero = splat_w(R(0.0));
  real3w radiance = found.radiance;
  maskw is_bright = is_light_shown_w(scene, path) & not_black_w(radiance);
  if (!any_w(is_bright)) return;
  if (LIGHT_COUNT > 0) {
    intw lights = sel_int_w(s->hit, part_entry_w(scene, s, PART_LIGHT), splat_int_w(drawn_afar(scene, header)));
    maskw is_drawn = is_bright & lt_w(zero, path->density) & ~lt_int_w(lights, splat_int_w(0));
    if (any_w(is_drawn)) {
      realw density = found_density_w(scene, path, s, is_drawn, lights, &found);
      density = density / light_rarity_w(scene, lights, path->from);
      radiance = sel3_w(is_drawn, scale3_w(balance_w(path->density, density), radiance), radiance);
    }
  }
  path_add_w(path, is_bright, radiance);
}

/// All that the rays see.
FN void path_add_light_w(const Scene* scene, Paths_w* path, const Surfaces_w* s) {
  path_add_found_w(scene, path, s, HEADER_BACKGROUND, light_along_w(scene, path, s));
  if (HAS_SUN) path_add_found_w(scene, path, s, HEADER_SUN, sun_along_w(scene, path, s));
}

/// The light of one of the lights that are taken, or of one that is drawn from the others. is_shared: directions that
/// the material draws may find it too.
FN real3w light_gain_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, const Bsdf_w* b, maskw which,
                       int i, int is_shared, LightSample_w* light) {
  int taken = scene->index[HEADER_LIGHTS_TAKEN];
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), weight = one;
  LightNumbers_w numbers = no_numbers_w();
  intw lights = splat_int_w(i);
  if (i >= taken) {
    numbers = light_numbers_w(scene, &path->sample, path->depth);
    LightChoice_w choice = choose_light_w(scene, &path->sample, path->depth, s->position);
    lights = choice.light;
    weight = choice.rarity;
  }
  *light = light_sample_w(scene, which, lights, s->position, numbers);
  which = which & not_black_w(light->radiance);
  if (HAS_STRICT_NORMALS) which = on_one_side_w(scene, s, which, light->towards);
  realw density;
#if HAS_MEDIA
  real3w reflected = vertex_eval_w(scene, path, s, b, unit3_w(light->towards), &density);
#else
  real3w reflected = bsdf_eval_w(b, unit3_w(light->towards), &density);
#endif
  reflected = mul3_w(reflected, scale3_w(one / light->density, light->radiance));
  if (is_shared) weight = sel_w(light->is_delta, weight, weight * balance_w(light->density, weight * density));
  return sel3_w(which, scale3_w(weight, reflected), vec3_w(zero, zero, zero));
}

/// The light that shadow rays let through: one ray for each light that is taken and one for the lights that are drawn
/// from; or, for ambient occlusion, one ray.
FN void add_lights_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, const Bsdf_w* b, real3w wo, maskw which,
                     int next) {
  int is_open = HAS_OPENNESS && (next & STEP_OPENNESS) != 0;
  // Programs with lights that are drawn have a chooser of them.
  int count = CHOOSER_COUNT + DELTA_LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHT_COUNT];
  int taken = DELTA_LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHTS_TAKEN];
  int rays = count > taken ? taken + 1 : taken;
  if (is_open) rays = 1;
  for (int i = 0; i < rays; ++i) {
    LightSample_w light;
    real3w reflected;
    if (HAS_OPENNESS && is_open) {
      light = sky_sample_w(scene, path, s, wo);
      reflected = light.radiance;
    } else {
      reflected = light_gain_w(scene, path, s, b, which, i, next & STEP_SCATTER, &light);
    }
    maskw lit = which & not_black_w(reflected);
    if (!any_w(lit)) continue;
#if HAS_MEDIA
    if ((next & STEP_THROUGH) != 0) {
      real3w share = seen_share_w(scene, path, s, lit, light.towards, light.t_max, light.aim);
      path_add_w(path, lit, mul3_w(share, reflected));
      continue;
    }
#endif
    maskw seen = sees_along_w(scene, s, lit, light.towards, light.t_max, light.aim);
    path_add_w(path, seen, reflected);
  }
}

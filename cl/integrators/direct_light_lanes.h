// SPDX-License-Identifier: MIT
// Light at the surfaces of paths: what their rays find by themselves, and what lights that are drawn or taken throw on
// them, both weighted against each other. A program holds one traversal for shadows, here. One width; no guard.

/// What comes along the paths' rays by itself: the surfaces' emission, or the background where nothing is hit.
FN real3w LANED(radiance_along)(const Scene* scene, const LANED(Paths) * path, const LANED(Surfaces) * s) {
  real3w towards = LANED(real3_at)(path->rays.planes + RAY_PLANE_D);
  return sel3_w(s->hit, LANED(emitted_radiance)(scene, s), LANED(background_radiance)(scene, towards));
}

/// hide_emitters hides from the camera alone.
FN maskw LANED(is_light_shown)(const Scene* scene, const LANED(Paths) * path) {
  return hides_emitters(scene) ? path->alive & lt_int_w(splat_int_w(0), path->depth) : path->alive;
}

/// Of a direction that was drawn with `density` and could have been with `other`.
FN realw LANED(balance)(realw density, realw other) {
  realw ratio = other / density, one = splat_w(R(1.0));
  return one / fma_w(ratio, ratio, one);
}

/// radiance_along, weighted against its chance to be drawn as a light where the path was.
FN void LANED(path_add_light)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s) {
  realw zero = splat_w(R(0.0));
  maskw shown = LANED(is_light_shown)(scene, path);
  real3w radiance = LANED(radiance_along)(scene, path, s);
  maskw is_bright = shown & lt_w(zero, max3_w(radiance));
  if (!any_w(is_bright)) return;
  if (LIGHT_COUNT > 0) {
    intw lights =
        sel_int_w(s->hit, LANED(part_entry)(scene, s, PART_LIGHT), splat_int_w(scene->index[HEADER_BACKGROUND]));
    maskw is_drawn = is_bright & lt_w(zero, path->density) & ~lt_int_w(lights, splat_int_w(0));
    if (any_w(is_drawn)) {
      real3w ray = LANED(real3_at)(path->rays.planes + RAY_PLANE_D);
      real3w towards = sel3_w(s->hit, sub3_w(s->position, path->from), ray);
      realw density = LANED(light_density)(scene, is_drawn, lights, path->from, towards, s);
      density = density / LANED(light_rarity)(scene, lights, path->from);
      radiance = sel3_w(is_drawn, scale3_w(LANED(balance)(path->density, density), radiance), radiance);
    }
  }
  LANED(path_add)(path, is_bright, radiance);
}

/// One light of those that are taken, or one drawn of the others; is_shared: with ways that the material draws.
FN real3w LANED(light_gain)(const Scene* scene, const LANED(Paths) * path, const LANED(Surfaces) * s,
                            const LANED(Bsdf) * b, maskw which, int i, int is_shared, LANED(LightSample) * light) {
  int taken = scene->index[HEADER_LIGHTS_TAKEN];
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), weight = one;
  LANED(LightNumbers) numbers = LANED(no_numbers)();
  intw lights = splat_int_w(i);
  if (i >= taken) {
    numbers = LANED(light_numbers)(scene, &path->sample, path->depth);
    LANED(LightChoice) choice = LANED(choose_light)(scene, &path->sample, path->depth, s->position);
    lights = choice.light;
    weight = choice.rarity;
  }
  *light = LANED(light_sample)(scene, which, lights, s->position, numbers);
  which = which & lt_w(zero, max3_w(light->radiance));
  realw density;
  real3w reflected = LANED(bsdf_eval)(b, unit3_w(light->towards), &density);
  reflected = mul3_w(reflected, scale3_w(one / light->density, light->radiance));
  if (is_shared) weight = sel_w(light->is_delta, weight, weight * LANED(balance)(light->density, weight * density));
  return sel3_w(which, scale3_w(weight, reflected), vec3_w(zero, zero, zero));
}

/// What shadow rays let through: one for each light that is taken and one for those that are drawn from; or one into
/// the open.
FN void LANED(add_lights)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s, const LANED(Bsdf) * b,
                          real3w wo, maskw which, int next) {
  int is_open = HAS_OPENNESS && (next & STEP_OPENNESS) != 0;
  int count = LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHT_COUNT];
  int taken = LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHTS_TAKEN];
  int rays = count > taken ? taken + 1 : taken;
  if (is_open) rays = 1;
  for (int i = 0; i < rays; ++i) {
    LANED(LightSample) light;
    real3w reflected;
    if (HAS_OPENNESS && is_open) {
      light = LANED(sky_sample)(scene, path, s, wo);
      reflected = light.radiance;
    } else {
      reflected = LANED(light_gain)(scene, path, s, b, which, i, next & STEP_SCATTER, &light);
    }
    maskw lit = which & lt_w(splat_w(R(0.0)), max3_w(reflected));
    if (!any_w(lit)) continue;
    maskw seen = LANED(sees_along)(scene, s, lit, light.towards, light.t_max, light.aim);
    LANED(path_add)(path, seen, reflected);
  }
}

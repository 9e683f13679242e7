// SPDX-License-Identifier: MIT
// Emission plus light that reaches the first hit straight from point and directional lights, with hard shadows.
// Shadow rays leave their primitive by identity (core/ray.h): no offset, no epsilon. Depth counts as in Mitsuba:
// 1 shows emission alone, 2 one bounce. One width; no guard.

FN real3 direct_radiance(const Scene* scene, const Ray* ray, int hit, const Surface* s, int id) {
  int max_depth = scene->index[HEADER_MAX_DEPTH];
  real zero = R(0.0);
  real3 sum = vec3(zero, zero, zero);
  if (max_depth != 0 && scene->index[HEADER_HIDE_EMITTERS] == 0)
    sum = hit ? emitted_radiance(scene, s, ray->d) : background_radiance(scene);
  int lights = LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHT_COUNT];
  if (!hit || (max_depth >= 0 && max_depth < 2)) return sum;
  real3 wo = normalize3(negate3(ray->d));
  for (int i = 0; i < lights; ++i) {
    LightSample light = light_sample(scene, i, s->position);
    if (!(max3(light.irradiance) > zero)) continue;
    real3 reflected = mul3(material_eval(scene, s, normalize3(light.towards), wo), light.irradiance);
    if (!(max3(reflected) > zero)) continue;
    Ray shadow = ray_make(s->position, light.towards, zero, light.t_max, id);
    if (HAS_COUNT_RAYS) count_event(scene, COUNT_SHADOW);
    if (!LANED(any_hit)(scene, &shadow)) sum = add3(sum, reflected);
  }
  return sum;
}

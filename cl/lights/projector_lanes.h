// SPDX-License-Identifier: MIT
// Projector: a camera the other way round, as Mitsuba's plugin. Its picture is pi times the irradiance on a plane
// across its axis, at distance 1; with the square of the distance along the axis it falls off. Parameters: position
// x y z; what times a vector from there, over its distance along the axis, is -1 and 1 at the picture's edges, to the
// right and down, x y z each; unit axis x y z; pi times the irradiance, r g b.

enum { projector_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w projector_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  GLOBAL const real* params = scene->shading + at->row[LIGHT_REALS];
  (void)numbers;
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), half_one = splat_w(R(0.5));
  LightSample_w s = no_light_w();
  real3w lamp = splat3_w(load3(params));
  s.towards = sub3_w(lamp, from);
  realw length = length3_w(s.towards);
  s.t_max = way_to_lamp_w(lamp, from, length);
  realw along = -dot3_w(splat3_w(load3(params + 9)), s.towards);
  maskw is_before = lt_w(zero, along);
  along = sel_w(is_before, along, one);
  realw x = -dot3_w(splat3_w(load3(params + 3)), s.towards) / along;
  realw y = -dot3_w(splat3_w(load3(params + 6)), s.towards) / along;
  maskw is_lit = is_before & le_w(abs_w(x), one) & le_w(abs_w(y), one);
  // Over the cosine from the axis, and the square of the distance along it.
  realw inverse = one / along;
  real3w radiance = scale3_w(length * inverse * inverse, splat3_w(load3(params + 12)));
  radiance = scale3_w(inverse, radiance);
  if (HAS_LIGHT_TEXTURE && at->row[LIGHT_TEXTURE] >= 0) {
    TexturePlace_w place = texture_at_w(fma_w(half_one, x, half_one), fma_w(half_one, y, half_one));
    radiance = mul3_w(radiance, texture_value_w(scene, at->row[LIGHT_TEXTURE], &place));
  }
  s.radiance = sel3_w(is_lit, radiance, s.radiance);
  s.is_delta = ~none_w();
  return s;
}

#if HAS_LIGHT_PATHS
/// Places on the picture are drawn uniformly.
FN LightRay_w projector_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  LightRows_w at = rows_of_light_w(scene, row);
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  realw one = splat_w(R(1.0)), two = splat_w(R(2.0));
  real3 right = load3(params + 3), down = load3(params + 6);
  real over_right = R(1.0) / dot3(right, right), over_down = R(1.0) / dot3(down, down);
  (void)way;
  LightRay_w ray = no_light_ray_w();
  ray.from = splat3_w(load3(params));
  real3w out = fma3_w(fma_w(two, numbers.u, -one), splat3_w(scale3(over_right, right)), splat3_w(load3(params + 9)));
  out = fma3_w(fma_w(two, numbers.v, -one), splat3_w(scale3(over_down, down)), out);
  realw cosine = one / length3_w(out);
  ray.way = scale3_w(cosine, out);
  LightSample_w s = projector_sample_w(scene, &at, point_in_way_w(ray.from, out), numbers);
  // The picture is 4 tan_x tan_y large at distance 1, and the solid angle of a part of it is the cube of the cosine.
  realw solid = splat_w(R(4.0) * real_sqrt(over_right * over_down)) * (cosine * cosine * cosine);
  ray.flux = scale3_w(solid, intensity_of_w(&s));
  return ray;
}

FN realw projector_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  real3 right = load3(params + 3), down = load3(params + 6);
  realw cosine = dot3_w(way, splat3_w(load3(params + 9)));
  real picture = R(4.0) / real_sqrt(dot3(right, right) * dot3(down, down));
  return splat_w(R(1.0)) / (splat_w(picture) * (cosine * cosine * cosine));
}
#endif

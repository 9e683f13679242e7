// SPDX-License-Identifier: MIT
// Projector: a camera the other way round, as Mitsuba's plugin. Its picture is pi times the irradiance on a plane
// across its axis, at distance 1; with the square of the distance along the axis it falls off. Parameters: position
// x y z; what times a vector from there, over its distance along the axis, is -1 and 1 at the picture's edges, to the
// right and down, x y z each; unit axis x y z; pi times the irradiance, r g b.

enum { projector_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w projector_sample_w(const Scene* scene, GLOBAL const int* row, real3w from, LightNumbers_w numbers) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
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
  if (HAS_LIGHT_TEXTURE && row[LIGHT_TEXTURE] >= 0) {
    TexturePlace_w at = texture_at_w(fma_w(half_one, x, half_one), fma_w(half_one, y, half_one));
    radiance = mul3_w(radiance, texture_value_w(scene, row[LIGHT_TEXTURE], &at));
  }
  s.radiance = sel3_w(is_lit, radiance, s.radiance);
  s.is_delta = ~none_w();
  return s;
}

// SPDX-License-Identifier: MIT
// The sample of a light, as seen from a point. One width; no guard.

typedef struct {
  real3w towards;   ///< To the light; where it has a place, exactly to it: t = 1 is the light.
  realw t_max;      ///< How far along `towards` the way must be free.
  real3w radiance;  ///< From there; of a delta light the irradiance across `towards`. Zero: no light from there.
  realw density;    ///< Of that direction, per solid angle, > 0 where there is light; of a delta light 1.
  maskw is_delta;   ///< The light's only direction: no ray finds it, and it has no density over the sphere.
  intw aim;         ///< Id of the primitive that the place is on; -1: none.
} LightSample_w;

/// What rays find of a light.
typedef struct {
  real3w radiance;
  realw density;  ///< With which a light that is infinitely far away draws their directions, per solid angle.
} FoundLight_w;

FN FoundLight_w no_light_found_w(void) {
  FoundLight_w found;
  realw zero = splat_w(R(0.0));
  found.radiance = vec3_w(zero, zero, zero);
  found.density = zero;
  return found;
}

/// What a light draws besides a place or a direction, name_NUMBERS of its file.
enum { NUMBERS_NONE_w = 0, NUMBERS_TEXEL_w = 1 };

/// The numbers with which a light draws a place or a direction, each for one purpose.
typedef struct {
  uintw item;         ///< Which item; 0 where no light that is drawn has several.
  uintw row, column;  ///< Which texel; 0 where no light is an image.
  realw u, v;         ///< Within (0, 1).
} LightNumbers_w;

/// For lights that draw nothing.
FN LightNumbers_w no_numbers_w(void) {
  LightNumbers_w numbers;
  numbers.item = numbers.row = numbers.column = splat_uint_w(0u);
  numbers.u = numbers.v = splat_w(R(0.5));
  return numbers;
}

FN LightSample_w no_light_w(void) {
  LightSample_w s;
  realw zero = splat_w(R(0.0));
  s.towards = s.radiance = vec3_w(zero, zero, zero);
  s.t_max = zero;
  s.density = splat_w(R(1.0));
  s.is_delta = none_w();
  s.aim = splat_int_w(-1);
  return s;
}

/// A bound on the rounding of two places and of the t at which a ray from one hits a surface at the other.
FN realw places_rounding_w(real3w a, real3w b) {
  return splat_w(R(16.0) * real_roundoff()) * (max3_w(abs3_w(a)) + max3_w(abs3_w(b)));
}

/// How near to a lamp at a point shadow rays end, and light rays begin, so that a lamp that lies on a surface, in a
/// ceiling, is not hidden by it. Ample, since a ray may meet that surface at a shallow angle.
FN realw lamp_clearance_w(real3w lamp, real3w from) {
#if TIER_FAST
  (void)lamp;
  (void)from;
  return splat_w(FAST_EPSILON);
#else
  return splat_w(R(4.0)) * places_rounding_w(lamp, from);
#endif
}

/// LightSample.t_max of a lamp at a point. length: of the way from there to it.
FN realw way_to_lamp_w(real3w lamp, real3w from, realw length) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  return max_w(one - lamp_clearance_w(lamp, from) / sel_w(lt_w(zero, length), length, one), zero);
}

/// m ? a : b.
INLINE_FN LightSample_w sel_light_w(maskw m, LightSample_w a, LightSample_w b) {
  a.towards = sel3_w(m, a.towards, b.towards);
  a.t_max = sel_w(m, a.t_max, b.t_max);
  a.radiance = sel3_w(m, a.radiance, b.radiance);
  a.density = sel_w(m, a.density, b.density);
  a.is_delta = (m & a.is_delta) | (~m & b.is_delta);
  a.aim = sel_int_w(m, a.aim, b.aim);
  return a;
}

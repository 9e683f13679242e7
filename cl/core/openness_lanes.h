// SPDX-License-Identifier: MIT
// Ways from surfaces into the open, drawn in proportion to their cosine: S. Zhukov, A. Iones, G. Kronin, "An Ambient
// Light Illumination Model", EGWR 1998. One width; no guard.

/// On the side of wo; what it brings is white.
FN LANED(LightSample)
    LANED(sky_sample)(const Scene* scene, const LANED(Paths) * path, const LANED(Surfaces) * s, real3w wo) {
  LANED(Random2) numbers = LANED(vertex_pair)(scene, &path->sample, path->depth, USE_WAY);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  real3w z = sel3_w(lt_w(dot3_w(wo, s->shading), zero), negate3_w(s->shading), s->shading);
  LANED(Frame) frame = LANED(frame_around)(z);
  LANED(LightSample) sky = LANED(no_light)();
  real3w up = LANED(square_to_cosine_hemisphere)(LANED(random_between)(numbers.x), LANED(random_between)(numbers.y));
  sky.towards = LANED(from_frame)(&frame, up);
  sky.t_max = splat_w(scene->shading[scene->index[HEADER_REACH]]);
  sky.radiance = vec3_w(one, one, one);
  return sky;
}

// SPDX-License-Identifier: MIT
// Directions from surfaces for ambient occlusion, drawn in proportion to their cosine: S. Zhukov, A. Iones, G. Kronin,
// "An Ambient Light Illumination Model", EGWR 1998. One width; no guard.

/// Draws a direction on the side of wo. Its radiance is 1.
FN LightSample_w sky_sample_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, real3w wo) {
  Random2_w numbers = vertex_pair_w(scene, &path->sample, path->depth, USE_WAY);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  real3w z = sel3_w(lt_w(dot3_w(wo, s->shading), zero), negate3_w(s->shading), s->shading);
  Frame_w frame = frame_around_w(z);
  LightSample_w sky = no_light_w();
  real3w up = square_to_cosine_hemisphere_w(random_between_w(numbers.x), random_between_w(numbers.y));
  sky.towards = from_frame_w(&frame, up);
  sky.t_max = splat_w(scene->shading[scene->index[HEADER_REACH]]);
  sky.radiance = vec3_w(one, one, one);
  return sky;
}

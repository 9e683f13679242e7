// SPDX-License-Identifier: MIT
// Lights infinitely far away: the light's own name_sample draws a direction, and the place is drawn from the disc
// across it that covers the ball around everything bounded. One width; no guard.

/// The same from wherever it is asked.
FN real3w anywhere_w(void) {
  realw zero = splat_w(R(0.0));
  return vec3_w(zero, zero, zero);
}

/// Of the disc. Wider than rounding has it by far.
FN real far_radius_w(const Scene* scene) {
  GLOBAL const real* bounds = scene->geometry + scene->index[HEADER_BOUNDS];
  return length3(load3(bounds + 3)) * R(0x1.004p+0);
}

FN realw far_spread_w(const Scene* scene) {
  real radius = far_radius_w(scene);
  return splat_w(R(1.0) / (PI * radius * radius));
}

/// s: the light's sample, from anywhere.
FN LightRay_w far_ray_w(const Scene* scene, LightSample_w s, Real2_w place) {
  GLOBAL const real* bounds = scene->geometry + scene->index[HEADER_BOUNDS];
  real radius = far_radius_w(scene);
  real3w towards = unit3_w(s.towards);
  Frame_w frame = frame_around_w(towards);
  Real2_w disk = square_to_disk_w(place.x, place.y);
  real3w across = from_frame_w(&frame, vec3_w(disk.x, disk.y, splat_w(R(1.0))));
  LightRay_w ray = no_light_ray_w();
  ray.from = fma3_w(splat_w(radius), across, splat3_w(load3(bounds)));
  ray.way = negate3_w(towards);
  ray.is_far = ~none_w();
  ray.inverse = sel_w(s.is_delta, splat_w(R(0.0)), splat_w(R(1.0)) / s.density);
  ray.flux = scale3_w(splat_w(PI * radius * radius) / s.density, s.radiance);
  return ray;
}

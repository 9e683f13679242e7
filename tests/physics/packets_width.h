// SPDX-License-Identifier: MIT
// The questions of a PacketTier at one width; no guard. Within the tier's namespace.
#include "physics/shading_width.h"

inline real3w LANED(splat_triad)(const Triad& v) { return splat3_w(vec3((real)v[0], (real)v[1], (real)v[2])); }

/// Calls visit(i, lane) for at most LANES rays of [first, count).
template <class Visit>
void LANED(for_lanes)(std::size_t first, std::size_t count, Visit visit) {
  for (int lane = 0; lane < LANES && first + (std::size_t)lane < count; ++lane) visit(first + (std::size_t)lane, lane);
}

/// Rays of paths that have left no surface.
inline Rays_w LANED(rays_from)(real3w o, real3w d, realw t_min, realw t_max, intw departed) {
  Rays_w rays;
  rays_make_w(o, d, t_min, t_max, nonzero_w(departed + splat_int_w(1)), &rays);
  rays.departed = departed;
  rays.departed_instance = rays.aim = splat_int_w(-1);
  rays.is_outward = splat_int_w(0);
  return rays;
}

/// The rays from `first` on, one a lane; lanes beyond the last ray repeat it.
inline Rays_w LANED(rays_at)(const std::vector<GivenRay>& all, std::size_t first) {
  real3w o = LANED(splat_triad)({0, 0, 0}), d = o;
  realw t_min = splat_w(R(0.0)), t_max = t_min;
  intw departed = splat_int_w(-1);
  for (int lane = 0; lane < LANES; ++lane) {
    const GivenRay& ray = all[std::min(first + (std::size_t)lane, all.size() - 1)];
    put_real3_w(&o, lane, vec3((real)ray.o[0], (real)ray.o[1], (real)ray.o[2]));
    put_real3_w(&d, lane, vec3((real)ray.d[0], (real)ray.d[1], (real)ray.d[2]));
    put_w(&t_min, lane, (real)ray.t_min);
    put_w(&t_max, lane, (real)ray.t_max);
    put_int_w(&departed, lane, ray.departed);
  }
  return LANED(rays_from)(o, d, t_min, t_max, departed);
}

#if LANES == 1
inline std::vector<FoundHit> LANED(find_alone)(const TierBuffers& buffers, const std::vector<GivenRay>& rays,
                                               bool any) {
  const Scene scene = scene_of(buffers);
  std::vector<FoundHit> found(rays.size());
  for (std::size_t first = 0; first < rays.size(); first += LANES) {
    const Rays_w together = LANED(rays_at)(rays, first);
    LANED(for_lanes)
    (first, rays.size(), [&](std::size_t i, int lane) {
      const Ray ray = ray_of_w(&together, lane);
      const Nearest hit = closest_hit_w(&scene, &ray, any ? FIND_ANY : FIND_NEAREST);
      found[i] = {hit.t, hit.id, hit.kind};
    });
  }
  return found;
}

#else
inline std::vector<FoundHit> LANED(find_packets)(const TierBuffers& buffers, const std::vector<GivenRay>& rays,
                                                 bool any) {
  const Scene scene = scene_of(buffers);
  std::vector<FoundHit> found(rays.size());
  for (std::size_t first = 0; first < rays.size(); first += LANES) {
    Rays_w together = LANED(rays_at)(rays, first);
    widen_w(&scene, &together);
    const NearestEach_w each = packet_traverse_w(&scene, &together, any ? FIND_ANY : FIND_NEAREST);
    LANED(for_lanes)
    (first, rays.size(), [&](std::size_t i, int lane) {
      found[i] = {get_w(&each.t, lane), get_int_w(&each.id, lane), get_int_w(&each.kind, lane)};
    });
  }
  return found;
}

/// Lanes of `rays` that packet_make_w does not take for dead.
inline unsigned LANED(living_lanes)(const Rays_w& rays) {
  return bits_w(le_w(rays.planes[RAY_PLANE_T_MIN], rays.planes[RAY_PLANE_T_MAX]));
}

inline std::array<unsigned, 2> LANED(walked_lanes)(const TierBuffers& buffers, const GivenRay& ray, unsigned alive) {
  const Scene scene = scene_of(buffers);
  const FirstSamples unreported{nullptr, nullptr, 0, 0, 0, 0u};
  const Rays_w rays = LANED(rays_at)({ray}, 0);
  const maskw which = nonzero_w(int_of_uint_w(splat_uint_w(alive) >> lane_numbers_w() & 1u));
  std::array<unsigned, 2> walked{};
  for (std::size_t is_left_over = 0; is_left_over < 2; ++is_left_over) {
    Paths_w path;
    paths_none_w(&path);
    if (is_left_over != 0) paths_begin_w(&scene, &path, ~none_w(), &rays);
    path.alive = none_w();
    paths_begin_w(&scene, &path, which, &rays);
    find_surfaces_w(&scene, &path, FIND_NEAREST, &unreported);
    walked[is_left_over] = LANED(living_lanes)(path.rays);
  }
  return walked;
}
#endif

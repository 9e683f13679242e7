// SPDX-License-Identifier: MIT
// The questions of transport_tiers.h at one width; no guard. Within the tier's namespace.
#include "physics/packets_width.h"
// It comes first: this needs what it includes.
#include "integrators/light_begin_lanes.h"
// Both need it.
#include "integrators/both_ends_lanes.h"
#include "integrators/light_paths_lanes.h"

inline Triad LANED(triad_at)(const real3w& v, int lane) {
  return {get_w(&v.x, lane), get_w(&v.y, lane), get_w(&v.z, lane)};
}

inline LightNumbers_w LANED(numbers_at)(const std::vector<PlaceNumbers>& all, std::size_t first) {
  LightNumbers_w numbers = no_numbers_w();
  intw item = splat_int_w(0), row = item, column = item;
  LANED(for_lanes)
  (first, all.size(), [&](std::size_t i, int lane) {
    put_int_w(&item, lane, (int)all[i].item);
    put_int_w(&row, lane, (int)all[i].row);
    put_int_w(&column, lane, (int)all[i].column);
    put_w(&numbers.u, lane, (real)all[i].u);
    put_w(&numbers.v, lane, (real)all[i].v);
  });
  numbers.item = uint_of_int_w(item);
  numbers.row = uint_of_int_w(row);
  numbers.column = uint_of_int_w(column);
  return numbers;
}

inline std::vector<LightDraw> LANED(draw_lights)(const TierBuffers& buffers, const std::vector<int>& lights,
                                                 const Triad& from, const std::vector<PlaceNumbers>& numbers) {
  const Scene scene = scene_of(buffers);
  std::vector<LightDraw> drawn(numbers.size());
  for (std::size_t first = 0; first < numbers.size(); first += LANES) {
    intw asked = splat_int_w(lights.front());
    if (lights.size() > 1) LANED(for_lanes)
    (first, numbers.size(), [&](std::size_t i, int lane) { put_int_w(&asked, lane, lights[i]); });
    const LightSample_w s =
        light_sample_w(&scene, ~none_w(), asked, LANED(splat_triad)(from), LANED(numbers_at)(numbers, first));
    const uint deltas = bits_w(s.is_delta);
    LANED(for_lanes)
    (first, numbers.size(), [&](std::size_t i, int lane) {
      drawn[i] = {LANED(triad_at)(s.towards, lane), LANED(triad_at)(s.radiance, lane), get_w(&s.t_max, lane),
                  get_w(&s.density, lane),          (deltas >> lane & 1u) != 0u,       get_int_w(&s.aim, lane)};
    });
  }
  return drawn;
}

inline std::vector<int> LANED(chosen_items)(const std::vector<std::int32_t>& tables, int first, unsigned items,
                                            const std::vector<std::uint32_t>& numbers) {
  std::vector<int> chosen(numbers.size());
  for (std::size_t begin = 0; begin < numbers.size(); begin += LANES) {
    intw number = splat_int_w(0);
    LANED(for_lanes)
    (begin, numbers.size(), [&](std::size_t i, int lane) { put_int_w(&number, lane, (int)numbers[i]); });
    const intw item = chosen_item_w(tables.data(), splat_int_w(first), items, uint_of_int_w(number));
    LANED(for_lanes)
    (begin, numbers.size(), [&](std::size_t i, int lane) { chosen[i] = get_int_w(&item, lane); });
  }
  return chosen;
}

inline std::vector<AreaDraw> LANED(area_places)(const TierBuffers& buffers, int light, const Triad& from,
                                                const std::vector<PlaceNumbers>& numbers) {
  const Scene scene = scene_of(buffers);
  const int* row = light_row(&scene, light);
  const LightRows_w lights = rows_of_light_w(&scene, row);
  realw area[AREA_ITEMS];
  light_reals_w(&scene, &lights, AREA_ITEMS, area);
  std::vector<AreaDraw> drawn(numbers.size());
  for (std::size_t first = 0; first < numbers.size(); first += LANES) {
    const LightNumbers_w drawing = LANED(numbers_at)(numbers, first);
    const AreaPoint_w p = area_point_w(&scene, &lights, area, LANED(splat_triad)(from),
                                       area_item_w(&scene, row, drawing.item), drawing.u, drawing.v);
    const realw bound = area_rounding_w(p.position, LANED(splat_triad)(from), p.reach);
    LANED(for_lanes)
    (first, numbers.size(), [&](std::size_t i, int lane) {
      drawn[i] = {LANED(triad_at)(p.position, lane), LANED(triad_at)(p.normal, lane), get_w(&p.density, lane),
                  get_w(&bound, lane)};
    });
  }
  return drawn;
}

inline std::vector<Sight> LANED(look_along)(const TierBuffers& buffers, const Triad& at,
                                            const std::vector<Triad>& directions) {
  const Scene scene = scene_of(buffers);
  const FirstSamples unreported{nullptr, nullptr, 0, 0, 0, 0u};
  const real3w from = LANED(splat_triad)(at);
  std::vector<Sight> seen(directions.size());
  for (std::size_t first = 0; first < directions.size(); first += LANES) {
    real3w d = LANED(splat_triad)({0, 0, 1});
    LANED(for_lanes)
    (first, directions.size(), [&](std::size_t i, int lane) {
      put_real3_w(&d, lane, vec3((real)directions[i][0], (real)directions[i][1], (real)directions[i][2]));
    });
    const Rays_w rays = LANED(rays_from)(from, d, splat_w(R(0.0)), splat_w(REAL_MAX), splat_int_w(-1));
    Paths_w path;
    paths_none_w(&path);
    paths_begin_w(&scene, &path, ~none_w(), &rays);
    const Surfaces_w s = find_surfaces_w(&scene, &path, FIND_NEAREST, &unreported);
    const real3w sun = sun_along_w(&scene, &path, &s).radiance;
    const real3w radiance = add3_w(light_along_w(&scene, &path, &s).radiance, sun);
    // As path_add_light does; the sun before the background.
    const intw afar = sel_int_w(lt_w(splat_w(R(0.0)), max3_w(sun)), splat_int_w(scene.index[HEADER_SUN]),
                                splat_int_w(scene.index[HEADER_BACKGROUND]));
    const intw lights = sel_int_w(s.hit, part_entry_w(&scene, &s, PART_LIGHT), afar);
    const real3w towards = sel3_w(s.hit, sub3_w(s.position, from), d);
    const realw density = light_density_w(&scene, ~lt_int_w(lights, splat_int_w(0)), lights, from, towards, &s);
    LANED(for_lanes)
    (first, directions.size(), [&](std::size_t i, int lane) {
      seen[i] = {LANED(triad_at)(radiance, lane), get_int_w(&lights, lane), get_w(&density, lane),
                 LANED(triad_at)(s.position, lane)};
    });
  }
  return seen;
}

inline double LANED(density_towards)(const TierBuffers& buffers, int light, const Triad& from, const Triad& direction) {
  const Scene scene = scene_of(buffers);
  const Surfaces_w none = surfaces_none_w();
  const realw density = light_density_w(&scene, ~none_w(), splat_int_w(light), LANED(splat_triad)(from),
                                        LANED(splat_triad)(direction), &none);
  return get_w(&density, LANES - 1);
}

inline std::vector<LightPick> LANED(pick_lights)(const TierBuffers& buffers, const Triad& at, std::uint32_t count) {
  const Scene scene = scene_of(buffers);
  const real3w from = LANED(splat_triad)(at);
  std::vector<LightPick> picked(count);
  for (std::uint32_t first = 0; first < count; first += LANES) {
    const SampleState_w sample = sample_begin_w(&scene, splat_uint_w(0u), lane_numbers_w() + first);
    const LightChoice_w choice = choose_light_w(&scene, &sample, splat_int_w(0), from);
    const realw told = light_rarity_w(&scene, choice.light, from);
    LANED(for_lanes)
    (first, count, [&](std::size_t i, int lane) {
      picked[i] = {get_int_w(&choice.light, lane), get_w(&choice.rarity, lane), get_w(&told, lane)};
    });
  }
  return picked;
}

inline double LANED(rarity_of)(const TierBuffers& buffers, int light, const Triad& from) {
  const Scene scene = scene_of(buffers);
  const realw rarity = light_rarity_w(&scene, splat_int_w(light), LANED(splat_triad)(from));
  return get_w(&rarity, LANES - 1);
}

inline std::vector<Triad> LANED(texture_values)(const TierBuffers& buffers, int texture,
                                                const std::vector<TexturePlace>& points) {
  const Scene scene = scene_of(buffers);
  std::vector<Triad> found(points.size());
  for (std::size_t first = 0; first < points.size(); first += LANES) {
    Surfaces_w s = surfaces_none_w();
    s.hit = ~none_w();
    LANED(for_lanes)
    (first, points.size(), [&](std::size_t i, int lane) {
      put_w(&s.tex_u, lane, (real)points[i].u);
      put_w(&s.tex_v, lane, (real)points[i].v);
      put_w(&s.own_u, lane, (real)points[i].u);
      put_w(&s.own_v, lane, (real)points[i].v);
      put_w(&s.footprint, lane, (real)points[i].footprint);
    });
    const TexturePlace_w at = texture_place_w(&scene, &s);
    const real3w value = texture_value_w(&scene, texture, &at);
    LANED(for_lanes)(first, points.size(), [&](std::size_t i, int lane) { found[i] = LANED(triad_at)(value, lane); });
  }
  return found;
}

inline void LANED(put_triad)(real3w* to, int lane, const Triad& v) {
  put_real3_w(to, lane, vec3((real)v[0], (real)v[1], (real)v[2]));
}

/// As many places as there are lanes, from the first on; the lanes beyond the last are as the surface is upright.
inline Surfaces_w LANED(surfaces_at)(const std::vector<SeenPlace>& places, std::size_t first, real3w* out,
                                     realw* number) {
  Surfaces_w s = surfaces_none_w();
  s.hit = ~none_w();
  s.normal = s.shading = *out = LANED(splat_triad)({0, 0, 1});
  s.along = s.grad_u = LANED(splat_triad)({1, 0, 0});
  s.grad_v = LANED(splat_triad)({0, 1, 0});
  *number = splat_w(R(0.5));
  LANED(for_lanes)
  (first, places.size(), [&](std::size_t i, int lane) {
    put_w(&s.tex_u, lane, (real)places[i].u);
    put_w(&s.tex_v, lane, (real)places[i].v);
    put_w(number, lane, (real)places[i].number);
    LANED(put_triad)(out, lane, places[i].out);
  });
  return s;
}

inline std::vector<DrawnRow> LANED(material_rows)(const TierBuffers& buffers, const std::vector<SeenPlace>& places) {
  const Scene scene = scene_of(buffers);
  std::vector<DrawnRow> found(places.size());
  for (std::size_t first = 0; first < places.size(); first += LANES) {
    real3w out;
    realw number;
    const Surfaces_w s = LANED(surfaces_at)(places, first, &out, &number);
    const MaterialRows_w m = rows_at_w(&scene, &s, s.hit, out, number);
    LANED(for_lanes)
    (first, places.size(), [&](std::size_t i, int lane) {
      found[i] = {(get_int_w(&m.rows, lane) - scene.index[HEADER_MATERIALS]) / MATERIAL_INTS,
                  LANED(triad_at)(m.normal, lane), get_w(&m.opacity, lane)};
    });
  }
  return found;
}

inline std::vector<Lit> LANED(lit_places)(const TierBuffers& buffers, const std::vector<SeenPlace>& places,
                                          const std::vector<Triad>& wi, const std::vector<Triad>& numbers) {
  const Scene scene = scene_of(buffers);
  std::vector<Lit> found(places.size());
  for (std::size_t first = 0; first < places.size(); first += LANES) {
    real3w out, towards = LANED(splat_triad)({0, 0, 1}), drawing = LANED(splat_triad)({0.5, 0.5, 0.5});
    realw number, density;
    const Surfaces_w s = LANED(surfaces_at)(places, first, &out, &number);
    LANED(for_lanes)
    (first, places.size(), [&](std::size_t i, int lane) {
      LANED(put_triad)(&towards, lane, wi[i]);
      LANED(put_triad)(&drawing, lane, numbers[i]);
    });
    const MaterialRows_w m = rows_at_w(&scene, &s, s.hit, out, number);
    const Bsdf_w b = bsdf_at_w(&scene, &s, &m, out);
    const real3w value = bsdf_eval_w(&b, towards, &density);
    const BsdfSample_w way = bsdf_sample_w(&b, LOBES_ALL, drawing.x, drawing.y, drawing.z);
    LANED(for_lanes)
    (first, places.size(), [&](std::size_t i, int lane) {
      found[i] = {LANED(triad_at)(value, lane),      get_w(&density, lane),     LANED(triad_at)(way.wi, lane),
                  LANED(triad_at)(way.weight, lane), get_w(&way.density, lane), get_int_w(&way.lobe, lane)};
    });
  }
  return found;
}

inline std::vector<Mapped> LANED(mapped_at)(const TierBuffers& buffers, const std::vector<GivenRay>& given) {
  const Scene scene = scene_of(buffers);
  const FirstSamples unreported{nullptr, nullptr, 0, 0, 0, 0u};
  std::vector<Mapped> found(given.size());
  for (std::size_t first = 0; first < given.size(); first += LANES) {
    const Rays_w rays = LANED(rays_at)(given, first);
    Paths_w path;
    paths_none_w(&path);
    paths_begin_w(&scene, &path, ~none_w(), &rays);
    const Surfaces_w s = find_surfaces_w(&scene, &path, FIND_NEAREST, &unreported);
    LANED(for_lanes)
    (first, given.size(), [&](std::size_t i, int lane) {
      found[i] = {LANED(triad_at)(s.position, lane), get_w(&s.tex_u, lane), get_w(&s.tex_v, lane),
                  LANED(triad_at)(s.grad_u, lane), LANED(triad_at)(s.grad_v, lane)};
    });
  }
  return found;
}

inline std::vector<double> LANED(angles_of)(const std::vector<TexturePlace>& points) {
  std::vector<double> found(points.size());
  for (std::size_t first = 0; first < points.size(); first += LANES) {
    realw x = splat_w(R(0.0)), y = x;
    LANED(for_lanes)
    (first, points.size(), [&](std::size_t i, int lane) {
      put_w(&x, lane, (real)points[i].u);
      put_w(&y, lane, (real)points[i].v);
    });
    const realw angle = atan2_turns_w(y, x);
    LANED(for_lanes)(first, points.size(), [&](std::size_t i, int lane) { found[i] = get_w(&angle, lane); });
  }
  return found;
}

/// As kernels/render.cl follows the samples of a pixel, except that all samples begin and end together.
inline std::vector<Triad> LANED(radiance_along)(const TierBuffers& buffers, const GivenRay& ray,
                                                std::uint32_t samples) {
  uint counters[COUNTERS] = {};
  Scene scene = scene_of(buffers);
  scene.counters = counters;
  const FirstSamples unreported{nullptr, nullptr, 0, 0, 0, 0u};
  const Rays_w rays = LANED(rays_at)({ray}, 0);
  std::vector<Triad> found(samples);
  for (std::uint32_t first = 0; first < samples; first += LANES) {
    Paths_w path;
    paths_none_w(&path);
    Branches_w branches;
    branches.count = splat_int_w(0);
    path.sample = sample_begin_w(&scene, splat_uint_w(0u), lane_numbers_w() + first);
    paths_begin_w(&scene, &path, ~none_w(), &rays);
    while (any_w(path.alive)) {
#if HAS_MEDIA
      const Outlook_w outlook = look_ahead_w(&scene, &path, none_w());
      Surfaces_w s = meet_surfaces_w(&scene, &path, FIND_NEAREST, &unreported);
      media_travel_w(&scene, &path, &outlook, &s);
#else
      const Surfaces_w s = find_surfaces_w(&scene, &path, FIND_NEAREST_APPROXIMATELY, &unreported);
#endif
      surface_step_w(&scene, &path, &s, &branches);
    }
    LANED(for_lanes)(first, samples, [&](std::size_t i, int lane) { found[i] = LANED(triad_at)(path.radiance, lane); });
  }
  return found;
}

/// As kernels/light_tracing.cl and kernels/bidirectional.cl follow them, except that all paths begin and end together:
/// the film of a pixel, its splats' sums and those of its own camera paths.
inline std::vector<std::int64_t> LANED(splats_of)(const TierBuffers& buffers, std::uint32_t samples) {
  uint counters[COUNTERS] = {};
  std::vector<std::int64_t> words(FILM_SUBSUMS * FILM_CHANNELS * (SPLAT_WORDS + FILM_SUM_WORDS), 0);
  const SplatFilm film{words.data(), 0, 0, 1, 1, FILM_SUBSUMS, static_cast<int>(words.size()), nullptr};
  Scene scene = scene_of(buffers);
  scene.counters = counters;
  scene.splats = &film;
  Branches_w branches;
  branches.count = splat_int_w(0);
  for (std::uint32_t first = 0; first < samples; first += LANES) {
    Paths_w path;
    paths_none_w(&path);
    const uintw numbers = lane_numbers_w() + first;
    NewPaths_w begun = {lt_int_w(int_of_uint_w(numbers), splat_int_w((int)samples)), splat_uint_w(0u), numbers};
    if (scene.index[HEADER_INTEGRATOR] == INTEGRATOR_bdpt) {
      LightVertices_w light;
      follow_both_ends_w(&scene, &path, &light, &begun);
      continue;
    }
    do {
      follow_light_paths_w(&scene, &path, &branches, &begun);
      begun.which = none_w();
    } while (any_w(path.alive));
  }
  return words;
}

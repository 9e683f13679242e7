// SPDX-License-Identifier: MIT
// A medium that varies over a box; outside it there is none. Places where a path could scatter are drawn cell by cell
// (media/march_lanes.h); there it does with the medium's share of the cell's largest sigma_t. What a shadow ray loses
// at each of them is that share (ratio tracking: J. Novak, A. Selle, W. Jarosz, "Residual Ratio Tracking for Estimating
// Attenuation in Participating Media", ACM TOG 33(6), 2014). One width; no guard.

/// Of the places of m: the share of `most` that sigma_t is, by channel.
FN real3w density_share_w(const Scene* scene, GLOBAL const int* volumes, real3w place, realw most) {
  realw one = splat_w(R(1.0)), inverse = one / most;
  real3w share = scale3_w(inverse, volume_value_w(scene, volumes, place));
  return vec3_w(min_w(share.x, one), min_w(share.y, one), min_w(share.z, one));
}

/// Where a path scatters is drawn cell by cell, on its way.
FN realw heterogeneous_reach_w(const Scene* scene, GLOBAL const int* row, const SampleState_w* sample, realw optical) {
  (void)scene;
  (void)row;
  (void)sample;
  (void)optical;
  return splat_w(REAL_MAX);
}

FN void heterogeneous_travel_w(const Scene* scene, GLOBAL const int* row, const SampleState_w* sample, maskw which,
                               Flight_w* w) {
  GLOBAL const int* cells = scene->index + row[MEDIUM_MAJORANTS];
  GLOBAL const int* volumes = scene->index + row[MEDIUM_VOLUMES];
  bool is_grey = row[MEDIUM_IS_GREY] != 0, scatters = row[MEDIUM_SCATTERS] != 0, emits = row[MEDIUM_EMITS] != 0;
  real3w zeros = splat3_w(vec3(R(0.0), R(0.0), R(0.0))), ones = splat3_w(vec3(R(1.0), R(1.0), R(1.0)));
  March_w m = march_begin_w(scene, cells, w, which);
  while (any_w(m.goes)) {
    realw most;
    maskw here = march_w(scene, cells, &m, &w->optical, &most);
    if (!any_w(here)) break;
    Random4_w numbers = stream_numbers_w(sample, here, &w->draws);
    real3w place = fma3_w(m.t, w->d, w->from);
    real3w share = density_share_w(scene, volumes + VOLUME_SIGMA_T * VOLUME_INTS, place, most);
    real3w rest = sub3_w(ones, share);
    if (emits) {
      real3w glow = volume_value_w(scene, volumes + VOLUME_EMISSION * VOLUME_INTS, place);
      glow = mul3_w(mul3_w(share, glow), w->throughput);
      w->radiance = add3_w(w->radiance, sel3_w(here, glow, zeros));
    }
    w->optical = sel_w(here, optical_depth_w(numbers.y, numbers.z), w->optical);
    if (!scatters) {
      // What only absorbs ends no path.
      w->throughput = sel3_w(here, mul3_w(rest, w->throughput), w->throughput);
      m.goes = m.goes & (~here | lt_w(splat_w(R(0.0)), max3_w(w->throughput)));
      continue;
    }
    realw chosen = is_grey ? share.x : of_hero_w(scene, sample, share);
    maskw turns = here & lt_w(random_unit_w(numbers.x), chosen);
    real3w albedo = zeros;
    if (any_w(turns)) albedo = volume_value_w(scene, volumes + VOLUME_ALBEDO * VOLUME_INTS, place);
    if (is_grey) {
      w->throughput = sel3_w(turns, mul3_w(albedo, w->throughput), w->throughput);
    } else {
      flight_event_w(w, here, sel3_w(turns, mul3_w(albedo, share), rest), sel3_w(turns, share, rest));
    }
    w->t = sel_w(turns, m.t, w->t);
    w->scatters = w->scatters | turns;
    m.goes = m.goes & ~turns;
  }
}

/// Below this share a ray goes on with a chance of 1/2, and counts twice.
#define FAINT_SHARE R(0x1p-6)

FN real3w heterogeneous_transmittance_w(const Scene* scene, GLOBAL const int* row, const SampleState_w* sample,
                                        maskw which, Flight_w* w) {
  GLOBAL const int* cells = scene->index + row[MEDIUM_MAJORANTS];
  GLOBAL const int* volume = scene->index + row[MEDIUM_VOLUMES] + VOLUME_SIGMA_T * VOLUME_INTS;
  real3w share = splat3_w(vec3(R(1.0), R(1.0), R(1.0))), ones = share;
  realw zero = splat_w(R(0.0));
  March_w m = march_begin_w(scene, cells, w, which);
  if (!any_w(m.goes)) return share;
  Random4_w first = stream_numbers_w(sample, m.goes, &w->draws);
  realw left = optical_depth_w(first.y, first.z);
  while (any_w(m.goes)) {
    realw most;
    maskw here = march_w(scene, cells, &m, &left, &most);
    if (!any_w(here)) break;
    Random4_w numbers = stream_numbers_w(sample, here, &w->draws);
    real3w place = fma3_w(m.t, w->d, w->from);
    real3w kept = mul3_w(share, sub3_w(ones, density_share_w(scene, volume, place, most)));
    maskw is_faint = lt_w(max3_w(kept), splat_w(FAINT_SHARE));
    realw weight = sel_w(lt_int_w(int_of_uint_w(numbers.w), splat_int_w(0)), splat_w(R(2.0)), zero);
    kept = sel3_w(is_faint, scale3_w(weight, kept), kept);
    share = sel3_w(here, kept, share);
    left = sel_w(here, optical_depth_w(numbers.y, numbers.z), left);
    m.goes = m.goes & (~here | lt_w(zero, max3_w(share)));
  }
  return share;
}

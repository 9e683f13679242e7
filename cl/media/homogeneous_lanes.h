// SPDX-License-Identifier: MIT
// A medium that is alike everywhere. Its transmittance is computed, and so is what it emits; only where a path scatters
// is drawn. One width; no guard.

FN real3w homogeneous_depths_w(GLOBAL const real* reals, realw length) {
  GLOBAL const real* sigma = reals + MEDIUM_SIGMA_T;
  return vec3_w(splat_w(sigma[0]) * length, splat_w(sigma[1]) * length, splat_w(sigma[2]) * length);
}

FN real3w exp_minus3_w(real3w a) { return vec3_w(exp_minus_w(a.x), exp_minus_w(a.y), exp_minus_w(a.z)); }

/// sigma_t of the paths' heroes.
FN realw homogeneous_hero_w(const Scene* scene, GLOBAL const int* row, const SampleState_w* sample) {
  real3w sigma = splat3_w(load3(scene->shading + row[MEDIUM_REALS] + MEDIUM_SIGMA_T));
  return row[MEDIUM_IS_GREY] ? sigma.x : of_hero_w(scene, sample, sigma);
}

/// 1: places where paths scatter are drawn; else transmittances are computed.
FN int homogeneous_scatters_w(GLOBAL const real* reals) {
  real3 albedo = load3(reals + MEDIUM_ALBEDO);
  return albedo.x + albedo.y + albedo.z != R(0.0);
}

FN int homogeneous_emits_w(GLOBAL const real* reals) {
  real3 emission = load3(reals + MEDIUM_EMISSION);
  return emission.x + emission.y + emission.z > R(0.0);
}

/// How far paths get. What a medium emits is that of the whole way.
FN realw homogeneous_reach_w(const Scene* scene, GLOBAL const int* row, const SampleState_w* sample, realw optical) {
  GLOBAL const real* reals = scene->shading + row[MEDIUM_REALS];
  return homogeneous_scatters_w(reals) && !homogeneous_emits_w(reals) ? optical / homogeneous_hero_w(scene, row, sample)
                                                                      : splat_w(REAL_MAX);
}

FN void homogeneous_travel_w(const Scene* scene, GLOBAL const int* row, const SampleState_w* sample, maskw which,
                             Flight_w* w) {
  GLOBAL const real* reals = scene->shading + row[MEDIUM_REALS];
  real3 albedo = load3(reals + MEDIUM_ALBEDO), emission = load3(reals + MEDIUM_EMISSION);
  real3w sigma = splat3_w(load3(reals + MEDIUM_SIGMA_T));
  if (homogeneous_emits_w(reals)) {
    // The whole way's emission, wherever the path scatters: as many rays reach a place unscattered as should.
    real3w depths = homogeneous_depths_w(reals, w->length);
    real3w glow = vec3_w(one_minus_exp_w(depths.x), one_minus_exp_w(depths.y), one_minus_exp_w(depths.z));
    glow = mul3_w(mul3_w(splat3_w(emission), glow), w->throughput);
    w->radiance = sel3_w(which, add3_w(w->radiance, glow), w->radiance);
  }
  if (!homogeneous_scatters_w(reals)) {
    // Nothing is scattered, so nothing is drawn.
    real3w passed = exp_minus3_w(homogeneous_depths_w(reals, w->length));
    w->throughput = sel3_w(which, mul3_w(passed, w->throughput), w->throughput);
    return;
  }
  realw chosen = homogeneous_hero_w(scene, row, sample);
  realw t = w->optical / chosen;
  maskw scatters = which & lt_w(t, w->length);
  if (row[MEDIUM_IS_GREY]) {
    w->throughput = sel3_w(scatters, mul3_w(splat3_w(albedo), w->throughput), w->throughput);
  } else {
    real3w passed = exp_minus3_w(homogeneous_depths_w(reals, sel_w(scatters, t, w->length)));
    real3w drawn = sel3_w(scatters, mul3_w(sigma, passed), passed);
    flight_event_w(w, which, sel3_w(scatters, mul3_w(splat3_w(albedo), drawn), passed), drawn);
  }
  w->t = sel_w(scatters, t, w->t);
  w->optical = sel_w(which, max_w(fma_w(-chosen, w->length, w->optical), splat_w(R(0.0))), w->optical);
  w->scatters = w->scatters | scatters;
}

FN real3w homogeneous_transmittance_w(const Scene* scene, GLOBAL const int* row, const SampleState_w* sample,
                                      maskw which, Flight_w* w) {
  (void)sample;
  (void)which;
  return exp_minus3_w(homogeneous_depths_w(scene->shading + row[MEDIUM_REALS], w->length));
}

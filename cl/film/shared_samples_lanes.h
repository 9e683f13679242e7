// SPDX-License-Identifier: MIT
// Samples of the pixels around one, weighted by the pixel filter, on their way into its sums
// (docs/decisions/0035-shared-samples.md). A lane is a sample of a pixel. Sample i of a pixel is made of the samples i
// of all pixels that the filter reaches: it is in the sub-sum of sample i, and does not depend on how samples are split
// into launches. One width; no guard.

/// The ring as pixels of a row see it, the first of which is at `row` and `column` there.
typedef struct {
  GLOBAL const real* reals;
  SampleRing ring;
  int row, column, reach, sides;
  GLOBAL const real* taps;
} Neighbourhood_w;

/// Samples of the film: colours, and their weight in units of 2^-WEIGHT_BITS.
typedef struct {
  real3w light, squares;  ///< Squares with HAS_MOMENT, of X, Y, Z; both in units of the weight.
  intw weight;
} SharedSamples_w;

FN realw tap_polynomial_w(GLOBAL const real* terms, realw offset) {
  realw p = splat_w(terms[0]);
  UNROLLED
  for (int k = 1; k < TAP_TERMS; ++k) p = fma_w(p, offset, splat_w(terms[k]));
  return p;
}

/// The nearest whole number, of one that is lifted by WEIGHT_LIFT and half a unit.
FN intw rounded_w(realw lifted) { return int_of_real_w(lifted) - splat_int_w((int)WEIGHT_LIFT); }

/// Along one axis, of samples `tap` pixels further on that lie at `offset` from the middle.
FN realw tap_weight_w(const Neighbourhood_w* n, int tap, realw offset) {
  GLOBAL const real* terms = n->taps + (n->reach + tap) * TAP_TERMS;
  realw weight = tap_polynomial_w(terms, offset);
  if (n->sides == 1) return weight;
  realw beyond = tap_polynomial_w(terms + (2 * n->reach + 1) * TAP_TERMS, offset);
  return sel_w(lt_w(offset, splat_w(R(0.0))), weight, beyond);
}

FN real3w squares_of_xyz_w(real3w light) {
  real3w xyz;
  xyz.x = dot3_w(splat3_w(vec3(XYZ_OF_RGB_X)), light);
  xyz.y = dot3_w(splat3_w(vec3(XYZ_OF_RGB_Y)), light);
  xyz.z = dot3_w(splat3_w(vec3(XYZ_OF_RGB_Z)), light);
  return mul3_w(xyz, xyz);
}

/// first: number of the first lane's sample among those of the row's pixels (ring_place).
FN SharedSamples_w shared_samples_w(const Neighbourhood_w* n, int first) {
  SharedSamples_w sum;
  sum.light = sum.squares = splat3_w(vec3(R(0.0), R(0.0), R(0.0)));
  sum.weight = splat_int_w(0);
  int plane = ring_plane(&n->ring), step = ring_pixel_step(&n->ring);
  for (int y = -n->reach; y <= n->reach; ++y) {
    GLOBAL const real* row = n->reals + ring_place(&n->ring, n->row + y, n->column) + first;
    for (int x = -n->reach; x <= n->reach; ++x) {
      GLOBAL const real* at = row + x * step;
      // Whole units: the sum of weights is exact, and of equal colours the mean is that colour.
      intw units =
          rounded_w(fma_w(tap_weight_w(n, x, load_w(at + RING_X * plane)),
                          tap_weight_w(n, y, load_w(at + RING_Y * plane)), splat_w((real)WEIGHT_LIFT + R(0.5))));
      realw weight = real_of_int_w(units);
      real3w light;
      light.x = load_w(at + RING_R * plane);
      light.y = load_w(at + RING_G * plane);
      light.z = load_w(at + RING_B * plane);
      sum.weight = sum.weight + units;
      sum.light = fma3_w(weight, light, sum.light);
      if (HAS_MOMENT) sum.squares = fma3_w(weight, squares_of_xyz_w(light), sum.squares);
    }
  }
  realw unit = splat_w(R(1.0) / (real)(1 << WEIGHT_BITS));
  sum.light = scale3_w(unit, sum.light);
  if (HAS_MOMENT) sum.squares = scale3_w(unit, sum.squares);
  return sum;
}

/// The film's side of a span of pixels.
typedef struct {
  GLOBAL long* words;  ///< Of the first pixel.
  GLOBAL uint* done;  ///< With HAS_LOOP_LIMIT: the first sample that is not in the film yet. A span is one pixel there.
  int first;          ///< The sample to begin with.
  SubSums sums;
  int pixel_words;
} SharingFilm_w;

/// Adds sample `sample` to its pixel, whose words these are. squares, weight: as SharedSamples_w has them.
FN void add_shared_sample(const Scene* scene, real3 light, real3 squares, int weight, SubSums sums, GLOBAL long* words,
                          int sample) {
  const int row = FILM_CHANNELS * FILM_SUM_WORDS;
  int sub = sub_sum_of(sums, sample);
  if (light.x != R(0.0) || light.y != R(0.0) || light.z != R(0.0)) film_add_color(scene, words + sub * row, light);
  if (HAS_MOMENT) add_squared(scene, words + sums.count * row, squares, 1);
  add_weight(words + (sums.count + HAS_MOMENT) * row, sums, sub, weight);
}

#if LANES != 1
/// Samples as they wait, with what else is added of them; squares: SharedSamples_w.squares in the place of light.
typedef struct {
  WaitingSamples_w samples, squares;
  intw weight[POOL_PATHS / LANES];
} WaitingShared_w;

/// The weights of a run's groups into its pixel's.
FN void add_weights_of_run_w(const PixelRun* run, PRIVATE const intw* weights, SubSums sums, GLOBAL long* words) {
  for (int k = 0; k < sums.count; ++k) {
    intw sum = splat_int_w(0);
    for (int g = first_group_w(run); g < end_group_w(run); ++g)
      sum = sum + sel_int_w(is_in_sub_sum_w(sub_sums_w(sums, run, g), k), weights[g], splat_int_w(0));
    add_weight(words, sums, k, sum_int_w(sum));
  }
}

FN void add_shared_run_w(const Scene* scene, const WaitingShared_w* waiting, const PixelRun* run, SubSums sums,
                         GLOBAL long* words) {
  if (!HAS_MOMENT && run->count >= LEAST_RUN_w) {
    add_run_w(scene, &waiting->samples, run, sums, words);
    add_weights_of_run_w(run, waiting->weight, sums, words + sums.count * FILM_CHANNELS * FILM_SUM_WORDS);
    return;
  }
  for (int i = 0; i < run->count; ++i) {
    int place = run->place + i;
    add_shared_sample(scene, light_of_sample_w(&waiting->samples, place), light_of_sample_w(&waiting->squares, place),
                      get_int_w(waiting->weight + place / LANES, place % LANES), sums, words, run->sample + i);
  }
}

/// The samples of `columns` pixels into the film, as many at a time as a pool has.
ONCE_FN void share_span_w(const Scene* scene, const Neighbourhood_w* n, const SharingFilm_w* film, int columns) {
  int begin = n->ring.sample_first, end = begin + n->ring.samples, sample = begin;
  GLOBAL long* words = film->words;
  WaitingShared_w waiting;
  for (int first = 0; first < columns * n->ring.samples; first += waiting.samples.count) {
    waiting.samples.count = min((int)POOL_PATHS, columns * n->ring.samples - first);
    for (int g = 0; g < groups_of_samples_w(&waiting.samples); ++g) {
      SharedSamples_w shared = shared_samples_w(n, first + g * LANES);
      put_channels_w(shared.light, g, &waiting.samples);
      put_channels_w(shared.squares, g, &waiting.squares);
      waiting.weight[g] = shared.weight;
    }
    for (int place = 0; place < waiting.samples.count;) {
      PixelRun run = run_from_w(&waiting.samples, place, sample, end);
      add_shared_run_w(scene, &waiting, &run, film->sums, words);
      place += run.count;
      sample += run.count;
      if (sample < end) continue;
      sample = begin;
      words += film->pixel_words;
    }
  }
}
#else
ONCE_FN void share_span_w(const Scene* scene, const Neighbourhood_w* n, const SharingFilm_w* film, int columns) {
  (void)columns;
  int begin = n->ring.sample_first;
  for (int sample = film->first; sample < begin + n->ring.samples; ++sample) {
    SharedSamples_w shared = shared_samples_w(n, (sample - begin) * ring_sample_step(&n->ring));
    if (HAS_LOOP_LIMIT && !loops_were_whole()) break;
    add_shared_sample(scene, shared.light, shared.squares, shared.weight, film->sums, film->words, sample);
    if (HAS_LOOP_LIMIT) *film->done = (uint)(sample + 1);
  }
}
#endif

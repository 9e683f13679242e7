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

/// A lane's sample into its pixel. sample: its number.
FN void add_shared_sample_w(const Scene* scene, const SharedSamples_w* shared, int lane, const SharingFilm_w* film,
                            int column, int sample) {
  const int row = FILM_CHANNELS * FILM_SUM_WORDS;
  GLOBAL long* words = film->words + (ulong)column * (ulong)film->pixel_words;
  int sub = sub_sum_of(film->sums, sample);
  real3 light = vec3(get_w(&shared->light.x, lane), get_w(&shared->light.y, lane), get_w(&shared->light.z, lane));
  if (light.x != R(0.0) || light.y != R(0.0) || light.z != R(0.0)) film_add_color(scene, words + sub * row, light);
  if (HAS_MOMENT)
    add_squared(scene, words + film->sums.count * row,
                vec3(get_w(&shared->squares.x, lane), get_w(&shared->squares.y, lane), get_w(&shared->squares.z, lane)),
                1);
  add_weight(words + (film->sums.count + HAS_MOMENT) * row, film->sums, sub, get_int_w(&shared->weight, lane));
}

#if LANES != 1
/// Samples of one pixel; weights: of their groups.
FN void add_shared_pixel_w(const Scene* scene, const PixelSamples_w* samples, PRIVATE const intw* weights,
                           const SharingFilm_w* film, int column) {
  const int row = FILM_CHANNELS * FILM_SUM_WORDS;
  GLOBAL long* words = film->words + (ulong)column * (ulong)film->pixel_words;
  add_samples_w(scene, samples, film->sums, words);
  for (int k = 0; k < film->sums.count; ++k) {
    intw sum = splat_int_w(0);
    for (int g = 0; g < groups_of_samples_w(samples); ++g) {
      maskw is_here = is_in_sub_sum_w(sub_sums_w(film->sums, samples, g), k);
      sum = sum + sel_int_w(is_here, weights[g], splat_int_w(0));
    }
    add_weight(words + (film->sums.count + HAS_MOMENT) * row, film->sums, k, sum_int_w(sum));
  }
}

/// The samples of `columns` pixels into the film, as many at a time as a pool has.
ONCE_FN void share_span_w(const Scene* scene, const Neighbourhood_w* n, const SharingFilm_w* film, int columns) {
  int samples = n->ring.samples, column = 0, next = 0;
  for (int first = 0, count; first < columns * samples; first += count) {
    count = min((int)POOL_PATHS, columns * samples - first);
    PixelSamples_w pixel;
    intw weights[POOL_PATHS / LANES];
    pixel.first = n->ring.sample_first + next;
    pixel.count = count;
    int is_pixel = !HAS_MOMENT && count >= LANES && count <= samples - next;
    for (int g = 0; g < groups_of_samples_w(&pixel); ++g) {
      SharedSamples_w shared = shared_samples_w(n, first + g * LANES);
      pixel.light[0][g] = shared.light.x;
      pixel.light[1][g] = shared.light.y;
      pixel.light[2][g] = shared.light.z;
      weights[g] = shared.weight;
      for (int lane = 0; !is_pixel && lane < min((int)LANES, count - g * LANES); ++lane) {
        add_shared_sample_w(scene, &shared, lane, film, column, n->ring.sample_first + next);
        if (++next < samples) continue;
        next = 0;
        ++column;
      }
    }
    if (!is_pixel) continue;
    add_shared_pixel_w(scene, &pixel, weights, film, column);
    next += count;
    if (next < samples) continue;
    next = 0;
    ++column;
  }
}
#else
ONCE_FN void share_span_w(const Scene* scene, const Neighbourhood_w* n, const SharingFilm_w* film, int columns) {
  (void)columns;
  int begin = n->ring.sample_first;
  for (int sample = film->first; sample < begin + n->ring.samples; ++sample) {
    SharedSamples_w shared = shared_samples_w(n, (sample - begin) * ring_sample_step(&n->ring));
    if (HAS_LOOP_LIMIT && !loops_were_whole()) break;
    add_shared_sample_w(scene, &shared, 0, film, 0, sample);
    if (HAS_LOOP_LIMIT) *film->done = (uint)(sample + 1);
  }
}
#endif

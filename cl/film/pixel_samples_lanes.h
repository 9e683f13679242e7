// SPDX-License-Identifier: MIT
// Samples of one pixel on their way into the film, LANES at a time: each is cut at the borders of the film's bins, and
// the pieces of a sub-sum are added up before the film is touched. The film's words are those that add_sample leaves
// (film/span_film.h). More than one lane. One width; no guard.

/// The two bins of a sum as digits of FILM_DIGIT_BITS_w bits, so that the digits of a pool's samples can be added in an
/// int.
enum { FILM_DIGIT_BITS_w = 20, FILM_DIGITS_w = 2 * FILM_BIN_BITS / FILM_DIGIT_BITS_w };

/// Samples [first, first + count) of a pixel, a plane a channel: lane l of group g is sample first + g LANES + l.
typedef struct {
  int first, count;
  realw light[FILM_CHANNELS][POOL_PATHS / LANES];
} PixelSamples_w;

FN int groups_of_samples_w(const PixelSamples_w* samples) { return (samples->count + LANES - 1) / LANES; }

FN real3 light_of_sample_w(const PixelSamples_w* samples, int i) {
  int g = i / LANES, lane = i % LANES;
  return vec3(get_w(&samples->light[0][g], lane), get_w(&samples->light[1][g], lane),
              get_w(&samples->light[2][g], lane));
}

/// sub_sum_of for the lanes of group g.
FN intw sub_sums_w(SubSums sums, const PixelSamples_w* samples, int g) {
  int sequence_bits = (int)lanes_among((uint)sums.sequences - 1u), is_in_turns = sums.count > sums.sequences;
  intw sample = splat_int_w(samples->first + g * LANES) + int_of_uint_w(lane_numbers_w());
  intw turn = (sample >> (sequence_bits + sums.turn_bits)) & splat_int_w(is_in_turns);
  return (sample & splat_int_w(sums.sequences - 1)) + turn * splat_int_w(sums.sequences);
}

/// Adds the digits of x, which is in [0, 2^20), to those of other samples: the bins of FILM_USUAL_TOP meet at 2^-20.
/// Every difference and product is exact; what a device flushes to zero is below the last digit.
FN void add_digits_w(realw x, PRIVATE intw* digits) {
  UNROLLED
  for (int i = 0; i < FILM_DIGITS_w; ++i) {
    intw digit = int_of_real_w(x);
    digits[i] = digits[i] + digit;
    x = (x - real_of_int_w(digit)) * splat_w(R(0x1p+20));
  }
}

FN FilmBins bins_of_digits_w(PRIVATE const intw* digits) {
  FilmBins bins;
  bins.top = FILM_USUAL_TOP;
  bins.high = (long)sum_int_w(digits[0]) * (1 << FILM_DIGIT_BITS_w) + sum_int_w(digits[1]);
  bins.low = (long)sum_int_w(digits[2]) * (1 << FILM_DIGIT_BITS_w) + sum_int_w(digits[3]);
  return bins;
}

/// Lanes whose number is in [0, 2^20).
FN maskw is_usual_w(realw x) { return finite_w(x) & le_w(splat_w(R(0.0)), x) & lt_w(x, splat_w(R(0x1p+20))); }

/// One channel of the samples that are in the same sub-sum, one by one.
SELDOM_FN void add_channel_slowly_w(const Scene* scene, PRIVATE const realw* light, PRIVATE const maskw* which,
                                    int groups, GLOBAL long* sum) {
  for (int g = 0; g < groups; ++g)
    for (uint lanes = bits_w(which[g]); lanes != 0u; lanes &= lanes - 1u)
      film_add_sample(scene, sum, get_w(light + g, first_bit(lanes)));
}

/// The same at once, where all are usual, and where one reaches the upper bin or the sum has done so: else the sum's
/// top is a lower one.
FN void add_channel_w(const Scene* scene, PRIVATE const realw* light, PRIVATE const maskw* which, int groups,
                      GLOBAL long* sum) {
  intw digits[FILM_DIGITS_w];
  for (int i = 0; i < FILM_DIGITS_w; ++i) digits[i] = splat_int_w(0);
  maskw is_usual = ~none_w(), is_lit = none_w();
  realw zero = splat_w(R(0.0));
  for (int g = 0; g < groups; ++g) {
    maskw is_usual_here = which[g] & is_usual_w(light[g]);
    is_usual = is_usual & (is_usual_here | ~which[g]);
    is_lit = is_lit | (is_usual_here & lt_w(zero, light[g]));
    add_digits_w(sel_w(is_usual_here, light[g], zero), digits);
  }
  int are_usual = !any_w(~is_usual);
  if (are_usual && !any_w(is_lit)) return;
  FilmBins bins = bins_of_digits_w(digits);
  if (are_usual && (bins.high != 0 || film_bins(sum[0], sum[1]).top >= FILM_USUAL_TOP))
    film_add(sum, bins);
  else
    add_channel_slowly_w(scene, light, which, groups, sum);
}

/// Adds samples of a pixel whose sums begin at `sum`. Without moments, whose squares are summed, too.
FN void add_samples_w(const Scene* scene, const PixelSamples_w* samples, SubSums sums, GLOBAL long* sum) {
  int groups = groups_of_samples_w(samples);
  intw subs[POOL_PATHS / LANES];
  for (int g = 0; g < groups; ++g) subs[g] = sub_sums_w(sums, samples, g);
  for (int k = 0; k < sums.count; ++k) {
    maskw which[POOL_PATHS / LANES];
    for (int g = 0; g < groups; ++g)
      which[g] = first_lanes_w(samples->count - g * LANES) & ~nonzero_w(subs[g] - splat_int_w(k));
    for (int c = 0; c < FILM_CHANNELS; ++c, sum += FILM_SUM_WORDS)
      add_channel_w(scene, samples->light[c], which, groups, sum);
  }
}

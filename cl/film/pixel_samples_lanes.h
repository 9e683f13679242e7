// SPDX-License-Identifier: MIT
// Samples of one pixel on their way into the film, LANES at a time: each is cut at the borders of the film's bins, and
// the pieces of a sub-sum are added up before the film is touched. The film's words are those that add_sample leaves
// (film/span_film.h). More than one lane. One width; no guard.

/// The two bins of a sum as digits of FILM_DIGIT_BITS_w bits, so that the digits of a pool's samples can be added in an
/// int.
enum { FILM_DIGIT_BITS_w = 20, FILM_DIGITS_w = 2 * FILM_BIN_BITS / FILM_DIGIT_BITS_w };

/// Samples [first, first + count) of a pixel: lane l of group g is sample first + g LANES + l. Lanes beyond are black.
typedef struct {
  int first, count;
  real3w light[POOL_PATHS / LANES];
} PixelSamples_w;

FN int groups_of_samples_w(const PixelSamples_w* samples) { return (samples->count + LANES - 1) / LANES; }

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

/// Lanes whose three values are in [0, 2^20).
FN maskw is_usual_w(real3w v) {
  realw least = min_w(v.x, min_w(v.y, v.z)), most = max_w(v.x, max_w(v.y, v.z));
  maskw is_number = finite_w(v.x) & finite_w(v.y) & finite_w(v.z);
  return is_number & le_w(splat_w(R(0.0)), least) & lt_w(most, splat_w(R(0x1p+20)));
}

/// The samples of sub-sum k one by one.
SELDOM_FN void add_samples_slowly_w(const Scene* scene, const PixelSamples_w* samples, SubSums sums, int k,
                                    GLOBAL long* pixel_sums) {
  for (int i = 0; i < samples->count; ++i) {
    if (sub_sum_of(sums, samples->first + i) != k) continue;
    real3 light = get3_w(&samples->light[i / LANES], i % LANES);
    add_sample(scene, pixel_sums, sums, samples->first + i, light);
  }
}

/// Adds the samples of sub-sum k. Slowly, unless all are usual, and at least one reaches the upper bin where the sum
/// does not yet: else the sum's top is a lower one.
FN void add_sub_sum_w(const Scene* scene, const PixelSamples_w* samples, SubSums sums, int k, GLOBAL long* pixel_sums) {
  intw digits[(int)FILM_CHANNELS * (int)FILM_DIGITS_w];
  for (int i = 0; i < (int)FILM_CHANNELS * (int)FILM_DIGITS_w; ++i) digits[i] = splat_int_w(0);
  maskw is_unusual = none_w(), is_black = ~none_w();
  realw zero = splat_w(R(0.0));
  for (int g = 0; g < groups_of_samples_w(samples); ++g) {
    real3w light = samples->light[g];
    maskw is_here = ~nonzero_w(sub_sums_w(sums, samples, g) - splat_int_w(k)), is_usual = is_usual_w(light);
    is_unusual = is_unusual | (is_here & ~is_usual);
    is_black = is_black & (~is_here | (is_usual & eq_w(light.x, zero) & eq_w(light.y, zero) & eq_w(light.z, zero)));
    add_digits_w(sel_w(is_here & is_usual, light.x, zero), digits);
    add_digits_w(sel_w(is_here & is_usual, light.y, zero), digits + FILM_DIGITS_w);
    add_digits_w(sel_w(is_here & is_usual, light.z, zero), digits + 2 * FILM_DIGITS_w);
  }
  if (!any_w(~is_black)) return;
  int is_slow = any_w(is_unusual);
  FilmBins bins[FILM_CHANNELS];
  GLOBAL long* sum = pixel_sums + k * (FILM_CHANNELS * FILM_SUM_WORDS);
  for (int c = 0; c < FILM_CHANNELS; ++c) {
    bins[c] = bins_of_digits_w(digits + c * FILM_DIGITS_w);
    GLOBAL long* words = sum + c * FILM_SUM_WORDS;
    if (bins[c].high == 0 && film_bins(words[0], words[1]).top < FILM_USUAL_TOP) is_slow = 1;
  }
  if (is_slow) {
    add_samples_slowly_w(scene, samples, sums, k, pixel_sums);
    return;
  }
  for (int c = 0; c < FILM_CHANNELS; ++c) film_add(sum + c * FILM_SUM_WORDS, bins[c]);
}

/// Adds samples of a pixel whose sums begin at pixel_sums. Without moments, whose squares are summed, too.
FN void add_samples_w(const Scene* scene, const PixelSamples_w* samples, SubSums sums, GLOBAL long* pixel_sums) {
  for (int k = 0; k < sums.count; ++k) add_sub_sum_w(scene, samples, sums, k, pixel_sums);
}

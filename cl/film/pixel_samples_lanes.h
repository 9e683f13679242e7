// SPDX-License-Identifier: MIT
// Samples on their way into the film, LANES at a time: each is cut at the borders of the film's bins, and the pieces of
// a pixel's sub-sum are added up before the film is touched. The film's words are those that add_sample leaves
// (film/span_film.h). More than one lane. One width; no guard.

/// The two bins of a sum as digits of FILM_DIGIT_BITS_w bits, so that the digits of a pool's samples can be added in an
/// int.
enum { FILM_DIGIT_BITS_w = 20, FILM_DIGITS_w = 2 * FILM_BIN_BITS / FILM_DIGIT_BITS_w };

/// Samples of pixels that follow each other, pixel by pixel, in `count` places, a plane a channel: place g LANES + l is
/// lane l of group g.
typedef struct {
  int count;
  realw light[FILM_CHANNELS][POOL_PATHS / LANES];
} WaitingSamples_w;

/// Those of one pixel: samples [sample, sample + count), in the places from `place` on.
typedef struct {
  int sample, place, count;
} PixelRun;

/// Samples of a pixel from which on it takes less time to add them up before the film is touched.
enum { LEAST_RUN_w = LANES / 2 };

FN int groups_of_samples_w(const WaitingSamples_w* samples) { return (samples->count + LANES - 1) / LANES; }

/// Of group g.
FN void put_channels_w(real3w value, int g, WaitingSamples_w* to) {
  to->light[0][g] = value.x;
  to->light[1][g] = value.y;
  to->light[2][g] = value.z;
}

FN real3 light_of_sample_w(const WaitingSamples_w* samples, int place) {
  int g = place / LANES, lane = place % LANES;
  return vec3(get_w(&samples->light[0][g], lane), get_w(&samples->light[1][g], lane),
              get_w(&samples->light[2][g], lane));
}

/// The run from a place on, where a pixel's samples from `sample` on begin, all of which are before `end`.
FN PixelRun run_from_w(const WaitingSamples_w* samples, int place, int sample, int end) {
  PixelRun run;
  run.sample = sample;
  run.place = place;
  run.count = min(samples->count - place, end - sample);
  return run;
}

/// The groups that a run has places in: from first_group_w on, and before end_group_w.
FN int first_group_w(const PixelRun* run) { return run->place / LANES; }
FN int end_group_w(const PixelRun* run) { return (run->place + run->count + LANES - 1) / LANES; }

/// sub_sum_of for the lanes of group g; -1: no sample of the run.
FN intw sub_sums_w(SubSums sums, const PixelRun* run, int g) {
  int is_in_turns = sums.count > sums.sequences, begin = run->place - g * LANES;
  intw sample = splat_int_w(run->sample - begin) + int_of_uint_w(lane_numbers_w());
  intw turn = (sample >> (sequence_bits(sums) + sums.turn_bits)) & splat_int_w(is_in_turns);
  intw sub = (sample & splat_int_w(sums.sequences - 1)) + turn * splat_int_w(sums.sequences);
  return sel_int_w(first_lanes_w(begin + run->count) & ~first_lanes_w(begin), sub, splat_int_w(-1));
}

/// Digits of x, which is in [0, 2^20): the bins of FILM_USUAL_TOP meet at 2^-20. Every difference and product is exact;
/// what a device flushes to zero is below the last digit.
FN void cut_into_digits_w(realw x, PRIVATE intw* digits) {
  UNROLLED
  for (int i = 0; i < FILM_DIGITS_w; ++i) {
    digits[i] = int_of_real_w(x);
    x = (x - real_of_int_w(digits[i])) * splat_w(R(0x1p+20));
  }
}

/// What samples add to one sub-sum of a channel: digits, lane by lane, and whether all of them are usual and any lit.
typedef struct {
  intw digits[FILM_DIGITS_w];
  uint unusual, lit;
} ChannelDigits_w;

FN FilmBins bins_of_digits_w(PRIVATE const intw* digits) {
  FilmBins bins;
  bins.top = FILM_USUAL_TOP;
  bins.high = (long)sum_int_w(digits[0]) * (1 << FILM_DIGIT_BITS_w) + sum_int_w(digits[1]);
  bins.low = (long)sum_int_w(digits[2]) * (1 << FILM_DIGIT_BITS_w) + sum_int_w(digits[3]);
  return bins;
}

/// Lanes whose number is in [0, 2^20).
FN maskw is_usual_w(realw x) { return finite_w(x) & le_w(splat_w(R(0.0)), x) & lt_w(x, splat_w(R(0x1p+20))); }

FN maskw is_in_sub_sum_w(intw sub, int k) { return ~nonzero_w(sub - splat_int_w(k)); }

/// Adds the digits of a channel of one group to the sub-sums that its lanes are in.
FN void add_group_w(realw light, intw sub, int count, PRIVATE ChannelDigits_w* sums) {
  realw zero = splat_w(R(0.0));
  maskw is_usual = is_usual_w(light), is_lit = is_usual & lt_w(zero, light);
  intw digits[FILM_DIGITS_w];
  cut_into_digits_w(sel_w(is_usual, light, zero), digits);
  uint usual = bits_w(is_usual), lit = bits_w(is_lit);
  for (int k = 0; k < count; ++k) {
    maskw is_here = is_in_sub_sum_w(sub, k);
    uint here = bits_w(is_here);
    if (here == 0u) continue;
    PRIVATE ChannelDigits_w* sum = sums + k;
    sum->unusual |= here & ~usual;
    sum->lit |= here & lit;
    UNROLLED
    for (int i = 0; i < FILM_DIGITS_w; ++i)
      sum->digits[i] = sum->digits[i] + sel_int_w(is_here, digits[i], splat_int_w(0));
  }
}

/// Samples that are in the same sub-sum, one by one. subs: of the run's groups.
SELDOM_FN void add_channel_slowly_w(const Scene* scene, PRIVATE const realw* light, PRIVATE const intw* subs, int k,
                                    int groups, GLOBAL long* sum) {
  for (int g = 0; g < groups; ++g)
    for (uint lanes = bits_w(is_in_sub_sum_w(subs[g], k)); lanes != 0u; lanes &= lanes - 1u)
      film_add_sample(scene, sum, get_w(light + g, first_bit(lanes)));
}

/// Adds a run to its pixel, whose sums begin at `sum`, samples of a sub-sum at once where all are usual, and where one
/// reaches the upper bin or the sum has done so: else the sum's top is a lower one. Without moments, whose squares are
/// summed, too.
FN void add_run_w(const Scene* scene, const WaitingSamples_w* samples, const PixelRun* run, SubSums sums,
                  GLOBAL long* sum) {
  int first = first_group_w(run), groups = end_group_w(run) - first;
  intw subs[POOL_PATHS / LANES];
  for (int g = 0; g < groups; ++g) subs[g] = sub_sums_w(sums, run, first + g);
  for (int c = 0; c < FILM_CHANNELS; ++c, sum += FILM_SUM_WORDS) {
    PRIVATE const realw* light = samples->light[c] + first;
    ChannelDigits_w added[FILM_SUBSUMS];
    for (int k = 0; k < sums.count; ++k) {
      added[k].unusual = added[k].lit = 0u;
      for (int i = 0; i < FILM_DIGITS_w; ++i) added[k].digits[i] = splat_int_w(0);
    }
    for (int g = 0; g < groups; ++g) add_group_w(light[g], subs[g], sums.count, added);
    for (int k = 0; k < sums.count; ++k) {
      if ((added[k].unusual | added[k].lit) == 0u) continue;
      GLOBAL long* words = sum + k * (FILM_CHANNELS * FILM_SUM_WORDS);
      FilmBins bins = bins_of_digits_w(added[k].digits);
      if (added[k].unusual == 0u && (bins.high != 0 || film_bins(words[0], words[1]).top >= FILM_USUAL_TOP))
        film_add(words, bins);
      else
        add_channel_slowly_w(scene, light, subs, k, groups, words);
    }
  }
}

// SPDX-License-Identifier: MIT
// A pool of paths of one span, between the groups of LANES that are followed at a time. After every surface the paths
// that go on are taken in new groups, so that few lanes are idle, and paths that go the same way stand together
// (docs/decisions/0026-path-pool.md). A path is a function of its pixel and its number, so the groups do not show in
// the picture. More than one lane. One width; no guard.
#include "lanes/lane_transpose.h"

/// A sector is one of the eight combinations of signs of a direction.
enum { SECTORS_w = 8 };

/// What is kept of a path. The rest of its ray is prepared again. Each real is kept only where programs use it.
enum {
  KEPT_RAY_w = 0,  // o, d, t_max
  KEPT_RADIANCE_w = 7,
  KEPT_THROUGHPUT_w = 10,
  KEPT_FROM_w = 13,
  KEPT_DENSITY_w = 16,
  KEPT_ETA2_w = 17,
  KEPT_TRAVELLED_w = KEPT_ETA2_w + (HAS_TRANSMISSION != 0),
  KEPT_IOR_w = KEPT_TRAVELLED_w + (TEXTURE_COUNT > 0),
  KEPT_MEDIA_w = KEPT_IOR_w + (HAS_PRIORITY ? INTERFACES_MOST_w : 0),  // entered, hero_shares, optical
  KEPT_REALS_w = KEPT_MEDIA_w + (HAS_MEDIA ? 7 : 0)
};
enum {
  KEPT_DEPARTED_w = 0,
  KEPT_DEPTH_w,
  KEPT_OUTWARD_w,
  KEPT_PIXEL_w,
  KEPT_SAMPLE_w,
  KEPT_REVERSED_w,
  KEPT_KEY_w,
  KEPT_INSTANCE_w,
  KEPT_RANKS_w = KEPT_INSTANCE_w + (HAS_INSTANCES != 0),
  KEPT_MEDIUM_w = KEPT_RANKS_w + (HAS_PRIORITY ? 2 * INTERFACES_MOST_w + 1 : 0),  // medium, draws
  KEPT_RANKED_w = KEPT_MEDIUM_w + (HAS_MEDIA ? 2 : 0),                            // around, medium
  KEPT_INTS_w = KEPT_RANKED_w + (HAS_MEDIA && HAS_PRIORITY ? 1 + INTERFACES_MOST_w : 0)
};

/// A path is kept as so many vectors: its reals, then its ints as bits of reals.
enum { KEPT_VECTORS_w = (KEPT_REALS_w + KEPT_INTS_w + LANES - 1) / LANES };

/// What is kept of LANES paths, a plane each.
typedef struct {
  realw reals[KEPT_REALS_w];
  intw ints[KEPT_INTS_w];
} KeptPaths_w;

typedef struct {
  int count;                                      ///< Paths that go on. Those that ended keep their places.
  int order[POOL_PATHS + LANES];                  ///< Their places, in the order in which they are taken.
  int places[SECTORS_w][POOL_PATHS];              ///< Places of the paths that are put back, by sector,
  int counts[SECTORS_w];                          ///< and their number.
  realw kept[(POOL_PATHS + 1) * KEPT_VECTORS_w];  ///< The last place takes what is not kept.
} PathPool_w;

FN void keep3_w(PRIVATE realw* to, real3w v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

FN void kept_of_paths_w(const Paths_w* path, KeptPaths_w* kept) {
  for (int k = 0; k < 6; ++k) kept->reals[KEPT_RAY_w + k] = path->rays.planes[RAY_PLANE_O + k];
  kept->reals[KEPT_RAY_w + 6] = path->rays.planes[RAY_PLANE_T_MAX];
  keep3_w(kept->reals + KEPT_RADIANCE_w, path->radiance);
  keep3_w(kept->reals + KEPT_THROUGHPUT_w, path->throughput);
  keep3_w(kept->reals + KEPT_FROM_w, path->from);
  kept->reals[KEPT_DENSITY_w] = path->density;
  if (HAS_TRANSMISSION) kept->reals[KEPT_ETA2_w] = path->eta2;
  if (TEXTURE_COUNT > 0) kept->reals[KEPT_TRAVELLED_w] = path->travelled;
  kept->ints[KEPT_DEPARTED_w] = path->rays.departed;
  kept->ints[KEPT_DEPTH_w] = path->depth;
  kept->ints[KEPT_OUTWARD_w] = path->rays.is_outward;
  kept->ints[KEPT_PIXEL_w] = int_of_uint_w(path->sample.pixel);
  kept->ints[KEPT_SAMPLE_w] = int_of_uint_w(path->sample.sample);
  kept->ints[KEPT_REVERSED_w] = int_of_uint_w(path->sample.reversed);
  kept->ints[KEPT_KEY_w] = int_of_uint_w(path->sample.key);
  if (HAS_INSTANCES) kept->ints[KEPT_INSTANCE_w] = path->rays.departed_instance;
  if (HAS_PRIORITY) {
    for (int k = 0; k < INTERFACES_MOST_w; ++k) {
      kept->reals[KEPT_IOR_w + k] = path->within.ior[k];
      kept->ints[KEPT_RANKS_w + 2 * k] = path->within.rank[k];
      kept->ints[KEPT_RANKS_w + 2 * k + 1] = path->within.instance[k];
    }
    kept->ints[KEPT_RANKS_w + 2 * INTERFACES_MOST_w] = path->within.ignored;
  }
#if HAS_MEDIA
  keep3_w(kept->reals + KEPT_MEDIA_w, path->entered);
  keep3_w(kept->reals + KEPT_MEDIA_w + 3, path->hero_shares);
  kept->reals[KEPT_MEDIA_w + 6] = path->optical;
  kept->ints[KEPT_MEDIUM_w] = path->medium;
  kept->ints[KEPT_MEDIUM_w + 1] = int_of_uint_w(path->draws);
  if (HAS_PRIORITY) {
    kept->ints[KEPT_RANKED_w] = path->within.around;
    for (int k = 0; k < INTERFACES_MOST_w; ++k) kept->ints[KEPT_RANKED_w + 1 + k] = path->within.medium[k];
  }
#endif
}

/// path: its sample's seed and sequences are those of the pool.
FN void paths_of_kept_w(const KeptPaths_w* kept, maskw alive, Paths_w* path) {
  PRIVATE const realw* reals = kept->reals;
  path->alive = alive;
  rays_make_w(real3_at_w(reals + KEPT_RAY_w), real3_at_w(reals + KEPT_RAY_w + 3), splat_w(R(0.0)),
              reals[KEPT_RAY_w + 6], alive, &path->rays);
  path->rays.departed = kept->ints[KEPT_DEPARTED_w];
  path->rays.departed_instance = HAS_INSTANCES ? kept->ints[KEPT_INSTANCE_w] : splat_int_w(-1);
  path->rays.aim = splat_int_w(-1);
  path->rays.is_outward = kept->ints[KEPT_OUTWARD_w];
  path->radiance = real3_at_w(reals + KEPT_RADIANCE_w);
  path->throughput = real3_at_w(reals + KEPT_THROUGHPUT_w);
  path->from = real3_at_w(reals + KEPT_FROM_w);
  path->density = reals[KEPT_DENSITY_w];
  path->eta2 = HAS_TRANSMISSION ? reals[KEPT_ETA2_w] : splat_w(R(1.0));
  path->travelled = TEXTURE_COUNT > 0 ? reals[KEPT_TRAVELLED_w] : splat_w(R(0.0));
  path->depth = kept->ints[KEPT_DEPTH_w];
  path->sample.pixel = uint_of_int_w(kept->ints[KEPT_PIXEL_w]);
  path->sample.sample = uint_of_int_w(kept->ints[KEPT_SAMPLE_w]);
  path->sample.reversed = uint_of_int_w(kept->ints[KEPT_REVERSED_w]);
  path->sample.key = uint_of_int_w(kept->ints[KEPT_KEY_w]);
  if (HAS_PRIORITY) {
    for (int k = 0; k < INTERFACES_MOST_w; ++k) {
      path->within.ior[k] = reals[KEPT_IOR_w + k];
      path->within.rank[k] = kept->ints[KEPT_RANKS_w + 2 * k];
      path->within.instance[k] = kept->ints[KEPT_RANKS_w + 2 * k + 1];
    }
    path->within.ignored = kept->ints[KEPT_RANKS_w + 2 * INTERFACES_MOST_w];
  }
#if HAS_MEDIA
  path->entered = real3_at_w(reals + KEPT_MEDIA_w);
  path->hero_shares = real3_at_w(reals + KEPT_MEDIA_w + 3);
  path->optical = reals[KEPT_MEDIA_w + 6];
  path->medium = kept->ints[KEPT_MEDIUM_w];
  if (HAS_PRIORITY) {
    path->within.around = kept->ints[KEPT_RANKED_w];
    for (int k = 0; k < INTERFACES_MOST_w; ++k) path->within.medium[k] = kept->ints[KEPT_RANKED_w + 1 + k];
  }
  path->draws = uint_of_int_w(kept->ints[KEPT_MEDIUM_w + 1]);
#endif
}

FN void pool_none_w(PathPool_w* pool) {
  pool->count = 0;
  for (int sector = 0; sector < SECTORS_w; ++sector) pool->counts[sector] = 0;
}

/// The paths order[first], ... in lanes, as far as there are any. Lanes beyond repeat the first and are not alive.
FN void pool_take_w(const PathPool_w* pool, int first, Paths_w* path) {
  KeptPaths_w kept;
  int places[LANES];
  for (int lane = 0; lane < LANES; ++lane)
    places[lane] = pool->order[first + lane < pool->count ? first + lane : first] * KEPT_VECTORS_w;
  UNROLLED
  for (int v = 0; v < KEPT_VECTORS_w; ++v) {
    realw rows[LANES];
    UNROLLED
    for (int lane = 0; lane < LANES; ++lane) rows[lane] = pool->kept[places[lane] + v];
    transpose_w(rows);
    UNROLLED
    for (int i = 0; i < LANES; ++i) {
      int k = v * LANES + i;
      if (k < KEPT_REALS_w)
        kept.reals[k] = rows[i];
      else if (k < KEPT_REALS_w + KEPT_INTS_w)
        kept.ints[k - KEPT_REALS_w] = int_of_real_bits_w(rows[i]);
    }
  }
  paths_of_kept_w(&kept, first_lanes_w(pool->count - first), path);
}

/// Puts paths back, of which those that are alive are taken next. first: as for pool_take_w, whose places they get; of
/// new paths, their number in the pool. count: of all that were taken or are new.
FN void pool_put_w(PathPool_w* pool, int first, int are_new, int count, const Paths_w* path) {
  realw zero = splat_w(R(0.0));
  uint x = bits_w(lt_w(path->rays.planes[RAY_PLANE_D], zero)),
       y = bits_w(lt_w(path->rays.planes[RAY_PLANE_D + 1], zero));
  uint z = bits_w(lt_w(path->rays.planes[RAY_PLANE_D + 2], zero));
  int places[LANES];
  for (int lane = 0; lane < LANES; ++lane) {
    int i = first + lane;
    places[lane] = i >= count ? (int)POOL_PATHS : are_new ? i : pool->order[i];
  }
  for (uint alive = bits_w(path->alive); alive != 0u; alive &= alive - 1u) {
    int lane = first_bit(alive);
    int sector = (int)((x >> lane & 1u) | (y >> lane & 1u) << 1 | (z >> lane & 1u) << 2);
    pool->places[sector][pool->counts[sector]++] = places[lane];
  }
  KeptPaths_w kept;
  kept_of_paths_w(path, &kept);
  UNROLLED
  for (int v = 0; v < KEPT_VECTORS_w; ++v) {
    realw rows[LANES];
    UNROLLED
    for (int i = 0; i < LANES; ++i) {
      int k = v * LANES + i;
      rows[i] = zero;
      if (k < KEPT_REALS_w)
        rows[i] = kept.reals[k];
      else if (k < KEPT_REALS_w + KEPT_INTS_w)
        rows[i] = real_bits_of_int_w(kept.ints[k - KEPT_REALS_w]);
    }
    transpose_w(rows);
    UNROLLED
    for (int lane = 0; lane < LANES; ++lane) pool->kept[places[lane] * KEPT_VECTORS_w + v] = rows[lane];
  }
}

/// Makes the paths that were put back those that are taken next.
FN void pool_turn_w(PathPool_w* pool) {
  pool->count = 0;
  for (int sector = 0; sector < SECTORS_w; ++sector) {
    // LANES at a time: what is copied beyond a sector's number is overwritten by the next.
    for (int i = 0; i < pool->counts[sector]; i += LANES)
      store_int_w(read_int_w(pool->places[sector] + i), pool->order + pool->count + i);
    pool->count += pool->counts[sector];
    pool->counts[sector] = 0;
  }
}

/// What the paths at places first, first + 1, ... have gathered, LANES of them.
FN real3w pool_light_w(const PathPool_w* pool, int first) {
  realw light[3];
  UNROLLED
  for (int v = KEPT_RADIANCE_w / LANES; v <= (KEPT_RADIANCE_w + 2) / LANES; ++v) {
    realw rows[LANES];
    UNROLLED
    for (int lane = 0; lane < LANES; ++lane) rows[lane] = pool->kept[(first + lane) * KEPT_VECTORS_w + v];
    transpose_w(rows);
    UNROLLED
    for (int c = 0; c < 3; ++c) {
      int k = KEPT_RADIANCE_w + c;
      if (k / LANES == v) light[c] = rows[k % LANES];
    }
  }
  return real3_at_w(light);
}

// SPDX-License-Identifier: MIT
// kernels/intersect.cl as a function: find and describe are find_rays and describe_one of a width, compiled for the
// host. Every ray takes a lane of a block by itself, each lane in its turn. No guard: included once, in the namespace
// of a tier, after hits/trace_one.h; the unit includes <vector>.

/// rays, left: RAY_REALS and DEPARTED_INTS each, one after the other. hits, ids: HIT_REALS and HIT_INTS each; any_hit:
/// t is 0 where something is hit.
template <class Find, class Describe>
void host_rays(int lanes, const Scene& scene, const real* rays, const std::int32_t* left, std::size_t count,
               bool any_hit, Find find, Describe describe, real* hits, std::int32_t* ids) {
  const auto width = static_cast<std::size_t>(lanes);
  std::vector<real> out(width * HIT_REALS);
  std::vector<std::int32_t> out_ids(width * HIT_INTS);
  const std::vector<std::int32_t> none(width * FOUND_INTS, -1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t lane = i % width;
    std::vector<real> block(width * RAY_REALS, real(0)), ts(width);
    std::vector<std::int32_t> left_of(width * DEPARTED_INTS, -1), found(width * FOUND_INTS, -1);
    for (std::size_t k = 0; k < RAY_REALS; ++k) block[k * width + lane] = rays[i * RAY_REALS + k];
    for (std::size_t k = 0; k < DEPARTED_INTS; ++k) left_of[k * width + lane] = left[i * DEPARTED_INTS + k];
    find(&scene, block.data(), left_of.data(), lanes, any_hit ? 1 : 0, ts.data(), found.data());
    const std::int32_t* described = any_hit ? none.data() : found.data();
    describe(&scene, block.data() + lane, left_of.data() + lane, ts[lane], described + lane, out.data() + lane,
             out_ids.data() + lane);
    for (std::size_t k = 0; k < HIT_REALS; ++k) hits[i * HIT_REALS + k] = out[k * width + lane];
    for (std::size_t k = 0; k < HIT_INTS; ++k) ids[i * HIT_INTS + k] = out_ids[k * width + lane];
    if (any_hit && found[lane] != 0) hits[i * HIT_REALS + HIT_T] = 0;
  }
}

// SPDX-License-Identifier: MIT
#include "kinds/principled_lobes.h"

namespace strahl::kinds {
namespace {

bool may_be(double number, const Varying& value) { return value.texture >= 0 || value.color == grey(number); }
bool is(double number, const Varying& value) { return value.texture < 0 && value.color == grey(number); }

}  // namespace

// Sheen is found by draws of the base, which there are none of where all light goes through.
bool draws_all_lobes(const Principled& bsdf) {
  const bool is_metal = is(1, bsdf.metallic), has_base = !is_metal && !is(1, bsdf.spec_trans);
  const bool has_sheen_alone = !is_metal && may_be(1, bsdf.spec_trans) && !is(0, bsdf.sheen);
  return !has_sheen_alone && bsdf.main_specular_sampling_rate > 0 &&
         (bsdf.clearcoat_sampling_rate > 0 || is(0, bsdf.clearcoat)) &&
         (bsdf.diffuse_reflectance_sampling_rate > 0 || !has_base);
}

bool draws_all_lobes(const PrincipledThin& bsdf) {
  const bool has_glass = !is(0, bsdf.spec_trans), has_base = !is(1, bsdf.spec_trans);
  return (!has_glass ||
          (bsdf.specular_reflectance_sampling_rate > 0 && bsdf.specular_transmittance_sampling_rate > 0)) &&
         (bsdf.diffuse_reflectance_sampling_rate > 0 || !has_base || is(2, bsdf.diff_trans)) &&
         (bsdf.diffuse_transmittance_sampling_rate > 0 || !has_base || is(0, bsdf.diff_trans));
}

}  // namespace strahl::kinds

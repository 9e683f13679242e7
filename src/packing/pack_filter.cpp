// SPDX-License-Identifier: MIT
#include "packing/pack_filter.h"

#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "settings/sampling.h"

namespace strahl {

kinds::FilterTaps taps_of(const Scene& scene, const Features& features) {
  if (!features.flag("SHARED_SAMPLES") || resolve_sampling(scene).kind == SamplerKind::centre)
    return kinds::single_tap();
  return kinds::filter_taps(scene.film.filter);
}

template <typename Real>
void pack_film(PackedScene<Real>& packed, const Scene& scene, const Features& features) {
  packed.at(layout::HEADER_FILM_ROWS) = scene.film.window().height();
  const auto put = [&](const std::vector<double>& values) { return packed.put_shading(values); };
  packed.at(layout::HEADER_FILTER) = put(filter_quantiles(scene.film.filter, resolve_sampling(scene).kind));
  kinds::FilterTaps taps = taps_of(scene, features);
  for (double& term : taps.terms) term *= 1 << layout::WEIGHT_BITS / 2;
  packed.at(layout::HEADER_TAPS) = put(taps.terms);
  packed.at(layout::HEADER_TAP_SIDES) = taps.sides;
  packed.at(layout::HEADER_TAP_REACH) = taps.reach;
}

template void pack_film(PackedScene<float>&, const Scene&, const Features&);
template void pack_film(PackedScene<double>&, const Scene&, const Features&);

}  // namespace strahl

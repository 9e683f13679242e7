// SPDX-License-Identifier: MIT
#include "checkpoint/picture.h"

#include <set>

#include "render/aov.h"

namespace strahl {

RenderResult picture_of(const Checkpoint& checkpoint) {
  const FilmState& state = checkpoint.state;
  RenderResult result;
  result.color = state.film.mean();
  std::set<Aov> aovs;
  for (const std::string& name : checkpoint.header.aovs) aovs.insert(aov_from_name(name));
  aovs.erase(Aov::numeric_error);
  const FirstSampleValues values{state.film.width, state.film.height, state.aov_reals,
                                 state.aov_ints,   state.frame,       state.film.first_sample == 0};
  result.aov = aov_image(values, aovs);
  const Image squares = state.film.has_squares ? state.film.mean_of_squares() : Image{};
  result.named_aov = aov_image(values, {result.color, squares}, checkpoint.header.named_aovs);
  return result;
}

}  // namespace strahl

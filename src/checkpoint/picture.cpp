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
  const FirstSampleValues values{state.film.width, state.film.height, state.aov_reals, state.aov_ints, state.frame};
  result.aov = aov_image(values, aovs);
  result.named_aov = aov_image(values, checkpoint.header.named_aovs);
  return result;
}

}  // namespace strahl

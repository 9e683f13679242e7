// SPDX-License-Identifier: MIT
#include "checkpoint/picture.h"

#include <set>

#include "render/aov.h"

namespace strahl {

RenderResult picture_of(const Checkpoint& checkpoint) {
  const FilmState& state = checkpoint.state;
  RenderResult result;
  result.color = state.film.mean();
  result.aov.channels.clear();
  std::set<Aov> aovs;
  for (const std::string& name : checkpoint.header.aovs) aovs.insert(aov_from_name(name));
  aovs.erase(Aov::numeric_error);
  if (!aovs.empty())
    result.aov = aov_image(state.film.width, state.film.height, aovs, state.aov_reals, state.aov_ints, state.frame);
  return result;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "settings/sampler_name.h"

#include <fmt/format.h>

namespace strahl {

SamplerKind sampler_from_name(const std::string& name) {
  for (const SamplerKind kind : {SamplerKind::sobol, SamplerKind::independent, SamplerKind::centre})
    if (name == sampler_name(kind)) return kind;
  throw UsageError(fmt::format("unknown sampler \"{}\"; known: sobol, independent, centre", name));
}

const char* sampler_name(SamplerKind kind) {
  switch (kind) {
    case SamplerKind::sobol:
      return "sobol";
    case SamplerKind::independent:
      return "independent";
    case SamplerKind::centre:
      break;
  }
  return "centre";
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Samplers as the command line and files spell them.
#pragma once

#include <string>

#include "scene/model/scene.h"

namespace strahl {

[[nodiscard]] SamplerKind sampler_from_name(const std::string& name);  ///< "sobol", ...; throws UsageError.
[[nodiscard]] const char* sampler_name(SamplerKind kind);

}  // namespace strahl

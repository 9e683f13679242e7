// SPDX-License-Identifier: MIT
// What integrators take, in words and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "study/integrator_costs.h"

namespace strahl::cli {

[[nodiscard]] std::string integrators_text(const IntegratorCosts& costs);
[[nodiscard]] nlohmann::ordered_json integrators_json(const IntegratorCosts& costs);

}  // namespace strahl::cli

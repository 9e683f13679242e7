// SPDX-License-Identifier: MIT
#include "render/error_budget.h"

#include <cmath>

namespace strahl {

double ErrorBudget::with(double noise_rmse) const { return std::hypot(noise_rmse, output, rounding.value_or(0)); }

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Rays that leave what an earlier one has hit.
#pragma once

#include <optional>

#include "oracle/random.h"
#include "selftest/probe.h"
#include "settings/settings.h"

namespace strahl::selftest {

/// A ray from where `answer` says that the question's one primitive is hit, in a random direction, grazing one time in
/// four. What is flat is not met again; a sphere or cylinder at its other root, a box at its far side. None where the
/// answer is a miss or its place is out of the range of float.
[[nodiscard]] std::optional<Question> respawned(const Question& question, const Answer& answer, Precision precision,
                                                oracle::Random& random);

}  // namespace strahl::selftest

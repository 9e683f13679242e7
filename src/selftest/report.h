// SPDX-License-Identifier: MIT
// The result of a self test for people and for programs; docs/selftest.md explains both.
#pragma once

#include <string>

#include "selftest/selftest.h"

namespace strahl::selftest {

[[nodiscard]] std::string text_of(const SelftestResult& result);
[[nodiscard]] std::string json_of(const SelftestResult& result);

}  // namespace strahl::selftest

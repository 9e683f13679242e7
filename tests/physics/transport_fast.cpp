// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#define TIER_FAST 1
#include "physics/transport_body.h"

namespace strahl::test {

std::vector<TransportTier> transport_fast() { return tier::transport("fast"); }

}  // namespace strahl::test

// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#define TIER_ROBUST 1
#include "physics/transport_body.h"

namespace strahl::test {

std::vector<TransportTier> transport_robust() { return tier::transport("robust"); }

PacketTier packets_robust() { return tier::packets("robust"); }

}  // namespace strahl::test

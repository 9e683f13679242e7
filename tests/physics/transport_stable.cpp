// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#include "physics/transport_body.h"

namespace strahl::test {

std::vector<TransportTier> transport_stable() { return tier::transport("stable"); }

PacketTier packets_stable() { return tier::packets("stable"); }

}  // namespace strahl::test

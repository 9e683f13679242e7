// SPDX-License-Identifier: MIT
#define REAL_BITS 64
#include "physics/transport_body.h"

namespace strahl::test {

std::vector<TransportTier> transport_double() { return tier::transport("double"); }

}  // namespace strahl::test

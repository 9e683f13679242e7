// SPDX-License-Identifier: MIT
// Programs with media are others (cl/media). One lane, and reals that the compiler is quick with.
#define REAL_BITS 64
#define HAS_MEDIA 1
#include "physics/transport_body.h"

namespace strahl::test {

std::vector<TransportTier> transport_media() { return tier::transport("double"); }

}  // namespace strahl::test

// SPDX-License-Identifier: MIT
#include "bench/peers/embree.h"

namespace strahl::bench {

bool has_embree() { return false; }

std::unique_ptr<Contender> embree_contender(const Scene&, const EmbreeSettings&) {
  throw Error("built without Embree; apt install libembree-dev, and build again");
}

}  // namespace strahl::bench

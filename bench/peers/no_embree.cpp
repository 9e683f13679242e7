// SPDX-License-Identifier: MIT
#include "bench/peers/embree.h"
#include "bench/peers/embree_tree.h"

namespace strahl::bench {

bool has_embree() { return false; }

std::unique_ptr<Contender> embree_contender(const Scene&, const EmbreeSettings&) {
  throw Error("built without Embree; apt install libembree-dev, and build again");
}

PeerTree embree_tree(const Scene&, bool, unsigned, unsigned) {
  throw Error("built without Embree; apt install libembree-dev");
}

}  // namespace strahl::bench

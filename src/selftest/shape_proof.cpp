// SPDX-License-Identifier: MIT
#include "selftest/shape_proof.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace strahl::selftest {
namespace {

struct Entry {
  const char* name;
  const ShapeProof& (*proof)();
};

constexpr Entry entries[] = {
#define SHAPE(name, planes) {#name, name##_proof},
#include "../../cl/shapes/shapes.def"
#undef SHAPE
};

}  // namespace

const ShapeProof& proof_of(const std::string& kind) {
  const auto* found =
      std::find_if(std::begin(entries), std::end(entries), [&](const Entry& entry) { return kind == entry.name; });
  if (found == std::end(entries)) throw std::logic_error("nothing is proved of shapes of kind " + kind);
  return found->proof();
}

const std::vector<const ShapeProof*>& all_proofs() {
  static const std::vector<const ShapeProof*> proofs = [] {
    std::vector<const ShapeProof*> all;
    for (const Entry& entry : entries) all.push_back(&entry.proof());
    return all;
  }();
  return proofs;
}

}  // namespace strahl::selftest

// SPDX-License-Identifier: MIT
// rusticl at widths 8 and 16, one program a kind of shape: its compiler takes minutes over them.
#include "cl/same_bits.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

TEST_CASE("rusticl has the host's bits at every width") {
  require_pocl_and_rusticl();
  const Device device = Device::open("llvmpipe");
  for (const int lanes : {8, 16}) hold_kinds(device, lanes, 3000);
}

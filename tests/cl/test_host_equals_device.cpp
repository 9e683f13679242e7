// SPDX-License-Identifier: MIT
// Every device gives the bits of the kernels' headers compiled on the host, at every width and in both tiers.
// rusticl's fma flushes subnormal results to zero, so scales are ordinary here, where no product comes near them; and
// its compiler takes minutes for wide bodies, so width 1 here, the others in test_rusticl_widths.cpp.
#include <map>

#include "cl/same_bits.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

/// Every kind alone and all together, with the program that holds everything: one compilation a width.
template <class Real>
void hold_tier(Precision precision, const std::string& selector, std::size_t count, const std::vector<int>& widths) {
  const Device device = Device::open(selector);
  if (precision == Precision::fp64 && !device.info().fp64) return;
  std::map<std::string, Traced> scenes;
  SceneMaker mixed(42);
  for (const std::string& name : geometry_names()) {
    SceneMaker maker(40);
    maker.add(name, 20);
    mixed.add(name, name == "plane" ? 3 : 14);
    scenes.emplace(name, trace_on_host<Real>(maker, count / 10));
  }
  scenes.emplace("mixed", trace_on_host<Real>(mixed, count));
  for (const int lanes : widths) {
    RenderSettings settings;
    settings.precision = precision;
    settings.lanes = lanes;
    settings.generic = true;
    for (const auto& [name, traced] : scenes) hold_same<Real>(device, name, traced, settings);
  }
}

}  // namespace

TEST_CASE("the devices that may not be missing are there") { require_pocl_and_rusticl(); }

TEST_CASE("PoCL has the host's bits") { hold_tier<float>(Precision::stable, "pocl", 100000, {1, 16}); }

TEST_CASE("PoCL has the host's bits in lanes between, and in double", "[slow]") {
  hold_tier<float>(Precision::stable, "pocl", 100000, {8});
  hold_tier<double>(Precision::fp64, "pocl", 100000, {1, 8});
}

TEST_CASE("PoCL has the host's bits with programs for one kind of shape") {
  hold_kinds(Device::open("pocl"), 16, 5000);
}

TEST_CASE("rusticl has the host's bits") { hold_kinds(Device::open("llvmpipe"), 1, 5000); }

TEST_CASE("every other device has the host's bits") {
  for (const std::string& selector : present_devices()) {
    if (selector == "pocl" || selector == "llvmpipe" || selector == "oclgrind") continue;
    hold_tier<float>(Precision::stable, selector, 50000, {1, 8, 16});
    hold_tier<double>(Precision::fp64, selector, 50000, {1, 8});
  }
}

// SPDX-License-Identifier: MIT
// When samples are followed in lanes: in single precision, where packets may hold the scene's kinds and samples differ.
#include <catch2/catch.hpp>
#include <map>

#include "program/kernel_source.h"
#include "program/path_lanes.h"
#include "scene/loader.h"
#include "scene/model/build.h"

namespace strahl {
namespace {

int lanes_of(const Scene& scene, const RenderSettings& settings = {}) {
  return path_lanes(features_of(scene, settings), settings, 16);
}

TEST_CASE("kinds with a body for packets, as the kernels have them") {
  const std::map<std::string, bool> expected = {{"sphere", true},       {"plane", true}, {"triangle", true},
                                                {"box", false},         {"disk", false}, {"cylinder", false},
                                                {"parallelogram", true}};
  for (const std::string& kind : list_entries("shapes")) {
    INFO(kind);
    CHECK(has_packet_body(kind) == expected.at(kind));
  }
}

TEST_CASE("paths go in lanes where packets pay") {
  const Scene scene = load_scene(STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml").scene;
  CHECK(lanes_of(scene) == 16);
  CHECK(lanes_of(load_scene(STRAHL_SOURCE_DIR "/scenes/mesh/torus-and-icosphere.xml").scene) == 16);
  CHECK(lanes_of(load_scene(STRAHL_SOURCE_DIR "/scenes/instances/mushrooms.xml").scene) == 16);
  RenderSettings settings;
  settings.precision = Precision::fp64;
  CHECK(lanes_of(scene, settings) == 1);
  settings = {};
  settings.paths_in_lanes = false;
  CHECK(lanes_of(scene, settings) == 1);
  settings.paths_in_lanes = true;
  CHECK(lanes_of(scene, settings) == 16);

  Scene with_disk = scene;
  add(with_disk, Disk{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(lanes_of(with_disk) == 16);
  settings = {};
  settings.precision = Precision::stable;
  CHECK(lanes_of(scene, settings) == 16);
  CHECK(lanes_of(with_disk, settings) == 1);
  Scene alike = load_scene(STRAHL_SOURCE_DIR "/scenes/lecture/lit.xml").scene;
  alike.sampler.kind = SamplerKind::centre;
  CHECK(lanes_of(alike) == 1);
}

}  // namespace
}  // namespace strahl

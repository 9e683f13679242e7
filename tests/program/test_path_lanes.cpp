// SPDX-License-Identifier: MIT
// When samples are followed in lanes: where samples of a pixel differ.
#include <catch2/catch.hpp>

#include "program/path_lanes.h"
#include "scene/loader.h"
#include "scene/model/build.h"

namespace strahl {
namespace {

int lanes_of(const Scene& scene, const RenderSettings& settings = {}) {
  return path_lanes(features_of(scene, settings), settings, 16);
}

TEST_CASE("paths go in lanes where samples differ, in every precision") {
  const Scene scene = load_scene(STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml").scene;
  CHECK(lanes_of(scene) == 16);
  CHECK(lanes_of(load_scene(STRAHL_SOURCE_DIR "/scenes/mesh/torus-and-icosphere.xml").scene) == 16);
  CHECK(lanes_of(load_scene(STRAHL_SOURCE_DIR "/scenes/instances/mushrooms.xml").scene) == 16);
  RenderSettings settings;
  settings.paths_in_lanes = false;
  CHECK(lanes_of(scene, settings) == 1);
  settings.paths_in_lanes = true;
  CHECK(lanes_of(scene, settings) == 16);

  Scene with_disk = scene;
  add(with_disk, Disk{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  settings = {};
  for (const Precision precision : {Precision::fast, Precision::stable, Precision::robust, Precision::fp64}) {
    settings.precision = precision;
    CHECK(lanes_of(with_disk, settings) == 16);
  }
  Scene alike = load_scene(STRAHL_SOURCE_DIR "/scenes/lecture/lit.xml").scene;
  alike.sampler.kind = SamplerKind::centre;
  CHECK(lanes_of(alike) == 1);
}

}  // namespace
}  // namespace strahl

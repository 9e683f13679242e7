// SPDX-License-Identifier: MIT
// Damaged scenes end in a scene or in a SceneError, never in anything else: byte mutations with a fixed seed.
#include <catch2/catch.hpp>
#include <random>

#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const char* const seed_scene = R"(<scene version="0.6.0"><default name="r" value="1.5"/><integrator type="direct"/>
<sensor type="perspective"><float name="fov" value="40"/><transform name="toWorld"><lookAt origin="0,0,5" target="0,0,0"
up="0,1,0"/><rotate x="1" angle="20"/></transform><film type="hdrfilm"><integer name="width" value="64"/><rfilter
type="box"/></film><sampler type="independent"><integer name="sampleCount" value="4"/></sampler></sensor>
<bsdf type="twosided" id="m"><bsdf type="diffuse"><rgb name="reflectance" value="#8090a0"/></bsdf></bsdf>
<shape type="sphere" id="s"><float name="radius" value="$r"/><ref id="m"/></shape><shape type="cylinder"><point name="p0"
x="0" y="0" z="0"/><emitter type="area"><spectrum name="radiance" value="400:1, 700:2"/></emitter></shape>
<shape type="plane"><vector name="normal" value="0 1 0"/><float name="d" value="-1"/></shape><shape type="cube"><transform
name="toWorld"><matrix value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/></transform></shape><emitter type="point"/>
<emitter type="spot"><float name="cutoffAngle" value="30"/><float name="beamWidth" value="9"/><spectrum name="intensity"
type="irregular"><string name="wavelengths" value="400, 500, 600"/><string name="values" value="1 2 .5"/></spectrum></emitter>
<emitter type="constant"><blackbody name="radiance" temperature="5000K" scale="0.01"/></emitter><path value="."/>
<shape type="disk"><animation name="toWorld"><transform time="0"><scale value="2"/></transform><transform time="1.5"/>
</animation></shape><sensor type="batch"><float name="shutterClose" value="1"/><sensor type="orthographic" id="1"/></sensor>
<bsdf type="diffuse" id="n"><spectrum name="reflectance" value="400:0.1, 500.5:0.3, 700:0.9"/></bsdf></scene>)";

std::string damaged(std::mt19937& random) {
  std::string text = seed_scene;
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::string likely = "<>/\"=&#$ 0129.-+enaix\n";
  for (std::size_t count = 1 + below(6); count > 0; --count) {
    const std::size_t at = below(text.size());
    switch (below(5)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text[at] = likely[below(likely.size())];
        break;
      case 2:
        text.erase(at, 1 + below(8));
        break;
      case 3:
        text.insert(at, 1, likely[below(likely.size())]);
        break;
      default:
        text.insert(at, text.substr(below(text.size()), below(60)));
        break;
    }
  }
  return text;
}

}  // namespace

TEST_CASE("damaged scenes are read or refused") {
  REQUIRE(load_text(seed_scene).scene.shapes.size() == 5);
  const SceneFolder folder;
  std::mt19937 random(20261121);
  int loaded = 0, refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string path = folder.write("scene.xml", damaged(random));
    try {
      LoadOptions options;
      if (random() % 2 == 0) options.sensor = "1";
      static_cast<void>(load_scene(path, options));
      ++loaded;
    } catch (const SceneError& error) {
      if (error.diagnostics().empty()) FAIL("an error without a word");
      ++refused;
    }
  }
  CHECK(loaded > 50);  // Both ends are exercised.
  CHECK(refused > 500);
}

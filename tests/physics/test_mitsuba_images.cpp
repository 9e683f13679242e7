// SPDX-License-Identifier: MIT
// Textures and environments have the values that Mitsuba 3 has given (tests/acceptance/mitsuba_images.py --write) at
// points of an image and in directions of the sky: filter, wrap, curve, which way is up, handedness, turns.
#include <map>
#include <memory>

#include "kinds/textures.h"
#include "physics/mitsuba_table.h"
#include "physics/transport_scenes.h"
#include "scene/model/transforms.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct Told {
  std::string kind, mode, curve;
  Triad at, colour;
};

std::vector<Told> all_told() {
  return told_by_mitsuba<Told>("mitsuba_images.csv", {&Told::kind, &Told::mode, &Told::curve});
}

std::shared_ptr<const Texels> image(const std::string& name) {
  static std::map<std::string, std::shared_ptr<const Texels>> images;
  std::shared_ptr<const Texels>& found = images[name];
  if (!found) found = std::make_shared<const Texels>(read_texels(STRAHL_SOURCE_DIR "/scenes/" + name));
  return found;
}

Scene scene_of(const Told& told) {
  Scene scene = empty_scene();
  if (told.kind == "envmap") {
    EnvironmentLight light;
    light.texels = image("lights/sky.hdr");
    const Transform turn = told.mode == "turned"   ? rotation({0, 1, 0}, 100)
                           : told.mode == "tilted" ? rotation({1, 0, 0}, -90)
                                                   : Transform{};
    for (int i = 0; i < 3; ++i) light.axes[static_cast<std::size_t>(i)] = turn.column(i);
    scene.lights.emplace_back().emitter = light;
    return scene;
  }
  Bitmap bitmap;
  bitmap.texels = image("textures/letter.png");
  bitmap.filter = told.kind == "nearest" ? TextureFilter::nearest : TextureFilter::bilinear;
  bitmap.wrap = told.mode == "clamp"    ? TextureWrap::clamp
                : told.mode == "mirror" ? TextureWrap::mirror
                                        : TextureWrap::repeat;
  bitmap.curve.kind = told.curve == "raw" ? TexelCurve::Kind::linear : TexelCurve::Kind::srgb;
  scene.textures.emplace_back().pattern = bitmap;
  scene.materials.front().bsdf = Diffuse{{{}, 0}};
  scene.shapes.emplace_back().geometry = Rectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  return scene;
}

TEST_CASE("images are those of Mitsuba") {
  const std::vector<Told> all = all_told();
  REQUIRE(all.size() == 126);
  for (const TransportTier& tier : transport_tiers())
    for (const Told& told : all) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << told.kind << " " << told.mode << " " << told.curve << " at "
                     << told.at[0] << " " << told.at[1] << " " << told.at[2]);
      const TierScene scene(scene_of(told), tier);
      const Triad found = told.kind == "envmap"
                              ? tier.look(scene.buffers(), {0, 0, 0}, {told.at}).front().radiance
                              : tier.texture(scene.buffers(), 0, {{told.at[0], told.at[1], 0}}).front();
      for (std::size_t k = 0; k < 3; ++k) CHECK(found[k] == Approx(told.colour[k]).epsilon(2e-4).margin(2e-5));
    }
}

}  // namespace

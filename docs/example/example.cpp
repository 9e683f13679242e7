// SPDX-License-Identifier: MIT
// A scene built in C++: create it, add spheres and planes, create a camera, trace, write the picture.
#include <strahl.h>

#include <exception>
#include <iostream>
#include <optional>

using namespace strahl;

Scene marbles() {
  Scene scene;
  scene.integrator.name = "emission";  // a pixel shows the colour that the first thing its ray hits emits

  add(scene, emitting(plane_through({0, 0, 0}, {0, 1, 0}), {0.16, 0.19, 0.27}));    // floor
  add(scene, emitting(plane_through({0, 0, -14}, {0, 0, 1}), {0.50, 0.68, 0.88}));  // sky
  add(scene, emitting(Sphere{{0, 1, 0}, 1}, {0.95, 0.32, 0.16}));
  add(scene, emitting(Sphere{{-2.15, 0.8, 0.65}, 0.8}, {0.10, 0.52, 0.85}));
  add(scene, emitting(Sphere{{2, 0.7, 0.75}, 0.7}, {0.98, 0.76, 0.18}));

  scene.camera = perspective_camera({0, 2.2, 9}, {0, 1.15, 0}, {0, 1, 0}, 40);
  scene.film.width = 640;
  scene.film.height = 480;
  scene.sampler.sample_count = 16;
  return scene;
}

int main() {
  try {
    const Device device = Device::open("");  // the fastest GPU, else the CPU
    // Not every device computes as it should: which precision it can be trusted with, and whether it ends long loops.
    const TierVerdict tier = choose_tier(device, std::nullopt).tier;
    RenderSettings settings;
    settings.precision = tier.precision;
    settings.loop_turns = tier.loop_turns;
    Renderer renderer(device, marbles(), settings);
    write_image(renderer.render().color, "marbles.png");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}

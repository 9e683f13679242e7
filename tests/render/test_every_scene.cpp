// SPDX-License-Identifier: MIT
// Every scene of the project in the robust tier, and two in the others, with the same bits on every device that is
// there. Minutes: Mesa's llvmpipe compiles each program for 5 to 40 s, Oclgrind interprets.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>

#include "render/pictures.h"

namespace strahl::test {
namespace {

void hold_everywhere(const std::filesystem::path& path, Precision precision) {
  Scene scene = small_scene(path, 16, 12, 2);
  scene.integrator.max_depth = std::min(scene.integrator.max_depth, 20);  // llvmpipe ends long loops.
  const RenderResult expected = render("pocl", scene, all_aovs(precision));
  std::string ran;
  for (const std::string& device : present_devices()) {
    INFO(path << ", " << precision_name(precision) << ", " << device);
    if (precision == Precision::fp64 && !Device::open(device).info().fp64) continue;
    CHECK(same_bits(expected, render(device, scene, all_aovs(precision))));
    ran += " " + device;
  }
  std::cout << path.lexically_relative(scene_folder).string() << ", " << precision_name(precision) << ":" << ran
            << std::endl;
}

TEST_CASE("every scene of the project, robust") {
  require_pocl_and_rusticl();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scene_folder))
    if (entry.path().extension() == ".xml") hold_everywhere(entry.path(), Precision::robust);
}

TEST_CASE("two scenes, stable and double") {
  require_pocl_and_rusticl();
  for (const char* name : {"lecture/lit.xml", "accuracy/mirror-box.xml"})
    for (const Precision precision : {Precision::stable, Precision::fp64})
      hold_everywhere(scene_folder / name, precision);
}

}  // namespace
}  // namespace strahl::test

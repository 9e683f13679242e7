// SPDX-License-Identifier: MIT
// The memory that a scene needs, told from counts: held against what packing makes, and refused with words.
#include <catch2/catch.hpp>

#include "packing/cl_layout.h"
#include "packing/memory_estimate.h"
#include "packing/pack.h"
#include "scene/model/build.h"

using namespace strahl;

namespace {

Mesh strip(int triangles) {
  Mesh mesh;
  for (int i = 0; i < triangles + 2; ++i) mesh.positions.push_back({0.5 * i, i % 2 * 1.0, 0});
  for (int i = 0; i < triangles; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

MemoryNeed need_of(const Scene& scene, Precision precision = Precision::robust, int lanes = 1) {
  return least_memory(scene, features_of(scene, {}), precision, lanes);
}

DeviceInfo device_with(std::uint64_t global_mebibytes, std::uint64_t buffer_mebibytes) {
  DeviceInfo info;
  info.name = "small";
  info.platform = "test";
  info.global_memory = global_mebibytes << 20;
  info.max_allocation = buffer_mebibytes << 20;
  return info;
}

std::string refusal(const MemoryNeed& need, const DeviceInfo& device, Precision precision = Precision::robust) {
  try {
    require_memory(need, device, precision);
  } catch (const NoDeviceError& error) {
    return error.what();
  }
  FAIL("not refused");
  return {};
}

constexpr std::uint64_t mebibyte = 1 << 20;

}  // namespace

TEST_CASE("kinds add up, in whole blocks") {
  Scene scene;
  add(scene, strip(5));
  add(scene, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(need_of(scene).geometry == 6 * 9 * 4);
  CHECK(need_of(scene).index == 6 * 8);
  CHECK(need_of(scene).shading == 0);
  CHECK(need_of(scene, Precision::fp64).geometry == 6 * 9 * 8);
  CHECK(need_of(scene, Precision::fp64).index == 6 * 8);
  CHECK(need_of(scene, Precision::robust, 16).geometry == 16 * 9 * 4);
  add(scene, Sphere{});
  CHECK(need_of(scene, Precision::robust, 8).index == 2 * 8 * 8);
}

TEST_CASE("what no kernel asks for is not counted") {
  Scene scene;
  Mesh mesh = strip(10);
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  mesh.uvs.assign(mesh.positions.size(), {0, 0});
  add(scene, mesh);
  CHECK(need_of(scene).shading == 10 * 9 * 4);
  scene.integrator.name = "depth";
  CHECK(need_of(scene).shading == 0);
  RenderSettings settings;
  settings.aovs = {Aov::uv};
  CHECK(least_memory(scene, features_of(scene, settings), Precision::robust, 1).shading == 10 * 6 * 4);
}

TEST_CASE("what --disable leaves out is not counted") {
  Scene scene;
  add(scene, Sphere{});
  Mesh mesh = strip(10);
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  add(scene, mesh);
  Group group;
  group.shapes.emplace_back().geometry = strip(100);
  add_instance(scene, add(scene, group), {});
  const auto need_without = [&](const std::set<std::string>& disabled) {
    RenderSettings settings;
    settings.disabled = disabled;
    return least_memory(scene, features_of(scene, settings), Precision::robust, 1);
  };
  const std::uint64_t sphere = need_of(scene).geometry - (110 * 9 + layout::INSTANCE_REALS) * 4;
  CHECK(need_without({"INSTANCES"}).geometry == sphere + 10 * 9 * 4);
  CHECK(need_without({"INSTANCES"}).index == 11 * 8);
  CHECK(need_without({"shapes/triangle"}).geometry == sphere + layout::INSTANCE_REALS * 4);
  CHECK(need_without({"shapes/triangle"}).shading == 0);
  CHECK(need_without({"shapes/sphere"}).geometry == need_of(scene).geometry - sphere);
}

TEST_CASE("a group counts once, however often it is placed") {
  Scene scene;
  Group group;
  group.shapes.emplace_back().geometry = strip(100);
  const int index = add(scene, group);
  for (int i = 0; i < 50; ++i) add_instance(scene, index, {});
  CHECK(need_of(scene).geometry == (100 * 9 + 50 * layout::INSTANCE_REALS) * 4);
}

TEST_CASE("packing takes as much and not far more") {
  Scene scene;
  Mesh mesh = strip(3000);
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  add(scene, mesh);
  for (int i = 0; i < 1000; ++i) add(scene, Sphere{{3.0 * i, 0, 9}, 1});
  const Features features = features_of(scene, {});
  for (const int lanes : {1, 8, 16}) {
    const PackedScene<float> packed = pack_scene<float>(scene, features, {lanes, {}});
    const MemoryNeed need = least_memory(scene, features, Precision::robust, lanes);
    INFO(lanes << " lanes: " << packed.bytes() << " bytes, at least " << need.total());
    CHECK(packed.geometry.size() * 4 >= need.geometry);
    CHECK(packed.shading.size() * 4 >= need.shading);
    CHECK(packed.index.size() * 4 >= need.index);
    CHECK(static_cast<double>(packed.bytes()) < 2.5 * static_cast<double>(need.total()));
  }
}

TEST_CASE("an image counts once, an environment with its tables, mip levels where they are asked for") {
  Scene scene;
  Bitmap bitmap;
  bitmap.texels = std::make_shared<const Texels>(texels_of_bytes(8, 6, 3, std::vector<std::uint8_t>(144, 7).data()));
  scene.textures = {{"", bitmap, {}}, {"", bitmap, {}}};
  add(scene, Rectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, add(scene, Diffuse{{{1, 1, 1}, 1}}));
  EnvironmentLight light;
  light.texels = bitmap.texels;
  scene.lights.emplace_back().emitter = light;
  for (const bool texture_lod : {false, true}) {
    RenderSettings settings;
    settings.texture_lod = texture_lod;
    const Features features = features_of(scene, settings);
    const MemoryNeed need = least_memory(scene, features, Precision::robust, 1);
    // 48 texels, 5 + 40 choices of two ints, one rectangle's id and part; 48 / 9 texels of 8 bytes.
    CHECK(need.index == 4 * (48 + 2 * 45) + 8 + (texture_lod ? 40U : 0U));
    const PackedScene<float> packed = pack_scene<float>(scene, features, {});
    CHECK(packed.index.size() * 4 >= need.index);
  }
}

TEST_CASE("a device that is too small is refused, with the need, its limits and a remedy") {
  const MemoryNeed need{300 * mebibyte, 100 * mebibyte, 50 * mebibyte};
  CHECK_NOTHROW(require_memory(need, device_with(450, 300), Precision::robust));
  const std::string words =
      "the scene takes at least 450 MiB (geometry 300, normals and texture coordinates 100, tables and texels 50); 0:0 "
      "small (test) has 449 MiB, 300 MiB in one buffer. Choose a device with more memory (-d), or simplify the meshes "
      "or "
      "images";
  CHECK(refusal(need, device_with(449, 300)) == words);
  CHECK(refusal(need, device_with(4000, 299)).find("has 4000 MiB, 299 MiB in one buffer") != std::string::npos);
  CHECK(refusal({1, 300 * mebibyte, 1}, device_with(4000, 299)).find("coordinates 300") != std::string::npos);
  CHECK(refusal({1, 1, 300 * mebibyte}, device_with(4000, 299)).find("texels 300") != std::string::npos);
  DeviceInfo limited = device_with(449, 300);
  limited.is_memory_limited = true;
  CHECK(refusal(need, limited)
            .find("has 449 MiB by --memory-limit, 300 MiB in one buffer. Choose a larger "
                  "--memory-limit, or simplify") != std::string::npos);
  limited = device_with(4000, 299);
  limited.is_memory_limited = true;
  CHECK(refusal(need, limited).find("Choose a device with more memory (-d)") != std::string::npos);
  CHECK(refusal(need, device_with(1, 1), Precision::fp64).find("a --precision other than double, which takes half") !=
        std::string::npos);
}

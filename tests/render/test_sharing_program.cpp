// SPDX-License-Identifier: MIT
// What takes shared samples into the film is a program of its own: the same for all scenes, built once for them.
#include <catch2/catch.hpp>

#include "opencl/own_cache.h"
#include "opencl/program.h"
#include "program/program_text.h"
#include "render/pictures.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

template <class Shape>
Scene lit(const Shape& shape, const std::string& integrator = "depth") {
  Scene scene;
  scene.film.width = scene.film.height = 8;
  add(scene, shape);
  add(scene, PointLight{});
  scene.integrator.name = integrator;
  return scene;
}

const Scene sphere = lit(strahl::Sphere{{0, 0, 5}, 1});
const Scene disk = lit(Disk{{0, 0, 5}, {1, 0, 0}, {0, 1, 0}});

std::string text_of(const Scene& scene, const RenderSettings& settings = {}, int lanes = 16) {
  return sharing_source(features_of(scene, settings), settings.precision, lanes).text;
}

}  // namespace

TEST_CASE("the program that shares samples depends on the film and on nothing else of the scene") {
  const std::string text = text_of(sphere);
  CHECK((text_of(disk) == text));
  CHECK((text_of(lit(Sphere{{0, 0, 5}, 1}, "path")) == text));
  RenderSettings other;
  other.aovs = {Aov::depth};
  CHECK((text_of(sphere, other) == text));
  other = {};
  other.precision = Precision::fp64;
  CHECK((text_of(sphere, other) != text));
  other = {};
  other.estimate_error = !other.estimate_error;
  CHECK((text_of(sphere, other) != text));
  CHECK((text_of(sphere, {}, 8) != text));
}

TEST_CASE("the program that shares samples is built by the first of several scenes, and is cached where both are") {
  require_pocl();
  const OwnCache cache;
  RenderSettings settings;
  settings.precision = Precision::stable;
  const int lanes = default_lanes(Device::open("pocl").info().native_vector_width, settings.precision);
  const auto from_cache = [&](const Scene& scene) {
    return Renderer(Device::open("pocl"), scene, settings).stats().program_from_cache;
  };
  const auto is_cached = [&](const Scene& scene) {
    return Renderer::is_program_cached(Device::open("pocl"), scene, settings);
  };
  CHECK_FALSE(is_cached(sphere));
  CHECK_FALSE(from_cache(sphere));
  const auto files = cache.files();
  CHECK(files.size() == 2);
  CHECK(is_cached(sphere));
  CHECK_FALSE(is_cached(disk));
  CHECK_FALSE(from_cache(disk));
  CHECK(cache.files().size() == 3);
  CHECK(is_cached(disk));
  const std::string shared = program_hash(sharing_source(features_of(sphere, settings), settings.precision, lanes));
  // Either is missing, or the other.
  for (const auto& file : files) {
    const auto aside = cache.directory() / "aside";
    std::filesystem::rename(file, aside);
    CHECK_FALSE(is_cached(sphere));
    const bool is_shared = file.filename().string().starts_with(shared);
    CHECK(is_cached(disk) != is_shared);
    if (is_shared) CHECK_FALSE(from_cache(sphere));
    std::filesystem::rename(aside, file);
    CHECK(from_cache(sphere));
  }
}

}  // namespace strahl::test

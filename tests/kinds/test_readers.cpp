// SPDX-License-Identifier: MIT
// Every entry of the kernels' lists can be written in a scene file and stands in a scene of scenes/: one without its
// reader or its scene is named here.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <set>

#include "kinds/entries.h"
#include "kinds/materials.h"
#include "program/features.h"
#include "scene/scene_text.h"

namespace strahl {
namespace {

using Names = std::set<std::string>;

Names entries(const std::string& list) {
  const std::vector<std::string> names = list_entries(list);
  return {names.begin(), names.end()};
}

/// What the scenes of scenes/ are made of.
struct Used {
  Names shapes, materials, lights, textures, areas, integrators;
  /// Of the variants of scene.h, by their numbers.
  std::set<std::size_t> geometries, bsdfs, emitters, patterns;

  void add(const Scene& scene) {
    for_each_shape(scene, [&](const Shape& shape) {
      shapes.insert(shape_kind(shape));
      geometries.insert(shape.geometry.index());
      if (!shape.radiance && !shape.exitance) return;
      lights.insert(shape.exitance ? "directionalarea" : "area");
      if (const std::string area = area_kind(shape.geometry); !area.empty()) areas.insert(area);
    });
    for (const Material& material : scene.materials) {
      if (const MaterialFacts facts = material_facts(material); facts.nested.empty()) materials.insert(facts.kind);
      bsdfs.insert(material.bsdf.index());
    }
    for (const Light& light : scene.lights) {
      lights.insert(light_kind(light));
      emitters.insert(light.emitter.index());
    }
    for (const Texture& texture : scene.textures) {
      textures.insert(texture_kind(texture));
      patterns.insert(texture.pattern.index());
    }
    integrators.insert(scene.integrator.name);
  }
};

Used used_by_scenes() {
  Used used;
  for (const auto& file : std::filesystem::recursive_directory_iterator(STRAHL_SOURCE_DIR "/scenes"))
    if (file.path().extension() == ".xml") used.add(load_scene(file.path().string()).scene);
  return used;
}

Used of_body(const std::string& body) {
  Used used;
  used.add(test::load_body(body).scene);
  return used;
}

/// what: the variant.
template <typename Variant>
void check_alternatives(const std::string& what, const std::set<std::size_t>& used) {
  for (std::size_t i = 0; i < std::variant_size_v<Variant>; ++i) {
    INFO("alternative " << i << " of " << what);
    CHECK(used.contains(i));
  }
}

TEST_CASE("every entry stands in a scene") {
  const Used used = used_by_scenes();
  CHECK(used.shapes == entries("shapes"));
  CHECK(used.materials == entries("materials"));
  CHECK(used.textures == entries("textures"));
  CHECK(used.areas == entries("areas"));
  CHECK(used.lights == entries("lights"));
  // A cloud is spheres of one file, which no scene has use for.
  std::set<std::size_t> geometries = used.geometries;
  geometries.insert(Geometry(SphereCloud{}).index());
  check_alternatives<Geometry>("Geometry", geometries);
  check_alternatives<decltype(Material::bsdf)>("Material::bsdf", used.bsdfs);
  check_alternatives<decltype(Light::emitter)>("Light::emitter", used.emitters);
  check_alternatives<decltype(Texture::pattern)>("Texture::pattern", used.patterns);
}

/// What an entry cannot be without.
std::string needed_by(const std::string& name) {
  if (name == "mesh_attribute") return "<string name=\"name\" value=\"vertex_color\"/>";
  const std::map<std::string, std::string> files = {{"bitmap", "textures/letter.png"}, {"envmap", "lights/sky.hdr"}};
  const auto file = files.find(name);
  if (file == files.end()) return "";
  return "<string name=\"filename\" value=\"" STRAHL_SOURCE_DIR "/scenes/" + file->second + "\"/>";
}

TEST_CASE("every entry has a reader, by its own name") {
  for (const std::string& name : list_entries("materials")) {
    INFO(name);
    CHECK(of_body("<shape type=\"sphere\"><bsdf type=\"" + name + "\"/></shape>").materials.contains(name));
  }
  for (const std::string& name : list_entries("lights")) {
    INFO(name);
    const std::string emitter = "<emitter type=\"" + name + "\">" + needed_by(name) + "</emitter>";
    const bool is_of_shape = name == "area" || name == "directionalarea";
    CHECK(of_body(is_of_shape ? "<shape type=\"sphere\">" + emitter + "</shape>" : emitter).lights == Names{name});
  }
  for (const std::string& name : list_entries("textures")) {
    INFO(name);
    const std::string shape = name == "mesh_attribute"
                                  ? "<shape type=\"ply\"><string name=\"filename\" value=\"" STRAHL_SOURCE_DIR
                                    "/scenes/textures/coloured.ply\"/>"
                                  : "<shape type=\"sphere\">";
    CHECK(of_body(shape + "<bsdf type=\"diffuse\"><texture name=\"reflectance\" type=\"" + name + "\">" +
                  needed_by(name) + "</texture></bsdf></shape>")
              .textures == Names{name});
  }
  for (const std::string& name : list_entries("integrators")) {
    INFO(name);
    // Without a mask volpath is path.
    const std::string mask = "<shape type=\"sphere\"><bsdf type=\"null\"/></shape>";
    CHECK(of_body("<integrator type=\"" + name + "\"/>" + mask).integrators == Names{name});
  }
}

TEST_CASE("every row of shapes names kinds that the kernels have, and all of them") {
  Names kinds, areas;
#define SHAPE_KIND(S, kind, area, types) \
  kinds.insert(#kind);                   \
  areas.insert(#area);
#include "kinds/shapes.def"
#undef SHAPE_KIND
  areas.erase("none");
  CHECK(kinds == entries("shapes"));
  CHECK(areas == entries("areas"));
}

}  // namespace
}  // namespace strahl

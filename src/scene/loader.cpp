// SPDX-License-Identifier: MIT
// File -> scene: expand, check, read, validate; every problem is collected before anything is thrown.
#include "scene/loader.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "image/confined_reads.h"
#include "scene/auto_integrator.h"
#include "scene/meshes/material_warnings.h"
#include "scene/meshes/mesh_file.h"
#include "scene/model/framing.h"
#include "scene/readers/mesh_import.h"
#include "scene/readers/number_suffixes.h"
#include "scene/readers/other_names.h"
#include "scene/validate.h"
#include "scene/xml/diagnostics.h"
#include "scene/xml/element_ids.h"
#include "scene/xml/scene_builder.h"
#include "scene/xml/xml_animation.h"
#include "scene/xml/xml_expand.h"
#include "scene/xml/xml_vocabulary.h"

namespace strahl {

namespace {

bool is_mesh_path(const std::string& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".obj" || extension == ".ply" || extension == ".serialized";
}

Scene scene_of_xml(const std::string& path, const LoadOptions& options, Diagnostics& diagnostics) {
  XmlPool pool;
  SearchPath search_path(path);
  XmlElement* root = read_expanded_xml(path, options.defines, search_path, pool, diagnostics);
  if (root == nullptr || !check_vocabulary(*root, diagnostics)) return {};
  use_mitsuba_names(*root, pool);
  drop_number_suffixes(*root, pool, diagnostics);
  freeze_animations(*root, diagnostics);
  const ElementIds ids(*root, diagnostics);
  SceneBuilder builder{{}, search_path, ids, diagnostics, options.progress, options.sensor};
  read_scene(*root, builder);
  if (builder.scene.integrator.name == "auto" && !diagnostics.has_errors()) choose_integrator(builder.scene);
  if (!diagnostics.has_errors()) simplify_integrator(builder.scene);
  return std::move(builder.scene);
}

Scene scene_of_mesh(const std::string& path, const LoadOptions& options, Diagnostics& diagnostics) {
  for (const auto& [name, value] : options.defines)
    diagnostics.unknown({path}, fmt::format("-D {}={}: a mesh has no parameters; it has no effect", name, value));
  if (!options.sensor.empty())
    diagnostics.unknown({path}, fmt::format("--sensor {}: a mesh has no <sensor>; it has no effect", options.sensor));
  MeshFile file = read_mesh(path, progress_of(path, options.progress));
  for (const std::string& library : file.libraries) diagnostics.opened(library);
  diagnostics.append(file.warnings);
  diagnostics.append(material_warnings(file));
  Scene scene;
  scene.integrator.name = "normals";
  Shape shape;
  shape.where = {path};
  if (file.mesh.triangles.empty()) diagnostics.error({path}, "has no triangles");
  ImageFiles images;
  add_mesh_materials(file, {}, shape, scene, images, diagnostics);
  file.mesh.attributes.clear();  // No texture shows them.
  if (lower_case_extension(path) == ".obj") flip_tex_coords(file.mesh);
  shape.geometry = std::move(file.mesh);
  scene.shapes.push_back(std::move(shape));
  scene.camera = camera_framing(bounds(scene));
  return scene;
}

}  // namespace

LoadedScene load_scene(const std::string& path, const LoadOptions& options) {
  std::optional<ConfinedReads> confined;
  if (!options.root.empty()) confined.emplace(options.root);
  Diagnostics diagnostics(options.strict);
  diagnostics.opened(path);
  Scene scene;
  try {
    scene = is_mesh_path(path) ? scene_of_mesh(path, options, diagnostics) : scene_of_xml(path, options, diagnostics);
  } catch (const SceneError& fault) {
    diagnostics.append(fault.diagnostics());
  }
  if (!diagnostics.has_errors()) diagnostics.append(validate(scene));
  if (diagnostics.has_errors()) throw SceneError(diagnostics.in_file_order());
  scene.name = std::filesystem::path(path).stem().string();
  scene.files = diagnostics.files();
  return {std::move(scene), diagnostics.in_file_order()};
}

}  // namespace strahl

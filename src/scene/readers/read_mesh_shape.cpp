// SPDX-License-Identifier: MIT
// <shape type="obj">, <shape type="ply"> and <shape type="serialized">: a mesh file in the world frame, with the
// materials that it names.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scene/meshes/creased_normals.h"
#include "scene/meshes/material_warnings.h"
#include "scene/meshes/mesh_file.h"
#include "scene/meshes/vertex_normals.h"
#include "scene/readers/mesh_import.h"
#include "scene/readers/shape_reader.h"
#include "scene/unseen.h"

namespace strahl {

namespace {

/// Which of the meshes of a file.
int shape_index(Properties& properties) {
  return properties.integer_in("shape_index", 0, std::numeric_limits<int>::max()).value_or(0);
}

/// Of Mitsuba 0.x, in degrees: new normals, smooth where triangles are at most this far from each other.
std::optional<double> max_smooth_angle(Properties& properties) {
  const std::optional<double> degrees = properties.number("max_smooth_angle");
  if (!degrees || (*degrees >= 0 && *degrees <= 180)) return degrees;
  properties.diagnostics().error(properties.where("max_smooth_angle"), "max_smooth_angle must lie between 0 and 180");
  return std::nullopt;
}

void to_world(Mesh& mesh, const Transform& world_from_object) {
  for (Vec3& p : mesh.positions) p = world_from_object.point(p);
  for (Vec3& n : mesh.normals) {
    const Vec3 turned = world_from_object.normal(n);
    if (turned != Vec3{}) n = normalized(turned);
  }
}

/// Where the file does not have the name of the only <bsdf>, that is the shape's, as those of Mitsuba 3 are, whatever
/// their names.
void take_only_material(ShapeInput& input, const MeshFile& file) {
  if (input.has_material || input.named_materials.size() != 1) return;
  const NamedMaterial& only = input.named_materials.front();
  if (std::ranges::find(file.materials, only.name, &MeshMaterial::name) != file.materials.end()) return;
  input.shape.material = only.material;
  input.has_material = true;
  input.named_materials.clear();
}

GivenMaterials given_materials(const ShapeInput& input, const MeshFile& file, bool loads_materials) {
  GivenMaterials given{input.has_material || !loads_materials, {}};
  for (const NamedMaterial& named : input.named_materials) {
    if (std::ranges::find(file.materials, named.name, &MeshMaterial::name) == file.materials.end())
      input.builder.diagnostics.unknown(
          named.where, fmt::format("no face of the file has the material \"{}\"; this <bsdf> is left out", named.name));
    given.by_name[named.name] = named.material;
  }
  return given;
}

std::vector<Diagnostic> material_warnings_beside(const GivenMaterials& given, const MeshFile& file,
                                                 const Shape& shape) {
  const std::string fate = emits(shape, nullptr) ? "they are black, as the shape shines"
                           : has_stand_in(shape) ? "they let all light pass, as the shape bounds media"
                                                 : "they become the default diffuse";
  return material_warnings(
      file, [&](const std::string& name) { return given.by_name.contains(name); }, fate);
}

/// In a shapegroup nothing shines.
void drop_light_of_file(const ShapeInput& input, Mesh& mesh) {
  if (!input.builder.is_in_group || emits(input.shape, nullptr) || !emits(input.shape, &mesh)) return;
  for (MeshPart& part : mesh.parts) part.radiance.reset();
  input.builder.diagnostics.warning(input.properties.where(),
                                    "the light of the file's materials (Ke) is left out, as nothing in a shapegroup "
                                    "shines; place the shape outside to have it");
}

/// As in Mitsuba, light goes where the vertex normals point. They also say what is outside of glass, and where such
/// bodies overlap, or media are within them, the triangles must say the same.
bool goes_by_vertex_normals(const ShapeInput& input, const Mesh& mesh) {
  return emits(input.shape, &mesh) || (input.shape.priority && has_glass(input.shape, &mesh, input.builder.scene));
}

}  // namespace

Geometry read_geometry(ShapeInput& input, const Mesh&) {
  Properties& properties = input.properties;
  Diagnostics& diagnostics = input.builder.diagnostics;
  const std::optional<bool> given_face_normals = properties.boolean("face_normals");
  const bool face_normals = given_face_normals.value_or(false);
  // Written by the upgrade from 0.x.
  const bool obeys_file =
      properties.type() == "serialized" && properties.has_old_rule("obeys_file_on_face_normals") && !given_face_normals;
  const std::optional<double> smooth_angle = max_smooth_angle(properties);
  const bool flip_v = properties.boolean("flip_tex_coords").value_or(properties.type() == "obj");
  const int index = properties.type() == "serialized" ? shape_index(properties) : 0;
  // Of Mitsuba 0.x.
  const bool loads_materials = properties.type() != "obj" || properties.boolean("load_materials").value_or(true);
  const MeshNormals normals = face_normals || smooth_angle ? MeshNormals::unused
                              : obeys_file                 ? MeshNormals::as_file_says
                                                           : MeshNormals::used;
  const std::optional<std::string> path = data_path(input, properties.type());
  if (!path) return Mesh{};
  diagnostics.opened(*path);
  try {
    const MeshProgress progress = progress_of(*path, input.builder.mesh_progress);
    MeshFile file = properties.type() == "serialized" ? read_serialized(*path, index, progress, normals)
                                                      : read_mesh(*path, progress, normals);
    for (const std::string& library : file.libraries) diagnostics.opened(library);
    diagnostics.append(file.warnings);
    for (AttributeFault& fault : file.attribute_faults) input.builder.attribute_faults.push_back(std::move(fault));
    take_only_material(input, file);
    const GivenMaterials given = given_materials(input, file, loads_materials);
    if (!given.of_shape) diagnostics.append(material_warnings_beside(given, file, input.shape));
    if (file.mesh.triangles.empty())
      diagnostics.error(properties.where("filename"), fmt::format("\"{}\" has no triangles", *path));
    add_mesh_materials(file, given, input.shape, input.builder.scene, input.builder.images, diagnostics);
    drop_light_of_file(input, file.mesh);
    if (face_normals) file.mesh.normals.clear();
    if (flip_v) flip_tex_coords(file.mesh);
    to_world(file.mesh, input.world_from_object);
    if (smooth_angle && !face_normals)
      make_creased_normals(file.mesh, *smooth_angle);
    else if (file.mesh.normals.empty() && !face_normals && !(obeys_file && file.face_normals))
      make_vertex_normals(file.mesh);
    else if (!file.mesh.normals.empty() && goes_by_vertex_normals(input, file.mesh) &&
             turn_to_vertex_normals(file.mesh))
      input.shape.flip_normals = !input.shape.flip_normals;
    return std::move(file.mesh);
  } catch (const EmptyMeshError&) {
    diagnostics.unknown(properties.where("filename"),
                        fmt::format("\"{}\" has no triangle with an area; the shape is left out", *path));
    input.is_left_out = true;
    return Mesh{};
  } catch (const SceneError& fault) {
    for (Diagnostic problem : fault.diagnostics()) {
      if (problem.severity == Severity::error)
        problem.message += fmt::format(" (read for {})", properties.where("filename").text());
      diagnostics.append({problem});
    }
    return Mesh{};
  }
}

}  // namespace strahl

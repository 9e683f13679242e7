// SPDX-License-Identifier: MIT
// Triangle meshes.
#include <algorithm>
#include <cmath>

#include "kinds/rates_of_edges.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

namespace {

void check_parts(Faults& faults, const Mesh& mesh) {
  if (mesh.parts.empty()) return;
  faults.require(mesh.part_of_triangle.size() == mesh.triangles.size(),
                 "part_of_triangle must name a part for every triangle");
  const auto is_part = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < mesh.parts.size(); };
  faults.require(std::all_of(mesh.part_of_triangle.begin(), mesh.part_of_triangle.end(), is_part),
                 "part_of_triangle has an index out of range");
}

}  // namespace

int primitive_count(const Mesh& mesh) { return static_cast<int>(mesh.triangles.size()); }

void extend(Extent& extent, const Mesh& mesh) {
  for (const Vec3& p : mesh.positions) extent.add(p);
}

void check(Faults& faults, const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  faults.require(!mesh.triangles.empty(), "the mesh has no triangles");
  faults.require(std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite), "all positions must be finite");
  faults.require(std::all_of(mesh.normals.begin(), mesh.normals.end(), is_finite), "all normals must be finite");
  faults.require(mesh.normals.empty() || mesh.normals.size() == vertices,
                 "a mesh has a normal for every vertex or none");
  faults.require(mesh.uvs.empty() || mesh.uvs.size() == vertices,
                 "a mesh has texture coordinates for every vertex or none");
  const auto is_vertex = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < vertices; };
  const auto fits = [&](const std::array<int, 3>& t) { return std::all_of(t.begin(), t.end(), is_vertex); };
  const auto outside = std::find_if_not(mesh.triangles.begin(), mesh.triangles.end(), fits);
  faults.require(outside == mesh.triangles.end(), "triangle {} has a vertex index out of range",
                 outside - mesh.triangles.begin());
  check_parts(faults, mesh);
  for (const MeshAttribute& attribute : mesh.attributes) {
    const std::size_t count = attribute.is_of_faces() ? mesh.triangles.size() : vertices;
    faults.require(attribute.values.size() == count, "attribute {} has {} values, not {}", attribute.name,
                   attribute.values.size(), count);
    faults.require(std::all_of(attribute.values.begin(), attribute.values.end(),
                               [](const Rgb& c) { return std::isfinite(c.r + c.g + c.b); }),
                   "attribute {} must be finite", attribute.name);
  }
  faults.require(mesh.attributes.empty() || mesh.parts.empty(), "a mesh with parts has no attributes");
}

void pack(const Planes& to, const Mesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    PrimitivePlanes planes = to.primitive();
    for (const int i : triangle) planes.point(mesh.positions[static_cast<std::size_t>(i)]);
    to.put(planes);
  }
}

bool faces_inward(const Mesh&) { return false; }

std::optional<std::array<double, 9>> surface_frame(const Mesh&, const UploadFrame&) { return std::nullopt; }

void emit(AreaItems& items, const Mesh& mesh, int part) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!mesh.parts.empty() && mesh.part_of_triangle[i] != part) continue;
    const auto corner = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(mesh.triangles[i][k])]; };
    for (std::size_t k = 0; k < 3; ++k) items.extent().add(corner(k));
    items.flat(corner(0), corner(1) - corner(0), corner(2) - corner(0), 0.5);
    if (mesh.uvs.empty()) continue;
    const auto uv = [&](std::size_t k) { return mesh.uvs[static_cast<std::size_t>(mesh.triangles[i][k])]; };
    items.map(uv(0), uv(1), uv(2));
  }
}

int first_of_area(const Mesh& mesh, int) { return mesh.parts.empty() ? 0 : -1; }

Vec2 uv_rates(const Mesh& mesh) {
  double u = 0, v = 0, count = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    const Vec2 edges =
        rates_of_edges(mesh.positions[at(b)] - mesh.positions[at(a)], mesh.positions[at(c)] - mesh.positions[at(a)]);
    Vec2 along_b{1, 0}, along_c{0, 1};
    if (!mesh.uvs.empty()) {
      along_b = {mesh.uvs[at(b)].x - mesh.uvs[at(a)].x, mesh.uvs[at(b)].y - mesh.uvs[at(a)].y};
      along_c = {mesh.uvs[at(c)].x - mesh.uvs[at(a)].x, mesh.uvs[at(c)].y - mesh.uvs[at(a)].y};
    }
    u += std::hypot(along_b.x * edges.x, along_c.x * edges.y);
    v += std::hypot(along_b.y * edges.x, along_c.y * edges.y);
    ++count;
  }
  return count > 0 ? Vec2{u / count, v / count} : Vec2{};
}

void move(Mesh& mesh, const MapVec3& point, const MapVec3&) {
  for (Vec3& p : mesh.positions) p = point(p);
}

void scale(Mesh&, double) {}

/// Negates the vertex normals, because mirroring negates the face normals and flip_normals turns both back.
Mirrored mirror(Mesh& mesh, const MapVec3& flip_x) {
  for (Vec3& normal : mesh.normals) normal = -flip_x(normal);
  return Mirrored::flipped;
}

}  // namespace strahl::kinds

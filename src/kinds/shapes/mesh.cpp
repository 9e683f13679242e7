// SPDX-License-Identifier: MIT
// Triangle meshes.
#include <algorithm>
#include <cmath>
#include <limits>

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
  const auto is_whole = [](const Vec3& v) { return is_finite(v); };
  faults.require(std::ranges::all_of(mesh.positions, is_whole), "all positions must be finite");
  faults.require(std::ranges::all_of(mesh.normals, is_whole), "all normals must be finite");
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

void emit(AreaItems& items, const Mesh& mesh, Primitives primitives) {
  for (const int primitive : primitives) {
    const std::array<int, 3>& triangle = mesh.triangles[static_cast<std::size_t>(primitive)];
    const auto corner = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(triangle.at(k))]; };
    for (std::size_t k = 0; k < 3; ++k) items.extent().add(corner(k));
    items.flat(corner(0), corner(1) - corner(0), corner(2) - corner(0), 0.5);
    if (mesh.uvs.empty()) continue;
    const auto uv = [&](std::size_t k) { return mesh.uvs[static_cast<std::size_t>(triangle.at(k))]; };
    items.map(uv(0), uv(1), uv(2));
  }
}

int first_of_area(const Mesh& mesh, int, bool) { return mesh.parts.empty() ? 0 : -1; }

namespace {

/// Of the lengths that are not 0, infinity where there are none. Triangles with one coordinate at all corners are often
/// those that nobody mapped.
struct LeastRate {
  double value = std::numeric_limits<double>::infinity();

  void add(double rate) {
    if (rate > 0) value = std::min(value, rate);
  }
  [[nodiscard]] double or_none() const { return std::isfinite(value) ? value : 0; }
};

}  // namespace

/// The lengths of the gradients of u and v over each triangle.
Vec2 uv_rates(const Mesh& mesh) {
  LeastRate u, v;
  for (const auto& triangle : mesh.triangles) {
    const auto at = [&](std::size_t k) { return static_cast<std::size_t>(triangle.at(k)); };
    const Vec3 to_b = mesh.positions[at(1)] - mesh.positions[at(0)];
    const Vec3 to_c = mesh.positions[at(2)] - mesh.positions[at(0)];
    const double area = length(cross(to_b, to_c));
    if (!(area > 0)) continue;
    Vec2 along_b{1, 0}, along_c{0, 1};
    if (!mesh.uvs.empty()) {
      const Vec2 a = mesh.uvs[at(0)], b = mesh.uvs[at(1)], c = mesh.uvs[at(2)];
      along_b = {b.x - a.x, b.y - a.y};
      along_c = {c.x - a.x, c.y - a.y};
    }
    u.add(length(along_b.x * to_c - along_c.x * to_b) / area);
    v.add(length(along_b.y * to_c - along_c.y * to_b) / area);
  }
  return {u.or_none(), v.or_none()};
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

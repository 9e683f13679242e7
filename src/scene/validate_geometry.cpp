// SPDX-License-Identifier: MIT
// Invariants shape by shape. Frames may be off by what a chain of a few operations in double rounds.
#include "scene/validate_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace strahl {

namespace {

constexpr double frame_tolerance = 0x1p-40;  // some thousand roundings of 2^-53: no chain of rotations is longer

constexpr double smallest_normal = std::numeric_limits<double>::min();

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
bool is_zero(double x) { return std::abs(x) <= frame_tolerance; }
bool is_unit(const Vec3& v) { return is_zero(length(v) - 1); }
bool is_degenerate(const Vec3& a, const Vec3& b) { return cross(a, b) == Vec3{}; }

class Faults {
 public:
  void operator()(const Sphere& s) {
    require(is_finite(s.center), "the center must be finite");
    require_radius(s.radius);
    require_orthonormal(s.frame);
  }
  void operator()(const Plane& p) {
    require(is_finite(p.point) && is_finite(p.u) && is_finite(p.v), "the plane must be finite");
    require(is_finite(p.normal) && p.normal != Vec3{}, "the normal must be finite and not zero");
    require(!is_finite(p.normal) || p.normal == Vec3{} || largest(p.normal) >= smallest_normal,
            "the normal's length is {:.3g}; below {:.3g} numbers lose their digits: give it a length near 1",
            largest(p.normal), smallest_normal);
    require(!is_degenerate(p.u, p.v), "u and v must span the plane");
  }
  void operator()(const Box& b) {
    require(is_finite(b.min) && is_finite(b.max), "the box must be finite");
    require(b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z, "min must not be greater than max");
  }
  void operator()(const Triangle& t) {
    require(is_finite(t.p0) && is_finite(t.p1) && is_finite(t.p2), "the corners must be finite");
    require(!is_degenerate(t.p1 - t.p0, t.p2 - t.p0), "the triangle's corners lie on a line; its normal is zero");
  }
  void operator()(const Rectangle& r) {
    require(is_finite(r.corner) && is_finite(r.edge_u) && is_finite(r.edge_v), "the rectangle must be finite");
    require(!is_degenerate(r.edge_u, r.edge_v), "the rectangle's edges must span an area");
  }
  void operator()(const Cube& c) {
    const auto& [x, y, z] = c.edge;
    require(is_finite(c.corner) && is_finite(x) && is_finite(y) && is_finite(z), "the cube must be finite");
    const bool has_zero = x == Vec3{} || y == Vec3{} || z == Vec3{};
    require(!has_zero && dot(normalized(x), cross(normalized(y), normalized(z))) != 0,
            "the cube's edges must span a volume");
  }
  void operator()(const Disk& d) {
    require(is_finite(d.center) && is_finite(d.axis_u) && is_finite(d.axis_v), "the disk must be finite");
    const double u = length(d.axis_u), v = length(d.axis_v);
    require(u > 0 && v > 0 && is_zero((u - v) / u) && is_zero(dot(normalized(d.axis_u), normalized(d.axis_v))),
            "the disk's axes must be perpendicular, equally long and not zero");
    require(!(u > 0 && v > 0) || !is_degenerate(d.axis_u, d.axis_v), "the disk's axes must span an area");
  }
  void operator()(const Cylinder& c) {
    require(is_finite(c.p0) && is_finite(c.p1), "p0 and p1 must be finite");
    require_radius(c.radius);
    require(c.p0 != c.p1, "p0 and p1 must differ");
    require(is_unit(c.reference) && (c.p0 == c.p1 || is_zero(dot(c.reference, normalized(c.p1 - c.p0)))),
            "the reference must be a unit vector perpendicular to the axis");
  }
  void operator()(const Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    require(!mesh.triangles.empty(), "the mesh has no triangles");
    require(std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite), "all positions must be finite");
    require(std::all_of(mesh.normals.begin(), mesh.normals.end(), is_finite), "all normals must be finite");
    require(mesh.normals.empty() || mesh.normals.size() == vertices, "a mesh has a normal for every vertex or none");
    require(mesh.uvs.empty() || mesh.uvs.size() == vertices, "a mesh has texture coordinates for every vertex or none");
    const auto is_vertex = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < vertices; };
    const auto fits = [&](const std::array<int, 3>& t) { return std::all_of(t.begin(), t.end(), is_vertex); };
    const auto outside = std::find_if_not(mesh.triangles.begin(), mesh.triangles.end(), fits);
    require(outside == mesh.triangles.end(), "triangle {} has a vertex index out of range",
            outside - mesh.triangles.begin());
    require_parts(mesh);
  }

  void operator()(const SphereCloud& cloud) {
    require(!cloud.spheres.empty(), "the cloud has no spheres");
    const auto is_sound = [](const SphereCloud::Ball& ball) {
      return is_finite(ball.center) && std::isfinite(ball.radius) && ball.radius > 0;
    };
    const auto fault = std::find_if_not(cloud.spheres.begin(), cloud.spheres.end(), is_sound);
    require(fault == cloud.spheres.end(), "sphere {} must have a finite center and a finite radius > 0",
            fault - cloud.spheres.begin());
    require_orthonormal(cloud.frame);
  }

  [[nodiscard]] std::vector<std::string> take() { return std::move(faults_); }

 private:
  template <typename... Values>
  void require(bool holds, fmt::format_string<Values...> fault, Values&&... values) {
    if (!holds) faults_.push_back(fmt::format(fault, std::forward<Values>(values)...));
  }
  void require_radius(double radius) {
    require(std::isfinite(radius) && radius > 0, "the radius is {}; it must be finite and > 0", radius);
  }
  void require_orthonormal(const std::array<Vec3, 3>& frame) {
    const auto& [x, y, z] = frame;
    require(is_unit(x) && is_unit(y) && is_unit(z) && is_zero(dot(x, y)) && is_zero(dot(y, z)) && is_zero(dot(z, x)),
            "the sphere's frame must be orthonormal");
  }
  void require_parts(const Mesh& mesh) {
    if (mesh.parts.empty()) return;
    require(mesh.part_of_triangle.size() == mesh.triangles.size(),
            "part_of_triangle must name a part for every triangle");
    const auto is_part = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < mesh.parts.size(); };
    require(std::all_of(mesh.part_of_triangle.begin(), mesh.part_of_triangle.end(), is_part),
            "part_of_triangle has an index out of range");
  }

  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> geometry_faults(const Geometry& geometry) {
  Faults faults;
  std::visit(faults, geometry);
  return faults.take();
}

}  // namespace strahl

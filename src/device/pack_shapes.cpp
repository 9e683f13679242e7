// SPDX-License-Identifier: MIT
#include "device/pack_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace strahl {
namespace {

/// By a power of two to a length near 1: the length of a normal means nothing, and products with it stay in range.
Vec3 near_unit(const Vec3& normal) {
  const double size = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  if (!(size > 0) || !std::isfinite(size)) return normal;
  // Component by component: the power itself overflows where the size is subnormal.
  const int exponent = -std::ilogb(size);
  return {std::scalbn(normal.x, exponent), std::scalbn(normal.y, exponent), std::scalbn(normal.z, exponent)};
}

/// Collects planes; points and lengths move into the frame, everything else stays.
struct Planes {
  const Frame& frame;
  std::array<double, 12> values{};
  std::size_t size = 0;

  Planes& number(double x) {
    values[size++] = x;
    return *this;
  }
  Planes& vector(const Vec3& v) { return number(v.x).number(v.y).number(v.z); }
  Planes& point(const Vec3& p) { return vector(frame.point(p)); }
  Planes& length(double x) { return number(frame.scale * x); }
  [[nodiscard]] std::span<const double> span() const { return {values.data(), size}; }
};

void parallelogram(const Frame& frame, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                   const PrimitiveSink& sink) {
  sink(Planes{frame}.point(a).point(b).point(c).point(d).span());
}

/// Faces -x, +x, -y, +y, -z, +z of the cube's own axes, normals outward where those are right-handed (faces_inward).
/// Corners are computed once, so that faces share them to the bit.
void cube_faces(const Cube& cube, const Frame& frame, const PrimitiveSink& sink) {
  std::array<Vec3, 8> corner;
  for (unsigned i = 0; i < 8; ++i) {
    Vec3 p = cube.corner;
    for (unsigned axis = 0; axis < 3; ++axis)
      if ((i >> axis) & 1u) p = p + cube.edge[axis];
    corner[i] = p;
  }
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned u = 1u << ((axis + 1) % 3), v = 1u << ((axis + 2) % 3);
    for (unsigned side = 0; side < 2; ++side) {
      const unsigned base = side << axis;
      const unsigned first = side == 1 ? u : v, second = side == 1 ? v : u;
      parallelogram(frame, corner[base], corner[base | first], corner[base | u | v], corner[base | second], sink);
    }
  }
}

struct Packer {
  const Frame& frame;
  const PrimitiveSink& sink;

  void operator()(const Sphere& s) const { sink(Planes{frame}.point(s.center).length(s.radius).span()); }
  void operator()(const Plane& p) const { sink(Planes{frame}.point(anchor(p)).vector(near_unit(p.normal)).span()); }
  void operator()(const Box& b) const {
    const Vec3 lo = frame.point(b.min), hi = frame.point(b.max);
    sink(Planes{frame}.number(lo.x).number(hi.x).number(lo.y).number(hi.y).number(lo.z).number(hi.z).span());
  }
  void operator()(const Triangle& t) const { sink(Planes{frame}.point(t.p0).point(t.p1).point(t.p2).span()); }
  void operator()(const Rectangle& r) const {
    parallelogram(frame, r.corner, r.corner + r.edge_u, r.corner + r.edge_u + r.edge_v, r.corner + r.edge_v, sink);
  }
  void operator()(const Cube& c) const { cube_faces(c, frame, sink); }
  void operator()(const Disk& d) const {
    const Vec3 u = frame.vector(d.axis_u);
    sink(Planes{frame}.point(d.center).vector(near_unit(cross(d.axis_u, d.axis_v))).number(dot(u, u)).span());
  }
  void operator()(const Cylinder& c) const {
    const Vec3 axis = c.p1 - c.p0;
    sink(Planes{frame}.point(c.p0).vector(normalized(axis)).length(strahl::length(axis)).length(c.radius).span());
  }
  void operator()(const Mesh& mesh) const {
    for (const auto& triangle : mesh.triangles) {
      Planes planes{frame};
      for (const int i : triangle) planes.point(mesh.positions[static_cast<std::size_t>(i)]);
      sink(planes.span());
    }
  }

  void operator()(const SphereCloud& cloud) const {
    for (const auto& [center, radius] : cloud.spheres) sink(Planes{frame}.point(center).length(radius).span());
  }

  /// In a shifted frame the plane's point nearest the frame's origin: cancellation happens here, in double. In the
  /// world frame the point as given, which may be exactly representable.
  [[nodiscard]] Vec3 anchor(const Plane& p) const {
    if (frame.origin == Vec3{}) return p.point;
    const Vec3 n = normalized(p.normal);
    return frame.origin + dot(n, p.point - frame.origin) * n;
  }
};

std::array<double, 9> nine(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
}

}  // namespace

int planes_of(const std::string& kind) {
  static const std::map<std::string, int> planes = {
#define SHAPE(name, count) {#name, count},
#include "../../cl/shapes/shapes.def"
#undef SHAPE
  };
  return planes.at(kind);
}

bool faces_inward(const Geometry& geometry) {
  const auto* cube = std::get_if<Cube>(&geometry);
  return cube && dot(cross(cube->edge[0], cube->edge[1]), cube->edge[2]) < 0;
}

void primitive_planes(const Geometry& geometry, const Frame& frame, const PrimitiveSink& sink) {
  std::visit(Packer{frame, sink}, geometry);
}

std::optional<std::array<double, 9>> surface_frame(const Geometry& geometry, const Frame& frame) {
  if (const auto* s = std::get_if<Sphere>(&geometry)) return nine(s->frame[0], s->frame[1], s->frame[2]);
  if (const auto* c = std::get_if<SphereCloud>(&geometry)) return nine(c->frame[0], c->frame[1], c->frame[2]);
  if (const auto* p = std::get_if<Plane>(&geometry)) {
    // Duals of u and v within the plane: dot with them gives the coordinates.
    const Vec3 u = frame.vector(p->u), v = frame.vector(p->v);
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
    const double inverse = 1 / (uu * vv - uv * uv);
    return nine(inverse * (vv * u - uv * v), inverse * (uu * v - uv * u), frame.point(p->point));
  }
  if (const auto* d = std::get_if<Disk>(&geometry)) {
    const Vec3 u = frame.vector(d->axis_u), v = frame.vector(d->axis_v);
    const double inverse = 1 / dot(u, u);
    return nine(inverse * u, inverse * v, {});
  }
  if (const auto* c = std::get_if<Cylinder>(&geometry))
    return nine(c->reference, cross(normalized(c->p1 - c->p0), c->reference), {});
  return std::nullopt;
}

}  // namespace strahl

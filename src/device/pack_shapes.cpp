// SPDX-License-Identifier: MIT
#include "device/pack_shapes.h"

#include <map>

namespace strahl {
namespace {

/// Collects planes; points move into the frame, everything else stays.
struct Planes {
  Vec3 origin;
  std::array<double, 12> values{};
  std::size_t size = 0;

  Planes& number(double x) {
    values[size++] = x;
    return *this;
  }
  Planes& vector(const Vec3& v) { return number(v.x).number(v.y).number(v.z); }
  Planes& point(const Vec3& p) { return vector(p - origin); }
  [[nodiscard]] std::span<const double> span() const { return {values.data(), size}; }
};

void parallelogram(const Vec3& origin, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                   const PrimitiveSink& sink) {
  sink(Planes{origin}.point(a).point(b).point(c).point(d).span());
}

/// Faces -x, +x, -y, +y, -z, +z of the cube's own axes, normals outward whatever the handedness. Corners are computed
/// once, so that faces share them to the bit.
void cube_faces(const Cube& cube, const Vec3& origin, const PrimitiveSink& sink) {
  std::array<Vec3, 8> corner;
  for (unsigned i = 0; i < 8; ++i) {
    Vec3 p = cube.corner;
    for (unsigned axis = 0; axis < 3; ++axis)
      if ((i >> axis) & 1u) p = p + cube.edge[axis];
    corner[i] = p;
  }
  const bool right_handed = dot(cross(cube.edge[0], cube.edge[1]), cube.edge[2]) >= 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned u = 1u << ((axis + 1) % 3), v = 1u << ((axis + 2) % 3);
    for (unsigned side = 0; side < 2; ++side) {
      const unsigned base = side << axis;
      const bool u_first = (side == 1) == right_handed;
      const unsigned first = u_first ? u : v, second = u_first ? v : u;
      parallelogram(origin, corner[base], corner[base | first], corner[base | u | v], corner[base | second], sink);
    }
  }
}

struct Packer {
  const Vec3& origin;
  const PrimitiveSink& sink;

  void operator()(const Sphere& s) const { sink(Planes{origin}.point(s.center).number(s.radius).span()); }
  void operator()(const Plane& p) const { sink(Planes{origin}.point(anchor(p)).vector(p.normal).span()); }
  void operator()(const Box& b) const {
    const Vec3 lo = b.min - origin, hi = b.max - origin;
    sink(Planes{origin}.number(lo.x).number(hi.x).number(lo.y).number(hi.y).number(lo.z).number(hi.z).span());
  }
  void operator()(const Triangle& t) const { sink(Planes{origin}.point(t.p0).point(t.p1).point(t.p2).span()); }
  void operator()(const Rectangle& r) const {
    parallelogram(origin, r.corner, r.corner + r.edge_u, r.corner + r.edge_u + r.edge_v, r.corner + r.edge_v, sink);
  }
  void operator()(const Cube& c) const { cube_faces(c, origin, sink); }
  void operator()(const Disk& d) const {
    sink(Planes{origin}.point(d.center).vector(cross(d.axis_u, d.axis_v)).number(dot(d.axis_u, d.axis_u)).span());
  }
  void operator()(const Cylinder& c) const {
    const Vec3 axis = c.p1 - c.p0;
    sink(Planes{origin}.point(c.p0).vector(normalized(axis)).number(length(axis)).number(c.radius).span());
  }
  void operator()(const Mesh& mesh) const {
    for (const auto& triangle : mesh.triangles) {
      Planes planes{origin};
      for (const int i : triangle) planes.point(mesh.positions[static_cast<std::size_t>(i)]);
      sink(planes.span());
    }
  }

  /// In a shifted frame the plane's point nearest the frame's origin: cancellation happens here, in double. In the
  /// world frame the point as given, which may be exactly representable.
  [[nodiscard]] Vec3 anchor(const Plane& p) const {
    if (origin == Vec3{}) return p.point;
    const Vec3 n = normalized(p.normal);
    return origin + dot(n, p.point - origin) * n;
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

void primitive_planes(const Geometry& geometry, const Vec3& frame_origin, const PrimitiveSink& sink) {
  std::visit(Packer{frame_origin, sink}, geometry);
}

std::optional<std::array<double, 9>> surface_frame(const Geometry& geometry, const Vec3& frame_origin) {
  if (const auto* s = std::get_if<Sphere>(&geometry)) return nine(s->frame[0], s->frame[1], s->frame[2]);
  if (const auto* p = std::get_if<Plane>(&geometry)) {
    // Duals of u and v within the plane: dot with them gives the coordinates.
    const double uu = dot(p->u, p->u), uv = dot(p->u, p->v), vv = dot(p->v, p->v);
    const double inverse = 1 / (uu * vv - uv * uv);
    return nine(inverse * (vv * p->u - uv * p->v), inverse * (uu * p->v - uv * p->u), p->point - frame_origin);
  }
  if (const auto* d = std::get_if<Disk>(&geometry)) {
    const double inverse = 1 / dot(d->axis_u, d->axis_u);
    return nine(inverse * d->axis_u, inverse * d->axis_v, {});
  }
  if (const auto* c = std::get_if<Cylinder>(&geometry))
    return nine(c->reference, cross(normalized(c->p1 - c->p0), c->reference), {});
  return std::nullopt;
}

}  // namespace strahl

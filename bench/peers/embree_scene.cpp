// SPDX-License-Identifier: MIT
#include "bench/peers/embree_scene.h"

#include <fmt/format.h>

#include <cstring>

#include "bench/peers/embree_solids.h"
#include "stopwatch.h"

namespace strahl::bench {
namespace {

/// Triangles or parallelograms without shared vertices, `corners` each.
struct Soup {
  std::size_t corners;
  std::vector<float> vertices;

  void add(const Vec3& p) {
    for (const double x : {p.x, p.y, p.z}) vertices.push_back(static_cast<float>(x));
  }
  void add_quad(const Vec3& corner, const Vec3& u, const Vec3& v) {
    for (const Vec3& p : {corner, corner + u, corner + u + v, corner + v}) add(p);
  }
};

float* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t stride, std::size_t count) {
  return static_cast<float*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count));
}

void attach(RTCScene scene, RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

void attach_polygons(RTCDevice device, RTCScene scene, const std::vector<float>& vertices,
                     const std::vector<unsigned>& indices, std::size_t corners) {
  if (indices.empty()) return;
  const bool quads = corners == 4;
  RTCGeometry geometry = rtcNewGeometry(device, quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE);
  std::memcpy(new_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 12, vertices.size() / 3), vertices.data(),
              vertices.size() * sizeof(float));
  std::memcpy(new_buffer(geometry, RTC_BUFFER_TYPE_INDEX, quads ? RTC_FORMAT_UINT4 : RTC_FORMAT_UINT3, 4 * corners,
                         indices.size() / corners),
              indices.data(), indices.size() * sizeof(unsigned));
  attach(scene, geometry);
}

void attach_soup(RTCDevice device, RTCScene scene, const Soup& soup) {
  std::vector<unsigned> indices(soup.vertices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<unsigned>(i);
  attach_polygons(device, scene, soup.vertices, indices, soup.corners);
}

void attach_mesh(RTCDevice device, RTCScene scene, const Mesh& mesh) {
  Soup vertices{3, {}};
  for (const Vec3& p : mesh.positions) vertices.add(p);
  std::vector<unsigned> indices;
  for (const auto& triangle : mesh.triangles)
    for (const int i : triangle) indices.push_back(static_cast<unsigned>(i));
  attach_polygons(device, scene, vertices.vertices, indices, 3);
}

void attach_points(RTCDevice device, RTCScene scene, const std::vector<EmbreeSphere>& spheres) {
  if (spheres.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  std::memcpy(new_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, spheres.size()), spheres.data(),
              spheres.size() * sizeof(EmbreeSphere));
  attach(scene, geometry);
}

/// Sorts a scene's shapes into what Embree has.
struct Sorter {
  EmbreeSolids& solids;
  Soup triangles, quads;
  std::vector<const Mesh*> meshes;

  void operator()(const Sphere& s) {
    const auto f = [](double x) { return static_cast<float>(x); };
    solids.spheres.push_back({f(s.center.x), f(s.center.y), f(s.center.z), f(s.radius)});
  }
  void operator()(const Plane& p) {
    EmbreePlane plane{};
    put(plane.point, p.point);
    put(plane.normal, p.normal);
    solids.planes.push_back(plane);
  }
  void operator()(const Box& b) {
    EmbreeBox box{};
    put(box.lo, b.min);
    put(box.hi, b.max);
    solids.boxes.push_back(box);
  }
  void operator()(const Triangle& t) {
    for (const Vec3& p : {t.p0, t.p1, t.p2}) triangles.add(p);
  }
  void operator()(const Rectangle& r) { quads.add_quad(r.corner, r.edge_u, r.edge_v); }
  void operator()(const Cube& c) {
    const auto& [a, b, d] = c.edge;
    const Vec3 far = c.corner + a + b + d;
    for (const auto& [u, v] : {std::pair{a, b}, {b, d}, {d, a}}) {
      quads.add_quad(c.corner, u, v);
      quads.add_quad(far, -u, -v);
    }
  }
  void operator()(const Mesh& mesh) { meshes.push_back(&mesh); }
  void operator()(const SphereCloud& cloud) {
    for (const auto& [center, radius] : cloud.spheres) (*this)(Sphere{center, radius});
  }
  template <typename Other>
  void operator()(const Other&) {
    throw Error("Embree is asked for spheres, planes, boxes, rectangles, cubes, triangles and meshes only");
  }

  static void put(float (&to)[3], const Vec3& v) {
    to[0] = static_cast<float>(v.x);
    to[1] = static_cast<float>(v.y);
    to[2] = static_cast<float>(v.z);
  }
};

}  // namespace

EmbreeScene::EmbreeScene(RTCDevice device, const Scene& scene, bool robust, bool points)
    : solids_(std::make_unique<EmbreeSolids>()), scene_(rtcNewScene(device)) {
  Sorter sorter{*solids_, {3, {}}, {4, {}}, {}};
  for (const Shape& shape : scene.shapes) std::visit(sorter, shape.geometry);
  RTCScene handle = scene_.get();
  if (robust) rtcSetSceneFlags(handle, RTC_SCENE_FLAG_ROBUST);
  if (points)
    attach_points(device, handle, solids_->spheres);
  else
    attach_solids(device, handle, solids_->spheres);
  attach_solids(device, handle, solids_->boxes);
  attach_solids(device, handle, solids_->planes);
  attach_soup(device, handle, sorter.triangles);
  attach_soup(device, handle, sorter.quads);
  for (const Mesh* mesh : sorter.meshes) attach_mesh(device, handle, *mesh);
  const Stopwatch start;
  rtcCommitScene(handle);
  build_seconds_ = start.seconds();
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    throw Error(fmt::format("Embree cannot build its tree: error {}", static_cast<int>(error)));
}

}  // namespace strahl::bench

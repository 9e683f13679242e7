// SPDX-License-Identifier: MIT
#include "bench/peers/embree_tree.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/peers/embree_scene.h"
#include "stopwatch.h"

namespace strahl::bench {
namespace {

/// Boxes of everything bounded, as single precision.
class Boxes {
 public:
  std::vector<RTCBuildPrimitive> all;

  void operator()(const Sphere& s) {
    const Vec3 r{s.radius, s.radius, s.radius};
    add({s.center - r, s.center + r});
  }
  void operator()(const Box& b) { add({b.min, b.max}); }
  void operator()(const Triangle& t) { add({t.p0, t.p1, t.p2}); }
  void operator()(const Rectangle& r) { parallelogram(r.corner, r.edge_u, r.edge_v); }
  void operator()(const Cube& c) {
    const auto& [u, v, w] = c.edge;
    for (const Vec3& corner : {c.corner, c.corner + u + v + w}) {
      const double way = corner == c.corner ? 1 : -1;
      parallelogram(corner, way * u, way * v);
      parallelogram(corner, way * v, way * w);
      parallelogram(corner, way * w, way * u);
    }
  }
  void operator()(const Mesh& mesh) {
    const auto at = [&mesh](int i) { return mesh.positions[static_cast<std::size_t>(i)]; };
    for (const auto& [a, b, c] : mesh.triangles) add({at(a), at(b), at(c)});
  }
  void operator()(const Plane&) {}
  void operator()(const SphereCloud& cloud) {
    for (const auto& [center, radius] : cloud.spheres) (*this)(Sphere{center, radius});
  }
  template <typename Other>
  void operator()(const Other&) {
    throw Error("Embree's builder is given spheres, boxes, rectangles, cubes, triangles and meshes only");
  }

 private:
  void parallelogram(const Vec3& corner, const Vec3& u, const Vec3& v) {
    add({corner, corner + u, corner + v, corner + u + v});
  }
  void add(std::initializer_list<Vec3> points) {
    constexpr float big = std::numeric_limits<float>::max();
    RTCBuildPrimitive box{big, big, big, 0, -big, -big, -big, static_cast<unsigned>(all.size())};
    for (const Vec3& p : points) {
      const float x = static_cast<float>(p.x), y = static_cast<float>(p.y), z = static_cast<float>(p.z);
      box.lower_x = std::min(box.lower_x, x);
      box.lower_y = std::min(box.lower_y, y);
      box.lower_z = std::min(box.lower_z, z);
      box.upper_x = std::max(box.upper_x, x);
      box.upper_y = std::max(box.upper_y, y);
      box.upper_z = std::max(box.upper_z, z);
    }
    all.push_back(box);
  }
};

struct Node {
  Node* children[2] = {nullptr, nullptr};
  RTCBounds bounds[2] = {};
  std::size_t primitives = 0;  ///< Of a leaf.
};

double half_area(const RTCBounds& b) {
  const double x = double{b.upper_x} - b.lower_x, y = double{b.upper_y} - b.lower_y, z = double{b.upper_z} - b.lower_z;
  return x * y + y * z + z * x;
}

double cost_below(const Node& node, unsigned block, double area, double root_area) {
  const double share = area / root_area;
  if (node.children[0] == nullptr) return share * std::ceil(static_cast<double>(node.primitives) / block);
  return share + cost_below(*node.children[0], block, half_area(node.bounds[0]), root_area) +
         cost_below(*node.children[1], block, half_area(node.bounds[1]), root_area);
}

RTCBuildArguments arguments_for(std::vector<RTCBuildPrimitive>& boxes, RTCBVH bvh, bool high, unsigned block) {
  RTCBuildArguments a = rtcDefaultBuildArguments();
  a.buildQuality = high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
  a.maxDepth = 1024;
  a.sahBlockSize = a.maxLeafSize = block;
  a.bvh = bvh;
  a.primitives = boxes.data();
  a.primitiveCount = a.primitiveArrayCapacity = boxes.size();
  if (high) {
    boxes.resize(2 * boxes.size());
    a.primitives = boxes.data();
    a.primitiveArrayCapacity = boxes.size();
    a.splitPrimitive = [](const RTCBuildPrimitive* box, unsigned axis, float at, RTCBounds* left, RTCBounds* right,
                          void*) {
      *left = *right = {box->lower_x, box->lower_y, box->lower_z, 0, box->upper_x, box->upper_y, box->upper_z, 0};
      (&left->upper_x)[axis] = at;
      (&right->lower_x)[axis] = at;
    };
  }
  a.createNode = [](RTCThreadLocalAllocator allocator, unsigned, void*) -> void* {
    return new (rtcThreadLocalAlloc(allocator, sizeof(Node), 16)) Node;
  };
  a.createLeaf = [](RTCThreadLocalAllocator allocator, const RTCBuildPrimitive*, std::size_t count, void*) -> void* {
    Node* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(Node), 16)) Node;
    leaf->primitives = count;
    return leaf;
  };
  a.setNodeChildren = [](void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<Node*>(node)->children[i] = static_cast<Node*>(children[i]);
  };
  a.setNodeBounds = [](void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<Node*>(node)->bounds[i] = *bounds[i];
  };
  return a;
}

}  // namespace

PeerTree embree_tree(const Scene& scene, bool high, unsigned threads, unsigned block) {
  Boxes boxes;
  for (const Shape& shape : scene.shapes) std::visit(boxes, shape.geometry);
  if (boxes.all.empty()) throw Error("Embree's builder is given nothing bounded");
  RTCBounds root = {};
  {
    const auto fold = [&boxes](float RTCBuildPrimitive::*side, auto better) {
      float value = boxes.all.front().*side;
      for (const RTCBuildPrimitive& box : boxes.all) value = better(value, box.*side);
      return value;
    };
    const auto less = [](float a, float b) { return std::min(a, b); };
    const auto more = [](float a, float b) { return std::max(a, b); };
    root.lower_x = fold(&RTCBuildPrimitive::lower_x, less);
    root.lower_y = fold(&RTCBuildPrimitive::lower_y, less);
    root.lower_z = fold(&RTCBuildPrimitive::lower_z, less);
    root.upper_x = fold(&RTCBuildPrimitive::upper_x, more);
    root.upper_y = fold(&RTCBuildPrimitive::upper_y, more);
    root.upper_z = fold(&RTCBuildPrimitive::upper_z, more);
  }
  const EmbreeDevice device(rtcNewDevice(fmt::format("threads={}", threads).c_str()));
  if (device == nullptr) throw Error("Embree does not start");
  RTCBVH bvh = rtcNewBVH(device.get());
  const RTCBuildArguments arguments = arguments_for(boxes.all, bvh, high, block);
  const Stopwatch start;
  const auto* top = static_cast<const Node*>(rtcBuildBVH(&arguments));
  PeerTree tree{start.seconds(), 0};
  if (top != nullptr) tree.sah_cost = cost_below(*top, block, half_area(root), half_area(root));
  rtcReleaseBVH(bvh);
  if (top == nullptr) throw Error("Embree builds no tree");
  return tree;
}

}  // namespace strahl::bench

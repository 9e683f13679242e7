// SPDX-License-Identifier: MIT
// Intersector's twins on the host: the same packing and the same headers, no device. HostTracer traces a scene;
// PrimitiveTracer asks one primitive alone, so tests can count every hit of a ray and try many single-shape cases
// without packing a scene for each.
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "cl/host_kernels.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "render/intersector.h"

namespace strahl::test {

template <class Real>
[[nodiscard]] PackedScene<Real> pack_for_host(Scene scene, int lanes,
                                              Acceleration acceleration = Acceleration::automatic) {
  scene.integrator.name = "emission";
  if (scene.materials.empty()) scene.materials.emplace_back();
  RenderSettings settings;
  settings.generic = true;
  return pack_scene<Real>(scene, features_of(scene, settings), {lanes, UploadFrame{}, 0, acceleration});
}

template <class Real>
[[nodiscard]] Hit trace_on_host(const PackedScene<Real>& scene, int lanes, const Ray& ray, std::int32_t left_id,
                                bool any_hit) {
  const std::int32_t left[layout::DEPARTED_INTS] = {left_id, ray.instance};
  const std::array<double, layout::RAY_REALS> values{ray.origin.x,    ray.origin.y,    ray.origin.z, ray.direction.x,
                                                     ray.direction.y, ray.direction.z, ray.t_min,    ray.t_max};
  std::array<Real, layout::RAY_REALS> reals;
  for (std::size_t i = 0; i < values.size(); ++i) reals[i] = static_cast<Real>(values[i]);
  std::array<Real, layout::HIT_REALS> out;
  std::array<std::int32_t, layout::HIT_INTS> ids;
  const HostBuffers<Real> buffers{scene.geometry.data(), scene.shading.data(), scene.index.data()};
  host_intersect(lanes, buffers, reals.data(), left, 1, any_hit, out.data(), ids.data());
  const auto real = [&](int i) { return static_cast<double>(out[static_cast<std::size_t>(i)]); };
  Hit hit;
  hit.t = real(layout::HIT_T);
  hit.u = real(layout::HIT_U);
  hit.v = real(layout::HIT_V);
  hit.normal = {real(layout::HIT_NORMAL), real(layout::HIT_NORMAL + 1), real(layout::HIT_NORMAL + 2)};
  hit.instance = ids[layout::HIT_INSTANCE];
  hit.shape = ids[layout::HIT_SHAPE];
  hit.primitive = ids[layout::HIT_PRIMITIVE];
  return hit;
}

/// Number in the scene of the first shape beside the instance, -1 for none: of its group, which follow the scene's own.
[[nodiscard]] inline std::size_t first_shape(const Scene& scene, int instance) {
  if (instance < 0) return 0;
  const int group = scene.instances.at(static_cast<std::size_t>(instance)).group;
  std::size_t first = scene.shapes.size();
  for (int before = 0; before < group; ++before) first += scene.groups[static_cast<std::size_t>(before)].shapes.size();
  return first;
}

/// Scene-wide id of the primitive that the ray has left, -1 for none.
[[nodiscard]] inline std::int32_t left_id(const Scene& scene, const std::vector<std::int64_t>& first_ids,
                                          const Ray& ray) {
  if (ray.shape < 0) return -1;
  const std::size_t shape = first_shape(scene, ray.instance) + static_cast<std::size_t>(ray.shape);
  return static_cast<std::int32_t>(first_ids.at(shape)) + ray.primitive;
}

template <class Real>
class HostTracer {
 public:
  HostTracer(const Scene& scene, int lanes)
      : scene_(scene), lanes_(lanes), first_ids_(first_ids(scene)), packed_(pack_for_host<Real>(scene, lanes)) {}

  [[nodiscard]] Hit trace(const Ray& ray, bool any_hit = false) const {
    Hit hit = trace_on_host(packed_, lanes_, ray, left_id(scene_, first_ids_, ray), any_hit);
    hit.shape -= static_cast<int>(first_shape(scene_, hit.instance));
    return hit;
  }
  [[nodiscard]] std::vector<Hit> trace(const std::vector<Ray>& rays, bool any_hit = false) const {
    std::vector<Hit> hits;
    hits.reserve(rays.size());
    for (const Ray& ray : rays) hits.push_back(trace(ray, any_hit));
    return hits;
  }

 private:
  Scene scene_;
  int lanes_;
  std::vector<std::int64_t> first_ids_;
  PackedScene<Real> packed_;
};

/// kind: an entry of cl/shapes/shapes.def; slot: a primitive of that kind, counted in scene order.
template <class Real>
class PrimitiveTracer {
 public:
  PrimitiveTracer(const Scene& scene, const std::string& kind)
      : scene_(scene), first_ids_(first_ids(scene)), packed_(pack_for_host<Real>(scene, 1, Acceleration::list)) {
    int at = layout::HEADER_INTS, row = -1;
    std::int32_t* index = packed_.index.data();
#define SHAPE(name, planes)                                                \
  if (kind == #name) {                                                     \
    row = at;                                                              \
    planes_ = planes;                                                      \
    size_ = static_cast<std::size_t>(index[at + layout::SHAPE_BLOCKS]);    \
  }                                                                        \
  index[at + layout::SHAPE_BLOCKS] = index[at + layout::SHAPE_LISTED] = 0; \
  at += layout::SHAPE_INTS;
#include "../../cl/shapes/shapes.def"
#undef SHAPE
    if (row < 0) throw std::logic_error("no kind of shape is called " + kind);
    row_ = static_cast<std::size_t>(row);
    geometry_ = static_cast<std::size_t>(index[row_ + layout::SHAPE_GEOMETRY]);
    // A list of one block has its id and its part side by side.
    const auto ids = static_cast<std::size_t>(index[row_ + layout::SHAPE_IDS]);
    pairs_ = packed_.index.size();
    for (std::size_t i = 0; i < size_; ++i)
      for (const std::size_t from : {ids + i, ids + size_ + i}) packed_.index.push_back(int{packed_.index[from]});
    packed_.index[row_ + layout::SHAPE_BLOCKS] = packed_.index[row_ + layout::SHAPE_LISTED] = 1;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// What the device holds of the primitive.
  [[nodiscard]] std::span<const Real> planes(std::size_t slot) const {
    return {packed_.geometry.data() + geometry_ + slot * planes_, planes_};
  }
  [[nodiscard]] Hit trace(std::size_t slot, const Ray& ray, bool any_hit = false) {
    packed_.index[row_ + layout::SHAPE_GEOMETRY] = static_cast<std::int32_t>(geometry_ + slot * planes_);
    packed_.index[row_ + layout::SHAPE_IDS] = static_cast<std::int32_t>(pairs_ + 2 * slot);
    return trace_on_host(packed_, 1, ray, left_id(scene_, first_ids_, ray), any_hit);
  }

 private:
  Scene scene_;
  std::vector<std::int64_t> first_ids_;
  PackedScene<Real> packed_;
  std::size_t planes_ = 0, size_ = 0, row_ = 0, geometry_ = 0, pairs_ = 0;
};

}  // namespace strahl::test

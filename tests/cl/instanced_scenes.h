// SPDX-License-Identifier: MIT
// Groups of every kind of shape that has bounds, placed in many ways; and the same scene without instances.
#pragma once

#include <cmath>
#include <utility>

#include "cl/mixed_scenes.h"
#include "scene/model/build.h"
#include "study/transformed.h"

namespace strahl::test {

inline Transform moved_by(const Vec3& by) {
  Transform transform;
  transform.m[0][3] = by.x;
  transform.m[1][3] = by.y;
  transform.m[2][3] = by.z;
  return transform;
}

/// Any affine map that distorts by a factor of a few at most, every other one mirrored.
inline Transform distorted(oracle::Random& random, int number) {
  for (;;) {
    Transform transform = moved_by({random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)});
    for (auto& row : transform.m)
      for (std::size_t i = 0; i < 3; ++i) row[i] = random.uniform(-1.5, 1.5);
    const double volume = transform.determinant();
    if (std::fabs(volume) > 0.4 && (volume < 0) == (number % 2 == 1)) return transform;
  }
}

inline Group group_of(const Scene& scene) {
  Group group;
  group.shapes = scene.shapes;
  return group;
}

/// Every shape of every instance as one of the scene itself, in the order that decides ties. Exact for translations;
/// for other maps only shapes with corners, all but boxes, stay what they are.
inline Scene flattened(const Scene& scene) {
  Scene flat = scene;
  flat.groups.clear();
  flat.instances.clear();
  for (const Instance& instance : scene.instances) {
    Scene placed;
    placed.shapes = scene.groups[static_cast<std::size_t>(instance.group)].shapes;
    const Transform& map = instance.world_from_group;
    placed = with_places(
        std::move(placed), [&](const Vec3& p) { return map.point(p); }, [&](const Vec3& v) { return map.vector(v); });
    flat.shapes.insert(flat.shapes.end(), placed.shapes.begin(), placed.shapes.end());
  }
  return flat;
}

/// The index that a hit's shape has in the flattened scene.
inline int flat_shape(const Scene& scene, const Hit& hit) {
  if (hit.instance < 0) return hit.shape;
  std::size_t first = scene.shapes.size();
  for (int before = 0; before < hit.instance; ++before)
    first +=
        scene.groups[static_cast<std::size_t>(scene.instances[static_cast<std::size_t>(before)].group)].shapes.size();
  return static_cast<int>(first) + hit.shape;
}

/// Some shapes, and groups of all kinds but planes that are placed `instances` times altogether.
class InstancedMaker {
 public:
  explicit InstancedMaker(std::uint64_t seed) : random_(seed), loose_(seed + 1), first_(seed + 2), second_(seed + 3) {}

  /// transform(number) places.
  template <class Place>
  Scene scene(int instances, const Place& transform, const std::vector<std::string>& names = geometry_names()) {
    for (const std::string& name : names) {
      loose_.add(name, 2);
      if (name == "plane") continue;
      first_.add(name, 3);
      second_.add(name, 1);
    }
    Scene scene = loose_.scene();
    add(scene, group_of(first_.scene()));
    add(scene, group_of(second_.scene()));
    for (int i = 0; i < instances; ++i) add_instance(scene, i % 3 == 2 ? 1 : 0, transform(i));
    scene_ = scene;
    return scene;
  }

  /// At the loose shapes, and into the instances.
  std::vector<Ray> rays(std::size_t count) {
    std::vector<Ray> rays = loose_.rays(count);
    const std::vector<Ray> at_first = first_.rays(count), at_second = second_.rays(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 8 == 0 || scene_.instances.empty()) continue;
      const Instance& instance = scene_.instances[random_.bits() % scene_.instances.size()];
      rays[i] = instance.group == 0 ? at_first[i] : at_second[i];
      rays[i].origin = instance.world_from_group.point(rays[i].origin);
      rays[i].direction = instance.world_from_group.vector(rays[i].direction);
    }
    return rays;
  }

  oracle::Random& random() { return random_; }

 private:
  oracle::Random random_;
  SceneMaker loose_, first_, second_;
  Scene scene_;
};

}  // namespace strahl::test

// SPDX-License-Identifier: MIT
// A scene as Embree has it.
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <type_traits>

#include "scene/model/scene.h"

namespace strahl::bench {

struct EmbreeRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using EmbreeDevice = std::unique_ptr<std::remove_pointer_t<RTCDevice>, EmbreeRelease>;

/// The solid shapes of a kind, as floats for a user geometry's callbacks. They must outlive the scene.
struct EmbreeSphere {
  float x, y, z, radius;
};
struct EmbreeBox {
  float lo[3], hi[3];
};
struct EmbreePlane {
  float point[3], normal[3];
};
struct EmbreeSolids {
  std::vector<EmbreeSphere> spheres;
  std::vector<EmbreeBox> boxes;
  std::vector<EmbreePlane> planes;
};

/// An Embree scene and what it points to.
class EmbreeScene {
 public:
  EmbreeScene(RTCDevice device, const Scene& scene, bool robust, bool points);
  [[nodiscard]] RTCScene handle() const { return scene_.get(); }
  [[nodiscard]] double build_seconds() const { return build_seconds_; }

 private:
  std::unique_ptr<EmbreeSolids> solids_;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, EmbreeRelease> scene_;
  double build_seconds_ = 0;
};

}  // namespace strahl::bench

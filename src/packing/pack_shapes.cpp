// SPDX-License-Identifier: MIT
#include "packing/pack_shapes.h"

#include <map>

#include "kinds/shapes.h"

namespace strahl {

int planes_of(const std::string& kind) {
  static const std::map<std::string, int> planes = {
#define SHAPE(name, count) {#name, count},
#include "../../cl/shapes/shapes.def"
#undef SHAPE
  };
  return planes.at(kind);
}

bool faces_inward(const Geometry& geometry) {
  return std::visit([](const auto& shape) { return kinds::faces_inward(shape); }, geometry);
}

void primitive_planes(const Geometry& geometry, const UploadFrame& frame, const PrimitiveSink& sink) {
  const kinds::Planes planes{frame, sink};
  std::visit([&](const auto& shape) { kinds::pack(planes, shape); }, geometry);
}

std::optional<std::array<double, 9>> surface_frame(const Geometry& geometry, const UploadFrame& frame) {
  return std::visit([&](const auto& shape) { return kinds::surface_frame(shape, frame); }, geometry);
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Shapes and lights of every kind that scenes may have, by the lists: one that is new is among them.
#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scene/model/scene.h"

namespace strahl::test {

inline Mesh small_mesh() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// Of each kind of primitives the shapes that are made of it.
inline const std::map<std::string, std::vector<Geometry>>& geometries() {
  static const std::map<std::string, std::vector<Geometry>> by_kind = [] {
    std::map<std::string, std::vector<Geometry>> made;
#define SHAPE_KIND(S, kind, area, types) made[#kind].emplace_back(S{});
#include "kinds/shapes.def"
#undef SHAPE_KIND
    for (auto& [kind, shapes] : made)
      for (Geometry& shape : shapes)
        if (std::holds_alternative<Mesh>(shape)) shape = small_mesh();
    return made;
  }();
  return by_kind;
}

/// One of each kind of light that is no shape.
inline auto every_emitter() {
  using Emitter = decltype(Light::emitter);
  return []<std::size_t... Place>(std::index_sequence<Place...>) {
    return std::array{Emitter(std::in_place_index<Place>)...};
  }
  (std::make_index_sequence<std::variant_size_v<Emitter>>{});
}

}  // namespace strahl::test

// SPDX-License-Identifier: MIT
// Spheres and polygons of a file in E. Haines' Neutral File Format, and its camera: what SPD's scenes are made of.
#pragma once

#include <fstream>
#include <sstream>

#include "scene/model/scene.h"
#include "study/generated/stage.h"

namespace strahl::test {

struct Nff {
  std::vector<Sphere> spheres;
  std::vector<std::vector<Vec3>> polygons;
  Vec3 from, at, up;
  double fov_degrees = 0;
  int resolution = 0;
};

/// Colours, lamps and materials are passed over.
inline Nff read_nff(const std::string& path) {
  std::ifstream file(path);
  Nff nff;
  const auto read = [&file](Vec3& v) { file >> v.x >> v.y >> v.z; };
  std::string word;
  while (file >> word) {
    if (word == "from") read(nff.from);
    if (word == "at") read(nff.at);
    if (word == "up") read(nff.up);
    if (word == "angle") file >> nff.fov_degrees;
    if (word == "resolution") file >> nff.resolution;
    if (word == "s") {
      Sphere& sphere = nff.spheres.emplace_back();
      read(sphere.center);
      file >> sphere.radius;
    }
    if (word == "p" || word == "pp") {
      std::size_t corners = 0;
      file >> corners;
      nff.polygons.emplace_back(corners);
      Vec3 normal;
      for (Vec3& corner : nff.polygons.back()) {
        read(corner);
        if (word == "pp") read(normal);
      }
    }
  }
  return nff;
}

}  // namespace strahl::test

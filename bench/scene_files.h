// SPDX-License-Identifier: MIT
// A scene as a file of strahl's or of another renderer's language: the same picture from each.
#pragma once

#include <string>

#include "scene/model/scene.h"

namespace strahl::bench {

/// By its suffix: .xml (Mitsuba's, meshes as binary PLY beside it), .pov (POV-Ray 3.7), .dat (Tachyon). Spheres,
/// planes, boxes, rectangles, triangles and meshes, the first material's grey everywhere, point lights, perspective
/// cameras. Throws UsageError for other suffixes, Error for what the language lacks.
void write_scene(const Scene& scene, const std::string& path);

/// As .xml, all spheres in one binary PLY beside it; a scene without meshes.
void write_scene_with_cloud(Scene scene, const std::string& path);

[[nodiscard]] std::string xml_text(const Scene& scene, const std::string& mesh_prefix);
[[nodiscard]] std::string povray_text(const Scene& scene);
[[nodiscard]] std::string tachyon_text(const Scene& scene);

/// Binary PLY, coordinates as floats.
[[nodiscard]] std::string ply_bytes(const Mesh& mesh);
[[nodiscard]] std::string sphere_ply_bytes(const std::vector<Sphere>& spheres);

/// What the writers read of a scene.
struct Looks {
  Vec3 eye, forward, right, up;  ///< Unit vectors.
  double tangent = 1;            ///< Of half the opening across the width.
  double aspect = 1;             ///< Height by width.
  double grey = 0.5;
};

/// Throws Error where the camera or the material is of another kind.
[[nodiscard]] Looks looks_of(const Scene& scene);

}  // namespace strahl::bench

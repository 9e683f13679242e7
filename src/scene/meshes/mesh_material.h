// SPDX-License-Identifier: MIT
// A material as an MTL file states it ("Object Files", Wavefront Advanced Visualizer manual, appendix B1).
#pragma once

#include <optional>
#include <string>

#include "errors.h"
#include "scene/model/vec.h"

namespace strahl {

/// An image of an MTL file: u' = scale u + offset, v likewise, both from the image's lower left corner.
struct MeshTexture {
  std::string file;  ///< Resolved; it may not exist.
  Vec2 scale{1, 1}, offset{0, 0};
  bool is_clamped = false;
  double multiplier = 1;  ///< -bm, of heights.
  SourceLocation where;
};

struct MeshMaterial {
  std::string name;
  bool is_defined = true;          ///< By a library; else a face has it that the file names none for, or ...
  SourceLocation where;            ///< ... one that no library defines, first used here.
  Rgb reflectance{0.5, 0.5, 0.5};  ///< Kd.
  std::optional<MeshTexture>
      reflectance_map;                     ///< map_Kd; multiplied by Kd, which is 1 where the file gives only the map.
  Rgb specular{0, 0, 0};                   ///< Ks.
  double exponent = 0;                     ///< Ns, of the highlight.
  int illumination = 2;                    ///< illum, 0 to 10.
  double index = 1.5;                      ///< Ni, of refraction.
  Rgb filter{1, 1, 1};                     ///< Tf.
  double opacity = 1;                      ///< d, or 1 - Tr.
  std::optional<MeshTexture> opacity_map;  ///< map_d.
  std::optional<MeshTexture> bump_map;     ///< map_Bump or bump: heights.
  std::optional<MeshTexture> normal_map;   ///< norm.
  std::optional<Rgb> radiance;             ///< Ke, where it is not black.
};

}  // namespace strahl

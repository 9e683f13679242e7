// SPDX-License-Identifier: MIT
// What the kernels draw places on an emitter from: its items (cl/areas) and a table that draws one in proportion to its
// area.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinds/area_items.h"
#include "kinds/light_reach.h"
#include "kinds/shapes.h"
#include "kinds/upload_frame.h"
#include "packing/choice_table.h"
#include "scene/model/scene.h"

namespace strahl {

/// In the frame's units.
struct EmittingArea {
  double size = 0;            ///< > 0.
  double side = 1;            ///< 1: emits outwards, -1: inwards (round shapes; flat ones turn their normal).
  std::vector<double> items;  ///< As the entry's file says.
  std::vector<Choice> choices;
  std::vector<double> uvs;  ///< LIGHT_UVS of cl/scene/layout.h; empty without a texture.
  LightReach reach;
};

/// The shape's primitive that the part's first item is, if the items are primitives in its order: then none is in the
/// way of itself. Else -1.
[[nodiscard]] int first_of_area(const Geometry& geometry, int part, bool shines_inwards);

/// Of one part of a shape, which has these primitives and emits `radiance` on the average; none where there is no area
/// to draw from.
[[nodiscard]] std::optional<EmittingArea> emitting_area(const Shape& shape, kinds::Primitives primitives,
                                                        const Rgb& radiance, kinds::UvSource uv_source,
                                                        const UploadFrame& frame);

}  // namespace strahl

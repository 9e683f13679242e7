// SPDX-License-Identifier: MIT
// Everything that the host needs of a kind of shape, in one place: a row of shapes.def and a file of shapes/ that
// defines the functions below. The compiler reports a missing row, the linker a missing function.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "kinds/area_items.h"
#include "kinds/bounds.h"
#include "kinds/extent.h"
#include "kinds/faults.h"
#include "kinds/map_vec3.h"
#include "kinds/planes.h"
#include "kinds/upload_frame.h"

namespace strahl::kinds {

/// Of a shape, by their numbers in it.
using Primitives = std::span<const int>;

/// Which way a mirrored shape's normals point.
enum class Mirrored {
  alike,
  flipped,  ///< To the other side, as a cross product does: flip_normals turns them back.
};

// NOLINTBEGIN(bugprone-macro-parentheses): S is a type.
#define SHAPE_KIND(S, kind, area, types)                                                      \
  int primitive_count(const S&);                                                              \
  /** Adds what bounds it, if anything does. */                                               \
  void extend(Extent&, const S&);                                                             \
  /** What must hold of its numbers. */                                                       \
  void check(Faults&, const S&);                                                              \
  /** Primitive after primitive, as its kind's block planes hold it. */                       \
  void pack(const Planes&, const S&);                                                         \
  /** As pack_shapes.h has it. */                                                             \
  bool faces_inward(const S&);                                                                \
  /** The nine reals that its kind's surface function calls its frame. */                     \
  std::optional<std::array<double, 9>> surface_frame(const S&, const UploadFrame&);           \
  /** Places to draw on it: on one part's primitives; what has no parts takes them all. */    \
  void emit(AreaItems&, const S&, Primitives);                                                \
  /** The primitive that the first of those is, if they are primitives in its order and never \
     in the way of their own light; else -1. */                                               \
  int first_of_area(const S&, int part, bool shines_inwards);                                 \
  /** As uv_rates.h has it, per unit of length of the world. */                               \
  Vec2 uv_rates(const S&);                                                                    \
  /** point: of its places; vector: of its edges and axes that have a length. */              \
  void move(S&, const MapVec3& point, const MapVec3& vector);                                 \
  /** Lengths that are neither. */                                                            \
  void scale(S&, double factor);                                                              \
  /** Directions that are no edges of anything; flip_x: x becomes -x. */                      \
  Mirrored mirror(S&, const MapVec3& flip_x);
// NOLINTEND(bugprone-macro-parentheses)
#include "kinds/shapes.def"
#undef SHAPE_KIND

/// Boxes around a primitive of an entry of cl/shapes/shapes.def, from its planes. Each is defined in the file of the
/// shape with its name (the parallelogram's in the rectangle's). roundoff: the relative rounding of the planes. None:
/// unbounded.
#define SHAPE(name, planes) std::optional<Bounds<double>> bounds_##name(const double* p, double roundoff);
#include "../../cl/shapes/shapes.def"
#undef SHAPE

}  // namespace strahl::kinds

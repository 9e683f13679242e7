// SPDX-License-Identifier: MIT
// The same scene in other units, elsewhere, as in a mirror, in another order, by more light: pictures that must not
// change, or only as the light does.
#pragma once

#include "kinds/shapes.h"

namespace strahl {

/// `place` of every place, the camera's and the lamps' too; `vector` of every edge and axis that has a length.
[[nodiscard]] Scene with_places(Scene scene, const MapVec3& place, const MapVec3& vector);

/// Every length times factor > 0, camera and clipping included; point lights times factor^2, so that radiance stays.
[[nodiscard]] Scene scaled(Scene scene, double factor);

/// Every place moved, the camera's too.
[[nodiscard]] Scene translated(Scene scene, const Vec3& by);

/// x becomes -x, and the camera's right its left: the picture is flipped from left to right.
[[nodiscard]] Scene mirrored(Scene scene);

/// Every emitter so many times as bright.
[[nodiscard]] Scene brightened(Scene scene, double factor);

/// One more emitter: a sphere behind the camera that makes an irradiance of 1 there, whatever its size. distance: in
/// units of the scene's extent; radius: a share of the distance.
[[nodiscard]] Scene with_lamp(Scene scene, double distance, double radius);

/// Shapes in the opposite order of the file; ids follow.
[[nodiscard]] Scene reordered(Scene scene);

}  // namespace strahl

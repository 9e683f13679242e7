// SPDX-License-Identifier: MIT
// Warnings about features of a scene that its integrator does not support yet, and about a picture that will be empty.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// Warnings in scene order; empty where the picture will show all that the scene asks for. disabled: effects that are
/// left out (RenderSettings::disabled).
[[nodiscard]] std::vector<Diagnostic> limitations(const Scene& scene, const std::set<std::string>& disabled = {});

/// For the tiers of single precision that scale the scene (kinds/upload_frame.h): a shape so far away that its range
/// does not hold the squares of the smallest shape as well.
[[nodiscard]] std::optional<Diagnostic> too_wide_for_single(const Scene& scene);

/// A body so far away, for how dense its medium is, that single precision does not tell the places where its light
/// scatters from its boundary, so that light is lost. origin: where the tier's numbers begin, the camera or, of `fast`,
/// the world's origin.
[[nodiscard]] std::optional<Diagnostic> too_dense_for_single(const Scene& scene, const Vec3& origin);

}  // namespace strahl

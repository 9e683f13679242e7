// SPDX-License-Identifier: MIT
// Values of every pixel beside its colour as named channels.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "image/image.h"
#include "kinds/upload_frame.h"
#include "scene/model/aovs.h"
#include "scene/model/scene.h"
#include "settings/aov_list.h"

namespace strahl {

/// "depth.Z", "normal.X" "normal.Y" "normal.Z", "position.X" ..., "uv.U" "uv.V", "shape_id.I", "primitive_id.I",
/// "numeric_error.ULP".
[[nodiscard]] std::vector<std::string> aov_channels(const std::set<Aov>& aovs);

/// Raw values as cl/scene/layout.h orders them (AOV_REALS and AOV_INTS a pixel), in the frame of the upload. With
/// numeric_error, t has given way to its error (numeric_error.h).
struct FirstSampleValues {
  int width = 0, height = 0;
  const std::vector<double>& reals;
  const std::vector<std::int32_t>& ints;
  UploadFrame frame;
  bool are_there = true;  ///< false: of a part whose samples begin behind the first, so that it has no such channels.
};

/// The channels of aov_channels(); positions and depths return to the world frame. No channels without AOVs, of which
/// there may then be no values.
[[nodiscard]] Image aov_image(const FirstSampleValues& values, const std::set<Aov>& aovs);

/// Of all samples of a pixel: three channels each.
struct SampleMeans {
  const Image& color;
  const Image& squares;  ///< FilmSums::mean_of_squares(); read where Aov::xyz_squared is asked for.
};

/// The same under a scene's names: channels_of() each.
[[nodiscard]] Image aov_image(const FirstSampleValues& values, const SampleMeans& means,
                              const std::vector<NamedAov>& aovs);

/// What is counted in ids.
struct IdCounts {
  std::int64_t shapes = 0, primitives = 0;  ///< Of the scene; of the shape that has the most.
};
[[nodiscard]] IdCounts id_counts(const Scene& scene);

/// Those of `aovs` whose ids are so many that floats, as all channels are, do not tell them apart.
[[nodiscard]] std::set<Aov> rounded_ids(const IdCounts& counts, const AovList& aovs);

}  // namespace strahl

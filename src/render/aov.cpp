// SPDX-License-Identifier: MIT
#include "render/aov.h"

#include <algorithm>
#include <array>
#include <limits>

#include "packing/cl_layout.h"

namespace strahl {
namespace {

#define R(x) x
#include "../../cl/film/xyz.h"
constexpr std::array<std::array<double, 3>, 3> xyz_of_rgb{{{XYZ_OF_RGB_X}, {XYZ_OF_RGB_Y}, {XYZ_OF_RGB_Z}}};
#undef R

/// A channel: strahl's own name and where its value stands.
struct AovChannel {
  Aov aov;
  const char* name;
  int at;
  bool integer;
};

constexpr AovChannel known_channels[] = {
    {Aov::depth, "depth.Z", layout::AOV_DEPTH, false},
    {Aov::normal, "normal.X", layout::AOV_NORMAL, false},
    {Aov::normal, "normal.Y", layout::AOV_NORMAL + 1, false},
    {Aov::normal, "normal.Z", layout::AOV_NORMAL + 2, false},
    {Aov::position, "position.X", layout::AOV_POSITION, false},
    {Aov::position, "position.Y", layout::AOV_POSITION + 1, false},
    {Aov::position, "position.Z", layout::AOV_POSITION + 2, false},
    {Aov::uv, "uv.U", layout::AOV_UV, false},
    {Aov::uv, "uv.V", layout::AOV_UV + 1, false},
    {Aov::albedo, "albedo.R", layout::AOV_ALBEDO, false},
    {Aov::albedo, "albedo.G", layout::AOV_ALBEDO + 1, false},
    {Aov::albedo, "albedo.B", layout::AOV_ALBEDO + 2, false},
    {Aov::geo_normal, "geo_normal.X", layout::AOV_GEO_NORMAL, false},
    {Aov::geo_normal, "geo_normal.Y", layout::AOV_GEO_NORMAL + 1, false},
    {Aov::geo_normal, "geo_normal.Z", layout::AOV_GEO_NORMAL + 2, false},
    {Aov::numeric_error, "numeric_error.ULP", layout::AOV_T, false},
    {Aov::shape_id, "shape_id.I", layout::AOV_SHAPE, true},
    {Aov::primitive_id, "primitive_id.I", layout::AOV_PRIMITIVE, true},
};

/// A channel of an image: its own name, and where its values stand: those of first samples, or a picture's.
struct Column {
  std::string name;
  const AovChannel* channel = nullptr;
  const Image* picture = nullptr;
  std::size_t component = 0;
};

float first_sample_value(const FirstSampleValues& values, const AovChannel& channel, std::size_t pixel) {
  const double* real = &values.reals[pixel * layout::AOV_REALS];
  const std::int32_t* integer = &values.ints[pixel * layout::AOV_INTS];
  const UploadFrame& frame = values.frame;
  const double origin[] = {frame.origin.x, frame.origin.y, frame.origin.z};
  const bool hit = integer[layout::AOV_SHAPE] >= 0;
  double value = channel.integer ? integer[channel.at] : real[channel.at];
  if (channel.aov == Aov::position || channel.aov == Aov::depth) value /= frame.scale;
  if (channel.aov == Aov::position && hit) value += origin[channel.at - layout::AOV_POSITION];
  // -0 becomes 0: some devices' fma (Mesa's software fma) loses the sign of a zero sum.
  return static_cast<float>(value + 0.0);
}

Image image_of(const FirstSampleValues& values, const std::vector<Column>& columns) {
  Image image;
  image.channels.clear();
  if (columns.empty()) return image;
  image.width = values.width;
  image.height = values.height;
  for (const Column& column : columns) image.channels.push_back(column.name);
  const std::size_t pixels = static_cast<std::size_t>(values.width) * static_cast<std::size_t>(values.height);
  image.data.reserve(pixels * columns.size());
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    for (const Column& column : columns)
      image.data.push_back(column.picture != nullptr ? column.picture->data[pixel * 3 + column.component]
                                                     : first_sample_value(values, *column.channel, pixel));
  return image;
}

Image xyz_of(const Image& rgb) {
  Image xyz = rgb;
  for (std::size_t at = 0; at < rgb.data.size(); ++at) {
    const std::array<double, 3>& row = xyz_of_rgb[at % 3];
    const float* color = &rgb.data[at - at % 3];
    xyz.data[at] = static_cast<float>(row[0] * color[0] + row[1] * color[1] + row[2] * color[2]);
  }
  return xyz;
}

}  // namespace

std::vector<std::string> aov_channels(const std::set<Aov>& aovs) {
  std::vector<std::string> names;
  for (const AovChannel& channel : known_channels)
    if (aovs.contains(channel.aov)) names.emplace_back(channel.name);
  return names;
}

IdCounts id_counts(const Scene& scene) {
  IdCounts counts;
  for_each_shape(scene, [&](const Shape& shape) {
    ++counts.shapes;
    counts.primitives = std::max<std::int64_t>(counts.primitives, primitive_count(shape));
  });
  return counts;
}

std::set<Aov> rounded_ids(const IdCounts& counts, const AovList& aovs) {
  constexpr std::int64_t last_exact = std::int64_t{1} << std::numeric_limits<float>::digits;
  std::set<Aov> rounded;
  if (counts.shapes - 1 > last_exact && aovs.contains(Aov::shape_id)) rounded.insert(Aov::shape_id);
  if (counts.primitives - 1 > last_exact && aovs.contains(Aov::primitive_id)) rounded.insert(Aov::primitive_id);
  return rounded;
}

Image aov_image(const FirstSampleValues& values, const std::set<Aov>& aovs) {
  std::vector<Column> columns;
  for (const AovChannel& channel : known_channels)
    if (aovs.contains(channel.aov) && values.are_there) columns.push_back({channel.name, &channel});
  return image_of(values, columns);
}

Image aov_image(const FirstSampleValues& values, const SampleMeans& means, const std::vector<NamedAov>& aovs) {
  std::vector<Column> columns;
  const bool has_xyz =
      std::any_of(aovs.begin(), aovs.end(), [](const NamedAov& named) { return named.aov == Aov::xyz; });
  const Image xyz = has_xyz ? xyz_of(means.color) : Image{};
  for (const NamedAov& named : aovs) {
    if (is_of_first_sample(named.aov) && !values.are_there) continue;
    const std::vector<std::string> names = channels_of(named);
    auto name = names.begin();
    if (is_of_first_sample(named.aov)) {
      for (const AovChannel& channel : known_channels)
        if (channel.aov == named.aov) columns.push_back({*name++, &channel});
    } else {
      const Image& picture = named.aov == Aov::xyz ? xyz : means.squares;
      for (std::size_t component = 0; component < 3; ++component)
        columns.push_back({*name++, nullptr, &picture, component});
    }
  }
  return image_of(values, columns);
}

}  // namespace strahl

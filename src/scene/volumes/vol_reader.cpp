// SPDX-License-Identifier: MIT
#include "scene/volumes/vol_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "errors.h"
#include "image/byte_order.h"
#include "image/file_bytes.h"

namespace strahl {
namespace {

constexpr std::size_t header_bytes = 48;
constexpr std::int32_t of_floats = 1, of_bytes = 3;

template <class T>
T load_at(const std::string& bytes, std::size_t at) {
  return load<T>(bytes.data() + at, std::endian::little);
}

}  // namespace

VolumeGrid read_vol(const std::string& path) {
  const std::string bytes = read_file(path);
  const auto fail = [&](const std::string& why) { throw InputError(fmt::format("\"{}\" {}", path, why)); };
  using namespace std::string_view_literals;
  if (!std::string_view(bytes).starts_with("VOL\x03"sv))
    fail("is not a .vol file of version 3: it does not begin with \"VOL\" and a 3");
  if (bytes.size() < header_bytes) fail(fmt::format("ends within its header of {} bytes", header_bytes));
  const auto encoding = load_at<std::int32_t>(bytes, 4), width = load_at<std::int32_t>(bytes, 8),
             height = load_at<std::int32_t>(bytes, 12), depth = load_at<std::int32_t>(bytes, 16),
             channels = load_at<std::int32_t>(bytes, 20);
  if (encoding != of_floats && encoding != of_bytes)
    fail(fmt::format("has texels of encoding {}; 1 (float32) and 3 (bytes) can be read", encoding));
  if (channels != 1 && channels != 3)
    fail(fmt::format("has {} channels; a grid has 1 (grey) or 3 (r, g, b)", channels));
  if (width < 1 || height < 1 || depth < 1 || height > most_texels / width || depth > most_texels / width / height)
    fail(fmt::format("has {} x {} x {} texels; a grid has at most {}, and at least one", width, height, depth,
                     most_texels));
  if (std::max({width, height, depth}) > longest_side)
    fail(fmt::format("has {} x {} x {} texels; a side of a grid has at most {}", width, height, depth, longest_side));
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                            static_cast<std::size_t>(depth) * static_cast<std::size_t>(channels);
  const std::size_t expected = header_bytes + count * (encoding == of_floats ? sizeof(float) : 1);
  if (bytes.size() < expected)
    fail(fmt::format("has {} bytes; its header promises {} x {} x {} texels, {} bytes", bytes.size(), width, height,
                     depth, expected));
  VolumeGrid grid;
  if (encoding == of_bytes) {
    grid = grid_of_texels(height, depth,
                          texels_of_bytes(width, height * depth, channels,
                                          reinterpret_cast<const std::uint8_t*>(bytes.data()) + header_bytes));
  } else {
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = load_at<float>(bytes, header_bytes + i * sizeof(float));
    grid = grid_of_floats(width, height, depth, channels, std::move(values));
  }
  std::array<double, 6> box{};
  for (std::size_t i = 0; i < box.size(); ++i)
    box[i] = static_cast<double>(load_at<float>(bytes, header_bytes - 24 + i * sizeof(float)));
  grid.low = {box[0], box[1], box[2]};
  grid.high = {box[3], box[4], box[5]};
  grid.texels.file = path;
  return grid;
}

}  // namespace strahl

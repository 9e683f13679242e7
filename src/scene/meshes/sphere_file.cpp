// SPDX-License-Identifier: MIT
#include "scene/meshes/sphere_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "scene/meshes/ply_data.h"

namespace strahl {
namespace {

constexpr std::array<std::string_view, 4> column_names{"x", "y", "z", "radius"};

/// Passes over an element that comes before the vertices.
template <class Data>
void skip(Data& data, const PlyElement& element) {
  if (element.properties.empty()) return;  // Whatever its number.
  for (std::uint64_t i = 0; i < element.count; ++i) {
    data.begin_element();
    for (const PlyProperty& property : element.properties) {
      const std::int64_t values = property.count_type ? data.integer(*property.count_type) : 1;
      data.skip(property.type, static_cast<std::uint64_t>(std::max<std::int64_t>(values, 0)));
    }
    data.end_element();
  }
}

template <class Data>
std::vector<SphereCloud::Ball> read_spheres(Data& data, const PlyElement& element, MeshSource& source) {
  std::vector<std::size_t> slots(element.properties.size(), column_names.size());
  for (const PlyProperty& property : element.properties)
    if (property.count_type) source.fail(element.at, fmt::format("the vertices' {} is a list", property.name));
  for (std::size_t slot = 0; slot < column_names.size(); ++slot) {
    const int i = element.find({column_names[slot]});
    if (i < 0) source.fail(element.at, fmt::format("the vertices have no property {}", column_names[slot]));
    slots[static_cast<std::size_t>(i)] = slot;
  }
  std::vector<SphereCloud::Ball> spheres;
  spheres.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    data.begin_element();
    const char* at = data.position();
    double values[column_names.size() + 1] = {};
    for (std::size_t k = 0; k < slots.size(); ++k) values[slots[k]] = data.real(element.properties[k].type);
    data.end_element();
    source.passed(at);
    const double x = values[0], y = values[1], z = values[2], radius = values[3];
    if (!is_finite(Vec3{x, y, z}) || !std::isfinite(radius) || !(radius > 0))
      source.fail(at, fmt::format("sphere {} has center {}, {}, {} and radius {}; they must be finite, and the radius "
                                  "greater than 0",
                                  i, x, y, z, radius));
    spheres.push_back({{x, y, z}, radius});
  }
  return spheres;
}

template <class Data>
std::vector<SphereCloud::Ball> read(Data& data, const PlyHeader& header, MeshSource& source) {
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") {
      skip(data, element);
      continue;
    }
    if (element.count == 0) source.fail(element.at, "there are no spheres");
    return read_spheres(data, element, source);
  }
  source.fail(source.begin(), "the header names no element vertex");
}

}  // namespace

SphereFile read_sphere_file(const std::string& path, const MeshProgress& progress) {
  MeshSource source(path, progress);
  const PlyHeader header = read_ply_header(source);
  SphereFile file;
  if (header.format == PlyFormat::ascii) {
    PlyText data(source, header.data);
    file.spheres = read(data, header, source);
  } else {
    const bool swap = (header.format == PlyFormat::big_endian) != (std::endian::native == std::endian::big);
    PlyBinary data(source, header.data, swap);
    file.spheres = read(data, header, source);
  }
  file.warnings = source.finish();
  return file;
}

}  // namespace strahl

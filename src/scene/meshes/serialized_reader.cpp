// SPDX-License-Identifier: MIT
// Mitsuba's serialized meshes (W. Jakob et al., Mitsuba 3 documentation, plugin "serialized"), versions 3 and 4:
// indexed triangles with normals, texture coordinates and colours (vertex_color) in single or double precision, behind
// zlib.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "image/byte_order.h"
#include "scene/meshes/attribute_fault.h"
#include "scene/meshes/inflated_bytes.h"
#include "scene/meshes/mesh_builder.h"
#include "scene/meshes/mesh_file.h"
#include "scene/meshes/mesh_source.h"
#include "scene/meshes/serialized_part.h"

namespace strahl {
namespace {

constexpr std::uint32_t has_normals = 0x0001, has_uvs = 0x0002, has_colors = 0x0008, face_normals = 0x0010,
                        double_precision = 0x2000;
constexpr int before_stream = 4;  // what stands before the compressed stream: format and version

class SerializedReader {
 public:
  SerializedReader(const std::string& path, const SerializedPart& part, const MeshProgress& progress,
                   MeshNormals normals)
      : source_(path, progress, {part.begin, part.end - part.begin}),
        begin_(source_.begin()),
        bytes_(source_, begin_ + before_stream),
        wanted_(normals) {
    source_.begin_binary(begin_);
    flags_ = take<std::uint32_t>();
    if (part.version == 4) {
      while (take<char>() != '\0') {  // the mesh's name
      }
    }
    vertices_ = take<std::uint64_t>();
    triangles_ = take<std::uint64_t>();
    check_counts();
  }

  MeshFile read() {
    read_vertices();
    MeshBuilder builder(attributes_, triangles_);
    read_triangles(builder);
    if (!bytes_.ends()) source_.warn(begin_, "bytes after the last triangle of the mesh are ignored");
    return finish(builder);
  }

 private:
  template <class T>
  T take() {
    std::array<char, sizeof(T)> raw{};
    bytes_.read(raw.data(), raw.size());
    return load<T>(raw.data(), std::endian::little);
  }

  [[nodiscard]] bool has(std::uint32_t flag) const { return (flags_ & flag) != 0; }

  void check_counts() {
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    if (vertices_ > most || triangles_ > most) {
      source_.fail(begin_, fmt::format("the mesh promises {} vertices and {} triangles; {} of each are read at most",
                                       vertices_, triangles_, most));
    }
    const std::uint64_t numbers =
        3u + (has(has_normals) ? 3u : 0u) + (has(has_uvs) ? 2u : 0u) + (has(has_colors) ? 3u : 0u);
    const std::uint64_t size = vertices_ * numbers * (has(double_precision) ? 8 : 4) + triangles_ * 12;
    if (size > bytes_.most()) {
      source_.fail(begin_,
                   fmt::format("the mesh promises {} vertices and {} triangles, more than the file can hold; it "
                               "is truncated or damaged",
                               vertices_, triangles_));
    }
  }

  /// `row` gets N numbers at a time and their index, `count` times. Nothing of the file's size is held.
  template <class T, std::size_t N, class Row>
  void read_rows(std::uint64_t count, Row row) {
    constexpr std::uint64_t block = 4096;
    std::vector<char> raw(block * N * sizeof(T));
    for (std::uint64_t i = 0; i < count; i += block) {
      const std::uint64_t rows = std::min(block, count - i);
      bytes_.read(raw.data(), rows * N * sizeof(T));
      for (std::uint64_t k = 0; k < rows; ++k) {
        std::array<T, N> values;
        for (std::size_t n = 0; n < N; ++n) {
          values[n] = load<T>(raw.data() + (k * N + n) * sizeof(T), std::endian::little);
        }
        row(i + k, values);
      }
    }
  }

  template <std::size_t N, class Row>
  void read_numbers(Row row) {
    const auto widened = [&](std::uint64_t i, const auto& values) {
      std::array<double, N> x;
      std::ranges::copy(values, x.begin());
      row(i, x, std::ranges::all_of(x, [](double v) { return std::isfinite(v); }));
    };
    if (has(double_precision)) {
      read_rows<double, N>(vertices_, widened);
    } else {
      read_rows<float, N>(vertices_, widened);
    }
  }

  void read_vertices() {
    attributes_.positions.reserve(vertices_);
    read_numbers<3>([&](std::uint64_t i, const std::array<double, 3>& x, bool finite) {
      attributes_.positions.push_back({x[0], x[1], x[2]});
      if (!finite) bad_positions_.add(i, begin_);
    });
    if (has(has_normals)) {
      // Mitsuba 3 keeps the normals of a file that says to shade flat; Mitsuba 0.x does not.
      const bool used = wanted_ != MeshNormals::as_file_says || !has(face_normals);
      if (used) attributes_.normals.reserve(vertices_);
      read_numbers<3>([&](std::uint64_t i, const std::array<double, 3>& x, bool finite) {
        if (!used) return;
        attributes_.normals.push_back({x[0], x[1], x[2]});
        if (!finite && wanted_ != MeshNormals::unused) bad_normals_.add(i, begin_);
      });
    }
    if (has(has_uvs)) {
      attributes_.uvs.reserve(vertices_);
      read_numbers<2>([&](std::uint64_t i, const std::array<double, 2>& x, bool finite) {
        attributes_.uvs.push_back({x[0], x[1]});
        if (!finite) bad_uvs_.add(i, begin_);
      });
    }
    if (!has(has_colors)) return;
    std::vector<Rgb>& colors = attributes_.others.emplace_back(MeshAttribute{"vertex_color", {}}).values;
    colors.reserve(vertices_);
    read_numbers<3>([&](std::uint64_t, const std::array<double, 3>& x, bool) { colors.push_back({x[0], x[1], x[2]}); });
  }

  void read_triangles(MeshBuilder& builder) {
    const bool with_uvs = !attributes_.uvs.empty(), with_normals = !attributes_.normals.empty();
    read_rows<std::uint32_t, 3>(triangles_, [&](std::uint64_t t, const std::array<std::uint32_t, 3>& indices) {
      std::array<MeshCorner, 3> corners;
      bool usable = true;
      for (std::size_t k = 0; k < 3; ++k) {
        if (indices[k] >= vertices_) {
          source_.error(begin_, fmt::format("triangle {} names vertex {}; there are {}, counted from 0", t, indices[k],
                                            vertices_));
          usable = false;
          continue;
        }
        usable &= !bad_positions_.check(indices[k], begin_, source_);
        usable &= !with_normals || !bad_normals_.check(indices[k], begin_, source_);
        usable &= !with_uvs || !bad_uvs_.check(indices[k], begin_, source_);
        const int i = static_cast<int>(indices[k]);
        corners[k] = {i, with_uvs ? i : -1, with_normals ? i : -1};
      }
      if (usable && !builder.add_polygon(corners, -1)) skipped_.add(begin_);
    });
  }

  MeshFile finish(MeshBuilder& builder) {
    if (skipped_.count > 0) source_.warn(begin_, fmt::format("triangles without area skipped: {}", skipped_.count));
    for (const BadNumbers* bad : {&bad_positions_, &bad_uvs_, &bad_normals_}) bad->warn_unused(source_);
    if (builder.triangle_count() == 0 && !source_.has_errors()) {
      source_.error_of_empty_mesh(begin_);
    }
    MeshFile file;
    file.mesh = builder.finish();
    file.mesh.part_of_triangle.clear();
    for (const MeshAttribute& attribute : file.mesh.attributes)
      if (!is_finite(attribute)) file.attribute_faults.push_back(fault_of(attribute, begin_, source_));
    for (const std::string& warning : builder.warnings()) source_.warn(begin_, warning);
    file.face_normals = has(face_normals);
    file.skipped_faces = skipped_.count;
    file.warnings = source_.finish();
    return file;
  }

  MeshSource source_;
  const char* begin_;
  InflatedBytes bytes_;
  MeshNormals wanted_;
  std::uint32_t flags_ = 0;
  std::uint64_t vertices_ = 0, triangles_ = 0;
  MeshAttributes attributes_;
  BadNumbers bad_positions_{"vertex"}, bad_uvs_{"texture coordinate"}, bad_normals_{"normal"};
  Tally skipped_;
};

}  // namespace

MeshFile read_serialized(const std::string& path, int index, const MeshProgress& progress, MeshNormals normals) {
  return SerializedReader(path, find_serialized_part(path, index), progress, normals).read();
}

}  // namespace strahl

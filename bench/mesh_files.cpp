// SPDX-License-Identifier: MIT
// Writes row by row: no more of the mesh is in memory than a row of the grid.
#include "bench/mesh_files.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <memory>
#include <new>

#include "errors.h"
#include "image/atomic_file.h"

namespace strahl::bench {
namespace {

using Normal = std::array<double, 3>;

class Surface {
 public:
  explicit Surface(std::uint64_t triangles)
      : cells_(static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(triangles) / 2)))) {}

  [[nodiscard]] std::uint64_t cells() const { return cells_; }
  [[nodiscard]] std::uint64_t points() const { return cells_ + 1; }
  [[nodiscard]] double at(std::uint64_t i) const {
    return 100.0 * static_cast<double>(i) / static_cast<double>(cells_);
  }
  [[nodiscard]] double height(std::uint64_t i, std::uint64_t j) const {
    double sum = 0, size = 4, frequency = 0.07;
    for (int octave = 0; octave < 4; ++octave, size *= 0.45, frequency *= 2.1)
      sum += size * std::sin(frequency * at(i) + 1.3 * octave) * std::cos(frequency * at(j) - 0.7 * octave);
    return sum;
  }
  [[nodiscard]] Normal normal(std::uint64_t i, std::uint64_t j) const {
    const double cell = at(1);
    const double x = (height(i, j) - height(i + 1, j)) / cell, y = (height(i, j) - height(i, j + 1)) / cell;
    const double norm = std::sqrt(x * x + y * y + 1);
    return {x / norm, y / norm, 1 / norm};
  }
  [[nodiscard]] std::uint64_t index(std::uint64_t i, std::uint64_t j) const { return j * points() + i; }

 private:
  std::uint64_t cells_;
};

/// Rows are collected in `text` and go to the file one by one.
class RowFile {
 public:
  explicit RowFile(const std::string& path) : file_(path) {}

  template <class... T>
  void print(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(row_), format, std::forward<T>(values)...);
  }
  template <class T>
  void put(T value, bool reversed) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (reversed) std::ranges::reverse(bytes);
    row_.append(bytes);
  }
  void end_row() {
    if (zlib_) {
      squeeze(Z_NO_FLUSH);
    } else {
      file_.write(row_.data(), row_.size());
    }
    row_.clear();
  }
  /// Rows are compressed from here on.
  void begin_zlib() {
    zlib_ = std::make_unique<z_stream>();
    if (deflateInit(zlib_.get(), Z_DEFAULT_COMPRESSION) != Z_OK) throw std::bad_alloc();
  }
  void end_zlib() {
    squeeze(Z_FINISH);
    deflateEnd(zlib_.get());
    zlib_.reset();
  }
  void commit() { file_.commit(); }

 private:
  void squeeze(int flush) {
    std::array<char, 65536> squeezed;
    zlib_->next_in = reinterpret_cast<Bytef*>(row_.data());
    zlib_->avail_in = static_cast<uInt>(row_.size());
    do {
      zlib_->next_out = reinterpret_cast<Bytef*>(squeezed.data());
      zlib_->avail_out = static_cast<uInt>(squeezed.size());
      deflate(zlib_.get(), flush);
      file_.write(squeezed.data(), squeezed.size() - zlib_->avail_out);
    } while (zlib_->avail_out == 0);
  }

  AtomicFile file_;
  fmt::memory_buffer row_;
  std::unique_ptr<z_stream> zlib_;
};

template <class Triangle>
void each_triangle_of_row(const Surface& s, std::uint64_t j, Triangle triangle) {
  for (std::uint64_t i = 0; i < s.cells(); ++i) {
    const std::uint64_t a = s.index(i, j), b = s.index(i + 1, j), c = s.index(i, j + 1), d = s.index(i + 1, j + 1);
    triangle(i, a, b, d);
    triangle(i, a, d, c);
  }
}

void write_obj(RowFile& file, const Surface& s, const std::string& kind) {
  const bool corners = kind == "obj-corners", normals = kind == "obj-normals";
  for (std::uint64_t j = 0; j < s.points(); ++j) {
    for (std::uint64_t i = 0; i < s.points(); ++i) {
      file.print("v {:.6f} {:.6f} {:.6f}\n", s.at(i), s.at(j), s.height(i, j));
      if (corners) file.print("vt {:.6f} {:.6f}\n", s.at(i) / 100, s.at(j) / 100);
      const Normal n = normals ? s.normal(i, j) : Normal{};
      if (normals) file.print("vn {:.6f} {:.6f} {:.6f}\n", n[0], n[1], n[2]);
    }
    file.end_row();
  }
  std::uint64_t face = 0;
  for (std::uint64_t j = 0; j < s.cells(); ++j) {
    if (kind == "obj-quads") {
      for (std::uint64_t i = 0; i < s.cells(); ++i)
        file.print("f {} {} {} {}\n", s.index(i, j) + 1, s.index(i + 1, j) + 1, s.index(i + 1, j + 1) + 1,
                   s.index(i, j + 1) + 1);
      file.end_row();
      continue;
    }
    each_triangle_of_row(s, j, [&](std::uint64_t i, std::uint64_t a, std::uint64_t b, std::uint64_t c) {
      ++a, ++b, ++c, ++face;  // OBJ counts from 1
      if (corners) {
        const Normal n = s.normal(i, j);
        file.print("vn {:.4f} {:.4f} {:.4f}\n", n[0] + (face % 2 == 0 ? 0.001 : 0), n[1], n[2]);
        file.print("f {}/{}/{} {}/{}/{} {}/{}/{}\n", a, a, face, b, b, face, c, c, face);
      } else if (normals) {
        file.print("f {}//{} {}//{} {}//{}\n", a, a, b, b, c, c);
      } else {
        file.print("f {} {} {}\n", a, b, c);
      }
    });
    file.end_row();
  }
}

void write_ply(RowFile& file, const Surface& s, const std::string& kind) {
  const bool ascii = kind == "ply-ascii", normals = kind == "ply-normals", reversed = kind == "ply-big";
  static_assert(std::endian::native == std::endian::little);
  file.print("ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n",
             ascii      ? "ascii"
             : reversed ? "binary_big_endian"
                        : "binary_little_endian",
             s.points() * s.points());
  if (normals) file.print("property float nx\nproperty float ny\nproperty float nz\n");
  file.print("element face {}\nproperty list uchar int vertex_indices\nend_header\n", 2 * s.cells() * s.cells());
  for (std::uint64_t j = 0; j < s.points(); ++j) {
    for (std::uint64_t i = 0; i < s.points(); ++i) {
      const std::array position{s.at(i), s.at(j), s.height(i, j)};
      if (ascii) {
        file.print("{:.6f} {:.6f} {:.6f}\n", position[0], position[1], position[2]);
        continue;
      }
      for (const double x : position) file.put(static_cast<float>(x), reversed);
      if (!normals) continue;
      for (const double x : s.normal(i, j)) file.put(static_cast<float>(x), reversed);
    }
    file.end_row();
  }
  for (std::uint64_t j = 0; j < s.cells(); ++j) {
    each_triangle_of_row(s, j, [&](std::uint64_t, std::uint64_t a, std::uint64_t b, std::uint64_t c) {
      if (ascii) return file.print("3 {} {} {}\n", a, b, c);
      file.put(std::uint8_t{3}, reversed);
      for (const std::uint64_t v : {a, b, c}) file.put(static_cast<std::int32_t>(v), reversed);
    });
    file.end_row();
  }
}

void write_serialized(RowFile& file, const Surface& s) {
  file.put(std::uint16_t{0x041C}, false);
  file.put(std::uint16_t{4}, false);
  file.end_row();
  file.begin_zlib();
  file.put(std::uint32_t{0x1000}, false);  // single precision, positions alone
  file.print("surface");
  file.put('\0', false);
  file.put(s.points() * s.points(), false);
  file.put(2 * s.cells() * s.cells(), false);
  for (std::uint64_t j = 0; j < s.points(); ++j) {
    for (std::uint64_t i = 0; i < s.points(); ++i)
      for (const double x : {s.at(i), s.at(j), s.height(i, j)}) file.put(static_cast<float>(x), false);
    file.end_row();
  }
  for (std::uint64_t j = 0; j < s.cells(); ++j) {
    each_triangle_of_row(s, j, [&](std::uint64_t, std::uint64_t a, std::uint64_t b, std::uint64_t c) {
      for (const std::uint64_t v : {a, b, c}) file.put(static_cast<std::uint32_t>(v), false);
    });
    file.end_row();
  }
  file.end_zlib();
  file.put(std::uint64_t{0}, false);  // where the only mesh begins
  file.put(std::uint32_t{1}, false);
  file.end_row();
}

}  // namespace

const std::vector<std::string>& mesh_kinds() {
  static const std::vector<std::string> kinds{"obj", "obj-normals", "obj-corners", "obj-quads", "ply-ascii",
                                              "ply", "ply-normals", "ply-big",     "serialized"};
  return kinds;
}

std::string extension_of(const std::string& kind) { return "." + kind.substr(0, kind.find('-')); }

void write_mesh_file(const std::string& path, const std::string& kind, std::uint64_t triangles) {
  if (std::ranges::find(mesh_kinds(), kind) == mesh_kinds().end())
    throw UsageError(fmt::format("\"{}\" is no kind of mesh file; there are {}", kind, fmt::join(mesh_kinds(), ", ")));
  const Surface surface(triangles);
  RowFile file(path);
  if (extension_of(kind) == ".obj") {
    write_obj(file, surface, kind);
  } else if (kind == "serialized") {
    write_serialized(file, surface);
  } else {
    write_ply(file, surface, kind);
  }
  file.commit();
}

}  // namespace strahl::bench

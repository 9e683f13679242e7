// SPDX-License-Identifier: MIT
// Reads newmtl, Kd, map_Kd and Ke of an MTL file ("Object Files", Wavefront Advanced Visualizer manual, appendix B1).
// What has no counterpart in a diffuse material (Ka, Ks, Ns, d, illum, other textures) is passed over in silence.
// Values outside [0, 1] (Kd) and below 0 (Ke) are clamped with a warning.
#include "scene/meshes/mtl_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "scene/meshes/mesh_source.h"
#include "scene/meshes/mtl_map.h"
#include "scene/meshes/text_cursor.h"

namespace strahl {
namespace {

class MtlReader {
 public:
  MtlReader(const std::string& path, MtlLibrary& library) : source_(path), library_(library) {}

  void read() {
    const char* begin = source_.begin_text();
    TextCursor cursor(begin, source_.end());
    for (; !cursor.at_end(); cursor.next_line()) {
      if (!cursor.find_word()) continue;
      const char* at = cursor.position();
      const std::string_view keyword = cursor.word();
      if (keyword == "newmtl") {
        MeshMaterial material;
        material.name = cursor.rest();
        const std::string name = material.name;
        const auto [entry, is_new] = library_.materials.try_emplace(name, std::move(material));
        current_ = is_new ? &entry->second : &ignored_;
        has_kd_ = false;
      } else if (keyword == "Kd") {
        if (const auto color = read_color(cursor, at, "Kd", 1)) {
          current_->reflectance = *color;
          has_kd_ = true;
        }
      } else if (keyword == "Ke") {
        const auto color = read_color(cursor, at, "Ke", HUGE_VAL);
        if (color) current_->radiance = *color == Rgb{} ? std::nullopt : color;
      } else if (keyword == "map_Kd") {
        read_map(cursor, at);
      }
    }
    const auto found = source_.all();
    library_.diagnostics.insert(library_.diagnostics.end(), found.begin(), found.end());
  }

 private:
  /// "Kd r g b", or "Kd r" for grey.
  std::optional<Rgb> read_color(TextCursor& cursor, const char* at, const char* name, double most) {
    if (current_ == nullptr) {
      source_.warn(at, fmt::format("{} before the first newmtl belongs to no material and is ignored", name));
      return std::nullopt;
    }
    std::array<double, 3> values{};
    std::size_t n = 0;
    for (; n < 3 && cursor.find_word(); ++n) {
      const char* value_at = cursor.position();
      const std::string_view word = cursor.word();
      if (word == "xyz" || word == "spectral") {
        source_.warn(value_at, fmt::format("{} {} is not supported; give red, green and blue", name, word));
        return std::nullopt;
      }
      if (!parse_number(word, values[n])) {
        source_.warn(value_at, fmt::format("{}: {} is not a number; the line is ignored", name, in_quotes(word)));
        return std::nullopt;
      }
      if (!std::isfinite(values[n])) {
        source_.error(value_at, fmt::format("{}: {} is not finite", name, in_quotes(word)));
        return std::nullopt;
      }
    }
    if (n != 1 && n != 3) {
      source_.warn(at, fmt::format("{} takes 3 numbers (or 1 for grey), not {}; the line is ignored", name, n));
      return std::nullopt;
    }
    if (n == 1) values[1] = values[2] = values[0];
    Rgb color{values[0], values[1], values[2]};
    for (double* c : {&color.r, &color.g, &color.b}) {
      if (*c >= 0 && *c <= most) continue;
      source_.warn(at, fmt::format("{} {} is outside [0, {}] and is clamped", name, *c, most));
      *c = std::clamp(*c, 0.0, most);
    }
    return color;
  }

  void read_map(TextCursor& cursor, const char* at) {
    if (current_ == nullptr) {
      source_.warn(at, "map_Kd before the first newmtl belongs to no material and is ignored");
      return;
    }
    MeshTexture map = read_mtl_map(cursor, source_.path());
    map.where = source_.place(at);
    if (map.file.empty()) {
      source_.warn(at, "map_Kd names no file; the line is ignored");
      return;
    }
    current_->reflectance_map = map;
    if (!has_kd_) current_->reflectance = {1, 1, 1};
  }

  MeshSource source_;
  MtlLibrary& library_;
  MeshMaterial ignored_;
  MeshMaterial* current_ = nullptr;
  bool has_kd_ = false;  ///< The current one.
};

}  // namespace

void read_mtl(const std::string& path, MtlLibrary& library) {
  library.files.push_back(path);
  MtlReader(path, library).read();
}

}  // namespace strahl

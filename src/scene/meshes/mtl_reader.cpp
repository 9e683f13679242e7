// SPDX-License-Identifier: MIT
// Reads newmtl, Kd and Ke of an MTL file ("Object Files", Wavefront Advanced Visualizer manual, appendix B1). What has
// no counterpart in a diffuse material (Ka, Ks, Ns, d, illum, other textures) is passed over in silence; a map_Kd is
// warned of. Values outside [0, 1] (Kd) and below 0 (Ke) are clamped with a warning.
#include "scene/meshes/mtl_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "scene/meshes/mesh_source.h"
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
      } else if (keyword == "Kd") {
        if (const auto color = read_color(cursor, at, "Kd", 1)) current_->reflectance = *color;
      } else if (keyword == "Ke") {
        const auto color = read_color(cursor, at, "Ke", HUGE_VAL);
        if (color) current_->radiance = *color == Rgb{} ? std::nullopt : color;
      } else if (keyword == "map_Kd") {
        textures_.add(at);
      }
    }
    if (textures_.count > 0) {
      source_.warn(textures_.first,
                   fmt::format("map_Kd: {} textures are not read; Kd stands (this is the first)", textures_.count));
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

  MeshSource source_;
  MtlLibrary& library_;
  MeshMaterial ignored_;
  MeshMaterial* current_ = nullptr;
  Tally textures_;
};

}  // namespace

void read_mtl(const std::string& path, MtlLibrary& library) {
  library.files.push_back(path);
  MtlReader(path, library).read();
}

}  // namespace strahl

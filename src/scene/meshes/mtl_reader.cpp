// SPDX-License-Identifier: MIT
// Reads what MeshMaterial holds. What has no counterpart (Ka, other maps, sharpness) is passed over in silence. Values
// outside [0, 1] (Kd, Ks, Tf, d, Tr), [0.001, 10] (Ni) or [0, 10] (illum) and below 0 (Ke, Ns) are clamped with a
// warning.
#include "scene/meshes/mtl_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

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
        has_kd_ = has_d_ = false;
      } else {
        read_value(keyword, cursor, at);
      }
    }
    const auto found = source_.all();
    library_.diagnostics.insert(library_.diagnostics.end(), found.begin(), found.end());
  }

 private:
  void read_value(std::string_view keyword, TextCursor& cursor, const char* at) {
    if (keyword == "Kd") {
      if (const auto color = read_color(cursor, at, "Kd", 1)) {
        current_->reflectance = *color;
        has_kd_ = true;
      }
    } else if (keyword == "Ke") {
      const auto color = read_color(cursor, at, "Ke", HUGE_VAL);
      if (color) current_->radiance = *color == Rgb{} ? std::nullopt : color;
    } else if (keyword == "Ks") {
      if (const auto color = read_color(cursor, at, "Ks", 1)) current_->specular = *color;
    } else if (keyword == "Tf") {
      if (const auto color = read_color(cursor, at, "Tf", 1)) current_->filter = *color;
    } else if (keyword == "Ns") {
      if (const auto value = read_number(cursor, at, "Ns", 0, HUGE_VAL)) current_->exponent = *value;
    } else if (keyword == "Ni") {
      if (const auto value = read_number(cursor, at, "Ni", 0.001, 10)) current_->index = *value;
    } else if (keyword == "illum") {
      if (const auto value = read_number(cursor, at, "illum", 0, 10)) current_->illumination = static_cast<int>(*value);
    } else if (keyword == "d") {
      if (const auto value = read_number(cursor, at, "d", 0, 1)) current_->opacity = *value;
      has_d_ = true;
    } else if (keyword == "Tr" && !has_d_) {
      // Of 1 - d; some mean d by it, and what is invisible would hardly be there.
      const auto value = read_number(cursor, at, "Tr", 0, 1);
      if (value && *value < 1) current_->opacity = 1 - *value;
    } else if (keyword == "map_Kd") {
      const auto map = read_map(cursor, at, "map_Kd");
      if (map && !has_kd_) current_->reflectance = {1, 1, 1};
      if (map) current_->reflectance_map = map;
    } else if (keyword == "map_d") {
      if (const auto map = read_map(cursor, at, "map_d")) current_->opacity_map = map;
    } else if (keyword == "map_Bump" || keyword == "map_bump" || keyword == "bump") {
      if (const auto map = read_map(cursor, at, "map_Bump")) current_->bump_map = map;
    } else if (keyword == "norm") {
      if (const auto map = read_map(cursor, at, "norm")) current_->normal_map = map;
    }
  }

  bool has_material(const char* at, const char* name) {
    if (current_ == nullptr)
      source_.warn(at, fmt::format("{} before the first newmtl belongs to no material and is ignored", name));
    return current_ != nullptr;
  }

  /// Clamped to least ... most. "d -halo 0.5" is 0.5.
  std::optional<double> read_number(TextCursor& cursor, const char* at, const char* name, double least, double most) {
    if (!has_material(at, name)) return std::nullopt;
    std::string_view word = cursor.find_word() ? cursor.word() : std::string_view{};
    if (word == "-halo" && cursor.find_word()) word = cursor.word();
    double value = 0;
    if (!parse_number(word, value) || !std::isfinite(value)) {
      source_.warn(at, fmt::format("{}: {} is not a number; the line is ignored", name, in_quotes(word)));
      return std::nullopt;
    }
    if (value >= least && value <= most) return value;
    source_.warn(at, fmt::format("{} {} is outside [{}, {}] and is clamped", name, value, least, most));
    return std::clamp(value, least, most);
  }

  /// "Kd r g b", or "Kd r" for grey.
  std::optional<Rgb> read_color(TextCursor& cursor, const char* at, const char* name, double most) {
    if (!has_material(at, name)) return std::nullopt;
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
    std::set<double> told;
    for (double& value : values) {
      if (value >= 0 && value <= most) continue;
      if (told.insert(value).second)
        source_.warn(at, fmt::format("{} {} is outside [0, {}] and is clamped", name, value, most));
      value = std::clamp(value, 0.0, most);
    }
    return Rgb{values[0], values[1], values[2]};
  }

  std::optional<MeshTexture> read_map(TextCursor& cursor, const char* at, const char* name) {
    if (!has_material(at, name)) return std::nullopt;
    MeshTexture map = read_mtl_map(cursor, source_.path());
    map.where = source_.place(at);
    if (!map.file.empty()) return map;
    source_.warn(at, fmt::format("{} names no file; the line is ignored", name));
    return std::nullopt;
  }

  MeshSource source_;
  MtlLibrary& library_;
  MeshMaterial ignored_;
  MeshMaterial* current_ = nullptr;
  bool has_kd_ = false, has_d_ = false;  ///< The current one.
};

}  // namespace

void read_mtl(const std::string& path, MtlLibrary& library) {
  library.files.push_back(path);
  MtlReader(path, library).read();
}

}  // namespace strahl

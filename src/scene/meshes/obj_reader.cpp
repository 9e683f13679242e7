// SPDX-License-Identifier: MIT
// Wavefront OBJ ("Object Files", Wavefront Advanced Visualizer manual, appendix B): polygons, texture coordinates,
// normals and materials; groups, smoothing, lines, points and free-form surfaces are passed over.
//
// Two passes over the file in memory: numbers and material libraries first, then faces, which may name vertices that
// come later. Own parser instead of tinyobjloader: that one reads single precision by default, names no columns and
// takes what it cannot read for zero.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "scene/meshes/mesh_builder.h"
#include "scene/meshes/mesh_file.h"
#include "scene/meshes/mesh_source.h"
#include "scene/meshes/mtl_library_finder.h"
#include "scene/meshes/text_cursor.h"

namespace strahl {
namespace {

constexpr std::int64_t absent = std::numeric_limits<std::int64_t>::min() + 1;

/// A corner as written: "v", "v/vt", "v//vn" or "v/vt/vn"; what is left out is `absent`.
struct WrittenCorner {
  std::int64_t position = absent, uv = absent, normal = absent;
  const char* at = nullptr;
};

bool parse_corner(std::string_view word, WrittenCorner& corner) {
  corner = {absent, absent, absent, word.data()};
  std::size_t slash = word.find('/');
  if (!parse_integer(word.substr(0, slash), corner.position)) return false;
  for (std::int64_t* index : {&corner.uv, &corner.normal}) {
    if (slash == std::string_view::npos) return true;
    word.remove_prefix(slash + 1);
    slash = word.find('/');
    const std::string_view digits = word.substr(0, slash);
    if (!digits.empty() && !parse_integer(digits, *index)) return false;
  }
  return slash == std::string_view::npos;
}

class ObjReader {
 public:
  ObjReader(const std::string& path, const MeshProgress& progress, MeshNormals normals)
      : source_(path, progress), text_(source_.begin_text()), needs_normals_(normals == MeshNormals::used) {}

  MeshFile read() {
    read_numbers();
    if (attributes_.positions.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      source_.fail(nullptr, "more than 2147483647 vertices");
    }
    builder_.emplace(attributes_, faces_);
    read_faces();
    return finish();
  }

 private:
  // ---- first pass

  void read_numbers() {
    source_.begin_pass(0, 0.5);
    TextCursor cursor(text_, source_.end());
    for (; !cursor.at_end(); cursor.next_line()) {
      source_.passed(cursor.position());
      const std::string_view keyword = cursor.word();
      if (keyword == "v") {
        const std::array<double, 3> x =
            read_values<3>(cursor, keyword, attributes_.positions.size(), bad_positions_, 3);
        attributes_.positions.push_back({x[0], x[1], x[2]});
      } else if (keyword == "vn") {
        const std::array<double, 3> x = read_values<3>(cursor, keyword, attributes_.normals.size(), bad_normals_, 3);
        attributes_.normals.push_back({x[0], x[1], x[2]});
      } else if (keyword == "vt") {
        const std::array<double, 2> x = read_values<2>(cursor, keyword, attributes_.uvs.size(), bad_uvs_, 1);
        attributes_.uvs.push_back({x[0], x[1]});
      } else if (keyword == "f") {
        ++faces_;
      } else if (keyword == "mtllib") {
        cursor.find_word();
        const char* at = cursor.position();
        for (const std::string& name : finder_.read(source_.path(), cursor.rest(), library_)) warn_of_library(name, at);
      }
    }
  }

  /// Once a name. `at`: its line, which is found by counting from the top: not for any number of names.
  void warn_of_library(const std::string& name, const char* at) {
    constexpr std::size_t most_named = 8;
    if (missing_libraries_.size() > most_named || !missing_libraries_.insert(name).second) return;
    library_warnings_.push_back(
        source_.warning_at(at, missing_libraries_.size() > most_named
                                   ? "material libraries from here on that cannot be opened are not named"
                                   : fmt::format("material library {} cannot be opened", in_quotes(name))));
  }

  /// What follows them on the line (a weight w, vertex colours) is not read.
  template <std::size_t N>
  std::array<double, N> read_values(TextCursor& cursor, std::string_view keyword, std::size_t index, BadNumbers& bad,
                                    std::size_t at_least) {
    std::array<double, N> values{};
    for (std::size_t i = 0; i < N; ++i) {
      const std::string_view word = cursor.word();
      if (word.empty() && i >= at_least) break;
      if (!parse_number(word, values[i]) || !std::isfinite(values[i])) {
        bad.add(index, word.empty() ? keyword.data() : word.data());
        break;
      }
    }
    return values;
  }

  // ---- second pass

  void read_faces() {
    source_.begin_pass(0.5, 1);
    TextCursor cursor(text_, source_.end());
    for (; !cursor.at_end(); cursor.next_line()) {
      source_.passed(cursor.position());
      const std::string_view keyword = cursor.word();
      if (keyword.empty() || keyword == "o" || keyword == "g" || keyword == "s" || keyword == "mtllib") continue;
      if (keyword == "v") {
        ++positions_so_far_;
      } else if (keyword == "vt") {
        ++uvs_so_far_;
      } else if (keyword == "vn") {
        ++normals_so_far_;
      } else if (keyword == "f") {
        read_face(cursor, keyword.data());
      } else if (keyword == "usemtl") {
        material_ = {cursor.rest(), keyword.data(), -1};
      } else if (keyword == "l" || keyword == "p") {
        lines_and_points_.add(keyword.data());
      } else {
        if (unknown_.count == 0) first_unknown_ = keyword;
        unknown_.add(keyword.data());
      }
    }
  }

  void read_face(TextCursor& cursor, const char* face) {
    written_.clear();
    for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
      if (!parse_corner(word, written_.emplace_back())) return malformed_.add(word.data());
    }
    if (written_.size() < 3) return malformed_.add(face);
    corners_.clear();
    bool usable = true;
    for (const WrittenCorner& w : written_) {
      MeshCorner corner;
      usable &= resolve(w.position, positions_so_far_, attributes_.positions.size(), "vertex", w.at, corner.position);
      usable &= resolve(w.uv, uvs_so_far_, attributes_.uvs.size(), "texture coordinate", w.at, corner.uv);
      usable &= resolve(w.normal, normals_so_far_, attributes_.normals.size(), "normal", w.at, corner.normal);
      corners_.push_back(corner);
    }
    if (!usable) return;
    for (const MeshCorner& c : corners_) {
      usable &= !bad_positions_.check(static_cast<std::size_t>(c.position), face, source_);
      usable &= c.uv < 0 || !bad_uvs_.check(static_cast<std::size_t>(c.uv), face, source_);
      usable &=
          !needs_normals_ || c.normal < 0 || !bad_normals_.check(static_cast<std::size_t>(c.normal), face, source_);
    }
    if (!usable) return;
    if (!builder_->add_polygon(corners_, material_of_face())) degenerate_.add(face);
  }

  /// From 1 or, negative, from the last one read so far, to an index from 0.
  bool resolve(std::int64_t written, std::size_t so_far, std::size_t total, const char* noun, const char* at,
               int& index) {
    if (written == absent) {
      index = -1;
      return true;
    }
    const std::int64_t i = written > 0 ? written - 1 : written + static_cast<std::int64_t>(so_far);
    if (written == 0) {
      source_.error(at, fmt::format("{} index 0: OBJ counts from 1", noun));
    } else if (i < 0 || static_cast<std::size_t>(i) >= total) {
      source_.error(at, fmt::format("{} index {} is out of range: there are {}{}", noun, written,
                                    written > 0 ? total : so_far, written > 0 ? "" : " so far"));
    } else {
      index = static_cast<int>(i);
      return true;
    }
    return false;
  }

  /// -1 where the file has named no material so far.
  int material_of_face() {
    if (material_.at == nullptr || material_.index >= 0) return material_.index;
    const auto [entry, is_new] = index_of_material_.try_emplace(material_.name, static_cast<int>(materials_.size()));
    if (is_new) {
      const auto known = library_.materials.find(material_.name);
      if (known == library_.materials.end()) {
        materials_.push_back(undefined_material());
        materials_.back().name = material_.name;
        undefined_materials_.push_back(material_.at);
      } else {
        materials_.push_back(known->second);
      }
    }
    return material_.index = entry->second;
  }

  static MeshMaterial undefined_material() {
    MeshMaterial material;
    material.is_defined = false;
    return material;
  }

  // ---- result

  MeshFile finish() {
    const auto tell = [&](const Tally& tally, const std::string& what) {
      if (tally.count > 0) source_.warn(tally.first, what);
    };
    tell(malformed_, fmt::format("faces skipped: {} that cannot be read or have fewer than 3 corners (this is the "
                                 "first)",
                                 malformed_.count));
    tell(degenerate_,
         fmt::format("faces skipped: {} without area or whose edges cross (this is the first)", degenerate_.count));
    tell(lines_and_points_,
         fmt::format("lines and points are not rendered: {} (this is the first)", lines_and_points_.count));
    tell(unknown_, fmt::format("lines ignored: {} with an unknown keyword; the first is {}", unknown_.count,
                               in_quotes(first_unknown_)));
    for (const BadNumbers* bad : {&bad_positions_, &bad_uvs_}) bad->warn_unused(source_);
    if (needs_normals_) bad_normals_.warn_unused(source_);
    if (builder_->triangle_count() == 0 && !source_.has_errors()) {
      source_.error_of_empty_mesh(nullptr);
    }
    MeshFile file;
    file.mesh = builder_->finish();
    for (const std::string& warning : builder_->warnings()) source_.warn(nullptr, warning);
    file.skipped_faces = malformed_.count + degenerate_.count;
    file.warnings = source_.finish();
    file.missing_libraries = std::move(library_warnings_);
    file.library_problems = std::move(library_.diagnostics);
    file.libraries = library_.files;
    set_materials(file);
    return file;
  }

  /// Faces before the first usemtl get a default material without a name, but only where others have one.
  void set_materials(MeshFile& file) {
    if (materials_.empty()) {
      file.mesh.part_of_triangle.clear();
      return;
    }
    // In the order of the file, as materials are.
    const std::vector<SourceLocation> places = source_.places(undefined_materials_);
    auto place = places.begin();
    for (MeshMaterial& material : materials_)
      if (!material.is_defined) material.where = *place++;
    const int unnamed = static_cast<int>(materials_.size());
    bool uses_unnamed = false;
    for (int& part : file.mesh.part_of_triangle) {
      if (part >= 0) continue;
      part = unnamed;
      uses_unnamed = true;
    }
    if (uses_unnamed) materials_.push_back(undefined_material());
    file.materials = std::move(materials_);
  }

  struct CurrentMaterial {
    std::string name;
    const char* at = nullptr;
    int index = -1;
  };

  MeshSource source_;
  const char* text_;
  bool needs_normals_;
  MeshAttributes attributes_;
  BadNumbers bad_positions_{"vertex"}, bad_uvs_{"texture coordinate"}, bad_normals_{"normal"};
  MtlLibraryFinder finder_;
  MtlLibrary library_;

  std::size_t faces_ = 0;
  std::optional<MeshBuilder> builder_;
  std::size_t positions_so_far_ = 0, uvs_so_far_ = 0, normals_so_far_ = 0;
  std::vector<WrittenCorner> written_;
  std::vector<MeshCorner> corners_;
  CurrentMaterial material_;
  std::map<std::string, int> index_of_material_;
  std::vector<MeshMaterial> materials_;
  std::set<std::string> missing_libraries_;
  std::vector<const char*> undefined_materials_;
  Tally malformed_, degenerate_, lines_and_points_, unknown_;
  std::string first_unknown_;
  std::vector<Diagnostic> library_warnings_;
};

}  // namespace

MeshFile read_obj(const std::string& path, const MeshProgress& progress, MeshNormals normals) {
  return ObjReader(path, progress, normals).read();
}

}  // namespace strahl

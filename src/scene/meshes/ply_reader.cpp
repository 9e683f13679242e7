// SPDX-License-Identifier: MIT
// PLY ("The PLY Polygon File Format", G. Turk, Stanford, 1994), text and binary: positions, normals (nx ny nz),
// texture coordinates (u v, texture_u texture_v, s t) and polygons (vertex_indices or vertex_index), or, where there
// are none, triangle strips (tristrips, a list in which -1 begins a strip anew: Stanford's archives). Elements and
// properties may come in any order; others are attributes (ply_attributes.h) or passed over.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include "scene/meshes/attribute_fault.h"
#include "scene/meshes/mesh_builder.h"
#include "scene/meshes/mesh_file.h"
#include "scene/meshes/ply_attributes.h"
#include "scene/meshes/ply_data.h"

namespace strahl {
namespace {

/// Names of texture coordinates. The first pair that a file has counts, as in Mitsuba, which lacks the last one.
using NamePair = std::pair<std::string_view, std::string_view>;
constexpr std::array uv_pairs{NamePair{"u", "v"}, NamePair{"texture_u", "texture_v"}, NamePair{"s", "t"},
                              NamePair{"texture_s", "texture_t"}};

const PlyElement* find_element(const PlyHeader& header, std::string_view name) {
  const auto found = std::ranges::find(header.elements, name, &PlyElement::name);
  return found == header.elements.end() ? nullptr : &*found;
}

class PlyReader {
 public:
  PlyReader(const std::string& path, const MeshProgress& progress, MeshNormals normals)
      : source_(path, progress), header_(read_ply_header(source_)), needs_normals_(normals == MeshNormals::used) {}

  MeshFile read() {
    find_elements();
    if (header_.format == PlyFormat::ascii) {
      PlyText data(source_, header_.data);
      read_elements(data);
    } else {
      const bool swap = (header_.format == PlyFormat::big_endian) != (std::endian::native == std::endian::big);
      PlyBinary data(source_, header_.data, swap);
      read_elements(data);
    }
    return finish();
  }

 private:
  void find_elements() {
    vertices_ = find_element(header_, "vertex");
    faces_ = find_element(header_, "face");
    const PlyElement* strips = find_element(header_, "tristrips");
    are_strips_ = strips != nullptr && (faces_ == nullptr || faces_->count == 0);
    if (are_strips_) faces_ = strips;
    if (vertices_ == nullptr) source_.fail(source_.begin(), "the header names no element vertex");
    for (const char* name : {"x", "y", "z"}) {
      const int i = vertices_->find({name});
      if (i < 0 || vertices_->properties[static_cast<std::size_t>(i)].count_type) {
        source_.fail(vertices_->at, fmt::format("the vertices have no property {}", name));
      }
    }
    if (vertices_->count > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
      source_.fail(vertices_->at, "more than 2147483647 vertices");
    }
    if (faces_ == nullptr) source_.fail(source_.begin(), "mesh without triangles: the header names no element face");
    const int list = faces_->find({"vertex_indices", "vertex_index"});
    if (list < 0) {
      source_.fail(faces_->at, fmt::format("the {} have no property vertex_indices (or vertex_index)",
                                           are_strips_ ? "tristrips" : "faces"));
    }
    list_ = static_cast<std::size_t>(list);
    const PlyProperty& indices = faces_->properties[list_];
    if (!indices.count_type || !is_integer(indices.type)) {
      source_.fail(faces_->at, fmt::format("the property {} is not a list of integers", indices.name));
    }
  }

  /// Faces that come before the vertices are read after them.
  template <class Data>
  void read_elements(Data& data) {
    const char* faces_begin = nullptr;
    for (const PlyElement& element : header_.elements) {
      if (&element == vertices_) {
        read_vertices(data);
      } else if (&element == faces_ && builder_) {
        read_faces(data);
      } else {
        if (&element == faces_) faces_begin = data.position();
        skip_element(data, element);
      }
    }
    data.finish();
    if (faces_begin != nullptr) {
      data.seek(faces_begin);
      read_faces(data);
    }
  }

  template <class Data>
  void skip_list(Data& data, const PlyProperty& property) {
    data.skip(property.type, list_size(data, property));
  }

  template <class Data>
  std::uint64_t list_size(Data& data, const PlyProperty& property) {
    const char* at = data.position();
    const std::int64_t size = data.integer(*property.count_type);
    if (size < 0 || static_cast<std::uint64_t>(size) > data.room(property.type)) {
      source_.fail(at, fmt::format("a list {} of {} items: {}", in_quotes(property.name), size,
                                   size < 0 ? "less than none" : "the file is too short for it"));
    }
    return static_cast<std::uint64_t>(size);
  }

  template <class Data>
  void skip_element(Data& data, const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      data.begin_element();
      for (const PlyProperty& property : element.properties) {
        if (property.count_type) {
          skip_list(data, property);
        } else {
          data.skip(property.type, 1);
        }
      }
      data.end_element();
    }
  }

  template <class Data>
  void read_vertices(Data& data) {
    constexpr std::size_t none = 8;
    std::vector<std::size_t> slots(vertices_->properties.size(), none);
    const auto assign = [&](std::size_t slot, std::initializer_list<std::string_view> names) {
      const int i = vertices_->find(names);
      if (i < 0 || vertices_->properties[static_cast<std::size_t>(i)].count_type) return false;
      slots[static_cast<std::size_t>(i)] = slot;
      return true;
    };
    assign(0, {"x"}), assign(1, {"y"}), assign(2, {"z"});
    const bool has_nx = assign(3, {"nx"}), has_ny = assign(4, {"ny"}), has_nz = assign(5, {"nz"});
    has_normals_ = has_nx && has_ny && has_nz;
    const auto is_number = [&](std::string_view name) {
      const int i = vertices_->find({name});
      return i >= 0 && !vertices_->properties[static_cast<std::size_t>(i)].count_type;
    };
    const auto* const pair = std::ranges::find_if(
        uv_pairs, [&](const NamePair& names) { return is_number(names.first) && is_number(names.second); });
    has_uvs_ = pair != uv_pairs.end() && assign(6, {pair->first}) && assign(7, {pair->second});

    std::vector<bool> is_taken;
    for (std::size_t k = 0; k < slots.size(); ++k)
      is_taken.push_back(slots[k] != none || vertices_->properties[k].count_type.has_value());
    const std::vector<PlyAttribute> others = attributes_of(*vertices_, "vertex_", is_taken, source_);
    std::size_t numbers = none + 1;
    for (const PlyAttribute& attribute : others) {
      attributes_.others.push_back({attribute.name, {}});
      for (const std::size_t k : attribute.properties) slots[k] = numbers++;
    }
    std::vector<double> x(numbers, 0.0);
    attributes_.positions.reserve(vertices_->count);
    if (has_normals_) attributes_.normals.reserve(vertices_->count);
    if (has_uvs_) attributes_.uvs.reserve(vertices_->count);
    for (std::size_t i = 0; i < vertices_->count; ++i) {
      data.begin_element();
      const char* at = data.position();
      source_.passed(at);
      for (std::size_t k = 0; k < slots.size(); ++k) {
        const PlyProperty& property = vertices_->properties[k];
        if (property.count_type) {
          skip_list(data, property);
        } else if (slots[k] == none) {
          data.skip(property.type, 1);
        } else {
          x[slots[k]] = data.real(property.type);
        }
      }
      data.end_element();
      attributes_.positions.push_back({x[0], x[1], x[2]});
      if (has_normals_) attributes_.normals.push_back({x[3], x[4], x[5]});
      if (has_uvs_) attributes_.uvs.push_back({x[6], x[7]});
      for (std::size_t k = 0, at_number = none + 1; k < others.size(); ++k) {
        attributes_.others[k].values.push_back(value_of(others[k], &x[at_number]));
        at_number += others[k].properties.size();
      }
      double sum = 0;  // of zeros, or NaN
      for (const double number : x) sum += 0 * number;
      if (!(sum == 0)) note_bad_numbers(i, at, x);
    }
    builder_.emplace(attributes_, faces_->count);
  }

  /// Of vertex i, whose position, normal and texture coordinates are x[0] to x[7].
  void note_bad_numbers(std::size_t i, const char* at, const std::vector<double>& x) {
    const auto are_finite = [&](int first, int end) {
      return std::all_of(x.begin() + first, x.begin() + end, [](double number) { return std::isfinite(number); });
    };
    if (!are_finite(0, 3) || (needs_normals_ && !are_finite(3, 6)) || !are_finite(6, 8)) bad_.add(i, at);
    for (const MeshAttribute& attribute : attributes_.others)
      if (!is_finite(attribute.values[i])) first_bad_.try_emplace(attribute.name, at);
  }

  /// One number is grey.
  static Rgb value_of(const PlyAttribute& attribute, const double* numbers) {
    const double s = attribute.scale;
    if (attribute.properties.size() == 1) return {s * numbers[0], s * numbers[0], s * numbers[0]};
    return {s * numbers[0], s * numbers[1], s * numbers[2]};
  }

  void find_face_attributes() {
    std::vector<bool> is_taken;
    for (const PlyProperty& property : faces_->properties) is_taken.push_back(property.count_type.has_value());
    face_slots_.assign(faces_->properties.size(), -1);
    if (are_strips_) return;
    of_faces_ = attributes_of(*faces_, "face_", is_taken, source_);
    for (const PlyAttribute& attribute : of_faces_) {
      face_values_.push_back({attribute.name, {}});
      for (const std::size_t k : attribute.properties) {
        face_slots_[k] = static_cast<int>(face_numbers_.size());
        face_numbers_.push_back(0);
      }
    }
  }

  /// For each triangle that the face has become.
  void put_face_values(const char* face) {
    for (std::size_t k = 0, number = 0; k < of_faces_.size(); ++k) {
      const Rgb value = value_of(of_faces_[k], &face_numbers_[number]);
      if (!is_finite(value)) first_bad_.try_emplace(of_faces_[k].name, face);
      face_values_[k].values.resize(builder_->triangle_count(), value);
      number += of_faces_[k].properties.size();
    }
  }

  template <class Data>
  void read_faces(Data& data) {
    find_face_attributes();
    for (std::uint64_t i = 0; i < faces_->count; ++i) {
      data.begin_element();
      const char* face = data.position();
      source_.passed(face);
      for (std::size_t k = 0; k < faces_->properties.size(); ++k) {
        const PlyProperty& property = faces_->properties[k];
        if (k == list_ && are_strips_) {
          read_strips(data, property, face);
        } else if (k == list_) {
          read_face(data, property, face);
        } else if (property.count_type) {
          skip_list(data, property);
        } else if (face_slots_[k] >= 0) {
          face_numbers_[static_cast<std::size_t>(face_slots_[k])] = data.real(property.type);
        } else {
          data.skip(property.type, 1);
        }
      }
      data.end_element();
      put_face_values(face);
    }
  }

  /// None, and an error, where the file has no such vertex or it is unusable.
  std::optional<MeshCorner> corner(std::int64_t index, const char* at, const char* face) {
    if (index < 0 || static_cast<std::uint64_t>(index) >= attributes_.positions.size()) {
      source_.error(at, fmt::format("vertex index {} is out of range: there are {}, counted from 0", index,
                                    attributes_.positions.size()));
      return std::nullopt;
    }
    if (bad_.check(static_cast<std::size_t>(index), face, source_)) return std::nullopt;
    const int i = static_cast<int>(index);
    return MeshCorner{i, has_uvs_ ? i : -1, has_normals_ ? i : -1};
  }

  template <class Data>
  void read_face(Data& data, const PlyProperty& list, const char* face) {
    const std::uint64_t size = list_size(data, list);
    corners_.clear();
    bool usable = true;
    for (std::uint64_t k = 0; k < size; ++k) {
      const char* at = data.position();
      const std::optional<MeshCorner> read = corner(data.integer(list.type), at, face);
      usable &= read.has_value();
      if (read) corners_.push_back(*read);
    }
    if (!usable) return;
    if (corners_.size() < 3 || !builder_->add_polygon(corners_, -1)) skipped_.add(face);
  }

  /// Every corner after the second makes a triangle with the two before it, every other one the other way round. One
  /// that names a vertex twice only leads to where the strip goes on.
  template <class Data>
  void read_strips(Data& data, const PlyProperty& list, const char* strips) {
    const std::uint64_t size = list_size(data, list);
    std::array<MeshCorner, 3> last;
    std::size_t length = 0;
    for (std::uint64_t k = 0; k < size; ++k) {
      const char* at = data.position();
      const std::int64_t index = data.integer(list.type);
      const std::optional<MeshCorner> read = index == -1 ? std::nullopt : corner(index, at, strips);
      if (!read) {
        length = 0;
        continue;
      }
      last = {last[1], last[2], *read};
      if (++length < 3) continue;
      const auto [a, b, c] = last;
      if (a == b || b == c || c == a) continue;
      const std::array triangle = length % 2 == 1 ? last : std::array{b, a, c};
      if (!builder_->add_polygon(triangle, -1)) skipped_.add(at);
    }
  }

  MeshFile finish() {
    if (skipped_.count > 0) {
      source_.warn(skipped_.first, fmt::format("faces skipped: {} with fewer than 3 corners, without area or whose "
                                               "edges cross (this is the first)",
                                               skipped_.count));
    }
    bad_.warn_unused(source_);
    if (builder_->triangle_count() == 0 && !source_.has_errors()) {
      source_.error_of_empty_mesh(nullptr);
    }
    MeshFile file;
    file.mesh = builder_->finish();
    for (MeshAttribute& attribute : face_values_) file.mesh.attributes.push_back(std::move(attribute));
    file.mesh.part_of_triangle.clear();
    for (const MeshAttribute& attribute : file.mesh.attributes)
      if (!is_finite(attribute))
        file.attribute_faults.push_back(fault_of(attribute, first_bad_.at(attribute.name), source_));
    for (const std::string& warning : builder_->warnings()) source_.warn(nullptr, warning);
    file.skipped_faces = skipped_.count;
    file.warnings = source_.finish();
    return file;
  }

  MeshSource source_;
  PlyHeader header_;
  const PlyElement* vertices_ = nullptr;
  const PlyElement* faces_ = nullptr;
  std::size_t list_ = 0;  // the index of the faces' property with the vertex indices
  bool needs_normals_, are_strips_ = false, has_normals_ = false, has_uvs_ = false;
  MeshAttributes attributes_;
  BadNumbers bad_{"vertex"};
  std::optional<MeshBuilder> builder_;
  std::vector<MeshCorner> corners_;
  std::vector<PlyAttribute> of_faces_;
  std::vector<int> face_slots_;  // of each property of a face: where it stands in face_numbers_; -1: nowhere
  std::vector<double> face_numbers_;
  std::vector<MeshAttribute> face_values_;
  std::map<std::string, const char*> first_bad_;  // of each attribute that is not finite somewhere
  Tally skipped_;
};

}  // namespace

MeshFile read_ply(const std::string& path, const MeshProgress& progress, MeshNormals normals) {
  return PlyReader(path, progress, normals).read();
}

}  // namespace strahl

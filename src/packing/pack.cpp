// SPDX-License-Identifier: MIT
#include "packing/pack.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <stdexcept>

#include "kinds/entries.h"
#include "kinds/integrators.h"
#include "kinds/textures.h"
#include "packing/cl_layout.h"
#include "packing/light_textures.h"
#include "packing/outline.h"
#include "packing/pack_camera.h"
#include "packing/pack_filter.h"
#include "packing/pack_images.h"
#include "packing/pack_instances.h"
#include "packing/pack_lights.h"
#include "packing/pack_materials.h"
#include "packing/pack_media.h"
#include "packing/pack_shapes.h"
#include "packing/path_lengths.h"
#include "packing/shape_parts.h"
#include "packing/shape_ranks.h"
#include "packing/uv_rates.h"
#include "scene/unseen.h"
#include "settings/sampling.h"

namespace strahl {
namespace {

template <typename Real>
class Packing {
 public:
  Packing(const Scene& scene, const Features& features, const PackOptions& options)
      : scene_(scene), features_(features), options_(options) {
    for (const std::int64_t id : first_ids(scene)) first_ids_.push_back(static_cast<std::int32_t>(id));
    for_each_shape(scene, [&](const Shape& shape) { shapes_.push_back(&shape); });
    for (const std::string& kind : list_entries("shapes"))
      if (features.has("shapes", kind)) kinds_.push_back(kind);
    const std::size_t rows = kinds_.size() + (features.flag("INSTANCES") ? 1 : 0);
    media_row_ = layout::HEADER_INTS + static_cast<int>(rows) * layout::SHAPE_INTS;
    const int media = features.flag("MEDIA") ? int{layout::MEDIA_INTS} : 0;
    // A quarter more than the least: what is not written takes no memory.
    packed_.shading.reserve(options.room.shading / sizeof(Real) * 5 / 4);
    packed_.index.reserve(options.room.index / sizeof(std::int32_t) * 5 / 4);
    packed_.index.resize(static_cast<std::size_t>(media_row_ + media), 0);
  }

  PackedScene<Real> run() {
    header();
    materials();
    textures();
    light_of_part_ = pack_lights(packed_, images_, scene_, features_, options_.frame, shapes_, first_ids_);
    pack_last_rays(packed_, scene_, options_.frame);
    parts();
    if (features_.flag("MEDIA"))
      pack_media(packed_, images_, media_row_, scene_, features_, options_.frame, boundaries_);
    shapes();
    return std::move(packed_);
  }

 private:
  std::int32_t& index(int at) { return packed_.at(at); }
  int index_end() const { return packed_.index_end(); }

  void header() {
    const ResolvedSampling sampling = resolve_sampling(scene_);
    index(layout::HEADER_WIDTH) = scene_.film.width;
    index(layout::HEADER_SEED) = static_cast<std::int32_t>(sampling.seed);
    // A film that keeps one sum; who renders says otherwise.
    index(layout::HEADER_SUMS) = index(layout::HEADER_SEQUENCES) = 1;
    index(layout::HEADER_INTEGRATOR) = features_.entry_index("integrators", scene_.integrator.name);
    index(layout::HEADER_MAX_DEPTH) = most_surfaces(scene_.integrator);
    index(layout::HEADER_RR_DEPTH) = scene_.integrator.rr_depth;
    index(layout::HEADER_REACH) = packed_.put_shading({std::min(
        options_.frame.scale * scene_.integrator.max_distance, static_cast<double>(std::numeric_limits<Real>::max()))});
    index(layout::HEADER_SAMPLER) = features_.entry_index("samplers", sampler_entry(sampling.kind));
    index(layout::HEADER_HIDE_EMITTERS) = scene_.integrator.hide_emitters ? 1 : 0;
    index(layout::HEADER_STRICT_NORMALS) = scene_.integrator.strict_normals ? 1 : 0;
    index(layout::HEADER_CAMERA) = packed_.put_shading(camera_reals(scene_, sampling.kind, options_.frame));
    const bool has_sensor = kinds::integrator(scene_.integrator.name).from_lights;
    index(layout::HEADER_SENSOR) =
        has_sensor ? packed_.put_shading(sensor_reals(scene_.camera, scene_.film, options_.frame)) : -1;
    pack_film(packed_, scene_, features_);
  }

  void materials() {
    index(layout::HEADER_MATERIALS) = index_end();
    const auto slot_of = [this](const MaterialSlot& slot) {
      std::array<double, 3> reals = slot.reals;
      if (slot.has_length) reals[2] *= options_.frame.scale;
      return slot.texture < 0 ? packed_.put_shading(reals) : ~texture_row(slot);
    };
    for (std::size_t row = 0; row < scene_.materials.size(); ++row) {
      const PackedMaterial packed = packed_material(row, scene_, features_, numbers_);
      packed_.index.insert(packed_.index.end(), {packed.kind, packed.back, packed.has_along ? 1 : 0,
                                                 features_.flag("MASK") ? slot_of(packed.opacity) : 0, packed.first,
                                                 packed.second, packed.indices});
      if (packed.slots.size() > layout::MATERIAL_MOST_SLOTS)
        throw std::logic_error("a material has more parameters than MATERIAL_MOST_SLOTS");
      for (const MaterialSlot& slot : packed.slots) packed_.index.push_back(slot_of(slot));
      packed_.index.resize(packed_.index.size() + layout::MATERIAL_MOST_SLOTS - packed.slots.size(), 0);
    }
  }

  /// What is no colour is not filtered: it has the rows behind.
  int texture_row(const MaterialSlot& slot) const {
    const bool is_filtered = (slot.is_share && slot.is_colour) || !features_.flag("TEXTURE_LOD");
    return slot.texture + (is_filtered ? 0 : checked_offset(scene_.textures.size()));
  }

  void textures() {
    std::vector<std::int32_t> rows;
    put_textures(rows, features_.flag("TEXTURE_LOD"));
    if (features_.flag("TEXTURE_LOD")) put_textures(rows, false);
    const int at = packed_.put_index(rows);
    index(layout::HEADER_TEXTURES) = at;
  }

  void put_textures(std::vector<std::int32_t>& rows, bool has_levels) {
    for (const Texture& texture : scene_.textures) {
      const kinds::TextureFacts facts = kinds::texture(texture);
      const int kind = numbers_("textures", facts.entry);
      int parts = resolve_sampling(scene_).kind == SamplerKind::centre ? 1 : 8;
      // How wide a pixel is there, a path from a light cannot know.
      if (kinds::integrator(scene_.integrator.name).from_lights) parts = std::numeric_limits<int>::max();
      rows.insert(rows.end(), {kind, packed_.put_shading(facts.reals), 0, parts, 0, 1});
      const std::span last = std::span(rows).last(layout::TEXTURE_INTS);
      if (kind >= 0 && !facts.attribute.empty()) last[layout::TEXTURE_IMAGE] = attribute_number(facts.attribute);
      if (kind < 0 || facts.bitmap == nullptr) continue;
      const Texels& texels = *facts.bitmap->texels;
      const TexelCurve& curve = facts.bitmap->curve;
      if (has_levels && facts.bitmap->filter != TextureFilter::nearest) {
        const typename PackedImages<Real>::Levels levels = images_.levels(texels, curve);
        last[layout::TEXTURE_IMAGE] = levels.row;
        last[layout::TEXTURE_LEVELS] = levels.count;
      } else {
        last[layout::TEXTURE_IMAGE] = images_.row(texels, curve);
      }
      last[layout::TEXTURE_FILTER] = static_cast<std::int32_t>(facts.bitmap->filter);
      last[layout::TEXTURE_WRAP] = static_cast<std::int32_t>(facts.bitmap->wrap);
    }
  }

  int attribute_number(const std::string& name) {
    const auto found = std::find(attributes_.begin(), attributes_.end(), name);
    if (found == attributes_.end()) attributes_.push_back(name);
    return static_cast<int>(std::find(attributes_.begin(), attributes_.end(), name) - attributes_.begin());
  }

  /// PART_ATTRIBUTES of a mesh; -1 where it has none that the program reads.
  int put_attributes(const Mesh& mesh) {
    if (attributes_.empty() || mesh.attributes.empty()) return -1;
    std::vector<std::int32_t> table(2 * attributes_.size(), 0);
    for (std::size_t i = 0; i < attributes_.size(); ++i)
      for (const MeshAttribute& attribute : mesh.attributes) {
        if (attribute.name != attributes_[i]) continue;
        const auto reals = [](const Rgb& c) { return std::array{c.r, c.g, c.b}; };
        table[2 * i] = checked_offset(packed_.shading.size());
        table[2 * i + 1] = attribute.is_of_faces() ? 3 : 9;
        if (attribute.is_of_faces())
          for (const Rgb& value : attribute.values) packed_.put_rgb(value);
        else
          put_corners(mesh, attribute.values, true, reals);
      }
    return packed_.put_index(table);
  }

  /// Per-corner attributes of a mesh, three corners a triangle; -1 where the program has no use for them.
  template <typename Vector, typename Components>
  int put_corners(const Mesh& mesh, const std::vector<Vector>& attribute, bool wanted, Components components) {
    if (!wanted || attribute.empty()) return -1;
    const int at = checked_offset(packed_.shading.size());
    for (const auto& triangle : mesh.triangles)
      for (const int corner : triangle)
        for (const double x : components(attribute[static_cast<std::size_t>(corner)]))
          packed_.shading.push_back(static_cast<Real>(x));
    return at;
  }

  int rank_of(const Shape& shape, const MeshPart& look) const {
    const auto rank = ranks_.find(&shape);
    if (rank == ranks_.end()) return -1;
    const bool has_media = features_.flag("MEDIA") && kinds::integrator(scene_.integrator.name).goes_through;
    if (has_media && is_passed_boundary(shape, scene_)) return rank->second;
    return material_facts(scene_.materials.at(static_cast<std::size_t>(look.material))).is_boundary ? rank->second : -1;
  }

  void parts() {
    ranks_ = shape_ranks(shapes_);
    for (const Shape* shape : shapes_) {
      const auto* mesh = std::get_if<Mesh>(&shape->geometry);
      attributes_at_.push_back(mesh != nullptr ? put_attributes(*mesh) : -1);
    }
    index(layout::HEADER_PARTS) = index_end();
    put_parts(scene_.shapes, options_.frame);
    for (const Group& group : scene_.groups) put_parts(group.shapes, group_frame(group, options_.frame));
  }

  /// Of the scene or, behind it, of a group.
  void put_parts(const std::vector<Shape>& shapes, const UploadFrame& frame_in_use) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Shape& shape = shapes[i];
      const auto number = static_cast<std::int32_t>(first_part_.size());
      const std::int32_t first_id = first_ids_[first_part_.size()];
      first_part_.push_back(part_rows_);
      int frame_at = -1, normals_at = -1, uvs_at = -1, attributes_at = -1, rates_at = -1;
      if (const auto frame = surface_frame(shape.geometry, frame_in_use)) frame_at = packed_.put_shading(*frame);
      if (has_textures_) {
        const Vec2 rates = uv_rates(shape.geometry, frame_in_use);
        rates_at = packed_.put_shading({rates.x, rates.y});
      }
      if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
        normals_at = put_corners(*mesh, mesh->normals, features_.flag("SMOOTH_NORMALS"), [](const Vec3& n) {
          return std::array{n.x, n.y, n.z};
        });
        uvs_at = put_corners(*mesh, mesh->uvs, features_.flag("MESH_UVS"), [](const Vec2& uv) {
          return std::array{uv.x, uv.y};
        });
        attributes_at = attributes_at_[first_part_.size() - 1];
      }
      for (int part = 0; part < part_count(shape); ++part) {
        const MeshPart look = look_of_part(shape, part);
        const TexturedColour radiance =
            textured_colour(look.radiance.value_or(Rgb{}), look.radiance_texture, scene_, features_);
        const bool is_hidden_beam = shape.exitance && scene_.integrator.hide_emitters;  // Of black radiance.
        const int radiance_at = look.radiance || is_hidden_beam ? packed_.put_rgb(radiance.colour) : -1;
        const int light = light_of_part_[static_cast<std::size_t>(part_rows_)];
        packed_.index.insert(packed_.index.end(), {number, first_id, look.material, radiance_at, radiance.row, light,
                                                   shape.flip_normals != faces_inward(shape.geometry) ? 1 : 0, frame_at,
                                                   normals_at, uvs_at, attributes_at, rates_at, rank_of(shape, look)});
        boundaries_.push_back(shape.media);
        ++part_rows_;
      }
    }
  }

  using Chosen = std::function<bool(const Shape&)>;
  static bool all_shapes(const Shape&) { return true; }

  /// Every primitive of one kind among those of `shapes` that are chosen, the first of which is number `first` of all.
  KindList<Real> primitives_of(const std::string& kind, const std::vector<Shape>& shapes, std::size_t first,
                               const UploadFrame& frame, const Chosen& is_chosen) {
    KindList<Real> list;
    list.kind = kind;
    list.planes = planes_of(kind);
    std::size_t count = 0;
    for (const Shape& shape : shapes)
      if (shape_kind(shape) == kind && is_chosen(shape)) count += static_cast<std::size_t>(primitive_count(shape));
    list.values.reserve(count * static_cast<std::size_t>(list.planes));
    list.ids.reserve(count);
    list.parts.reserve(count);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Shape& shape = shapes[i];
      if (shape_kind(shape) != kind || !is_chosen(shape)) continue;
      std::int32_t primitive = 0;
      primitive_planes(shape.geometry, frame, [&](std::span<const double> values) {
        for (const double value : values) list.values.push_back(static_cast<Real>(value));
        list.ids.push_back(first_ids_[first + i] + primitive);
        list.parts.push_back(first_part_[first + i] + part_of_primitive(shape, primitive));
        ++primitive;
      });
    }
    return list;
  }

  std::vector<KindList<Real>> lists_of(const std::vector<Shape>& shapes, std::size_t first, const UploadFrame& frame,
                                       const Chosen& is_chosen = all_shapes) {
    std::vector<KindList<Real>> lists;
    for (const std::string& kind : kinds_) lists.push_back(primitives_of(kind, shapes, first, frame, is_chosen));
    return lists;
  }

  int put_geometry(const std::vector<Real>& values) {
    const int at = checked_offset(packed_.geometry.size());
    packed_.geometry.insert(packed_.geometry.end(), values.begin(), values.end());
    return at;
  }

  /// A tree for every group, and what the kernels know of every instance, in order.
  void groups(TreeOptions& options) {
    if (!has_instances_) return;
    const int entries = options.stack;
    options.stack = entries / 2;
    options.outline = outline_size(scene_.instances.size());
    std::size_t first = scene_.shapes.size();
    int need = 0;
    for (const Group& group : scene_.groups) {
      const UploadFrame frame = group_frame(group, options_.frame);
      groups_.push_back(pack_tree<Real>(lists_of(group.shapes, first, frame), {}, options));
      first += group.shapes.size();
      need = std::max(need, groups_.back().stack_need);
    }
    options.stack = entries - need - 1;
    options.outline = 0;
    instances_.reserve(scene_.instances.size() * layout::INSTANCE_REALS);
    for (const Instance& instance : scene_.instances) {
      const auto group = static_cast<std::size_t>(instance.group);
      const UploadFrame frame = group_frame(scene_.groups[group], options_.frame);
      const auto reals = instance_reals<Real>(frame_from_group(instance, frame, options_.frame), groups_[group].box(),
                                              groups_[group].outline, instance.where);
      instances_.insert(instances_.end(), reals.begin(), reals.end());
      std::copy_n(reals.begin() + layout::INSTANCE_BOX, 6, instance_boxes_.emplace_back().begin());
    }
  }

  /// Where its row is.
  int put_group(PackedTree<Real>& tree, const PackedTree<Real>& group, int width) {
    const AppendedTree appended = append_tree(tree, group, width);
    const int at = index_end();
    packed_.put_index(std::vector{appended.root, put_geometry(group.reach)});
    for (const auto& listed : appended.listed)
      packed_.put_index(std::vector<std::int32_t>{listed.begin(), listed.end()});
    return at;
  }

  void put_instances(PackedTree<Real>& tree, int width) {
    std::vector<std::int32_t> rows;
    for (const PackedTree<Real>& group : groups_) rows.push_back(put_group(tree, group, width));
    const int row = layout::HEADER_INTS + static_cast<int>(kinds_.size()) * layout::SHAPE_INTS;
    const int count = checked_offset(scene_.instances.size());
    const int geometry_at = put_geometry(instances_), groups_at = index_end();
    for (const Instance& instance : scene_.instances)
      packed_.index.push_back(std::int32_t{rows[static_cast<std::size_t>(instance.group)]});
    index(row + layout::SHAPE_BLOCKS) = count;
    index(row + layout::SHAPE_GEOMETRY) = geometry_at;
    index(row + layout::SHAPE_IDS) = groups_at;
    index(row + layout::SHAPE_LISTED) = tree.lists_instances ? count : 0;
  }

  void shapes() {
    const int width = options_.lanes > 1 ? options_.lanes : options_.tree_width == 0 ? 4 : options_.tree_width;
    TreeOptions options{width, options_.acceleration, stack_entries(width)};
    // The program walks trees then, whatever is in them: a list saves no text, and costs time even for three shapes.
    if (has_instances_ && options.acceleration == Acceleration::automatic) options.acceleration = Acceleration::tree;
    groups(options);
    const Chosen apart = [&](const Shape& shape) { return stands_apart_as_boundary(shape, scene_, features_); };
    const auto lists = [&](const Chosen& chosen) { return lists_of(scene_.shapes, 0, options_.frame, chosen); };
    PackedTree<Real> tree = pack_tree<Real>(lists(std::not_fn(apart)), instance_boxes_, options);
    if (has_instances_) put_instances(tree, width);
    if (std::any_of(scene_.shapes.begin(), scene_.shapes.end(), apart))
      index(media_row_ + layout::MEDIA_BOUNDARIES) = put_group(tree, pack_tree<Real>(lists(apart), {}, options), width);
    int row = layout::HEADER_INTS;
    for (const PackedKind<Real>& kind : tree.kinds) {
      index(row + layout::SHAPE_BLOCKS) = checked_offset(kind.ids.size() / static_cast<std::size_t>(options_.lanes));
      index(row + layout::SHAPE_GEOMETRY) = put_geometry(kind.blocks);
      index(row + layout::SHAPE_LISTED) = kind.listed;
      const int ids_at = packed_.put_index(kind.ids);
      index(row + layout::SHAPE_IDS) = ids_at;
      packed_.put_index(kind.parts);
      row += layout::SHAPE_INTS;
    }
    index(layout::HEADER_ROOT) = tree.root;
    index(layout::HEADER_NODES) = put_geometry(tree.nodes);
    index(layout::HEADER_BOUNDS) = put_geometry(tree.reach);
    const int children_at = packed_.put_index(tree.children);
    index(layout::HEADER_CHILDREN) = children_at;
    for (const std::size_t end : {packed_.geometry.size(), packed_.shading.size(), packed_.index.size()})
      checked_offset(end);
    packed_.tree = tree.stats;
  }

  const Scene& scene_;
  const Features& features_;
  const PackOptions& options_;
  PackedScene<Real> packed_;
  PackedImages<Real> images_{packed_};
  EntryNumbers numbers_{features_};
  bool has_textures_ = !features_.entries.at("textures").empty() && !scene_.textures.empty();
  bool has_instances_ = features_.flag("INSTANCES") && !scene_.instances.empty();
  std::vector<const Shape*> shapes_;  ///< As for_each_shape has them.
  std::vector<std::string> kinds_;    ///< Active ones.
  std::vector<std::int32_t> first_ids_;
  std::vector<int> first_part_, light_of_part_;
  int part_rows_ = 0;
  int media_row_ = 0;                                      ///< Where the row of media is, in programs with MEDIA.
  std::vector<std::optional<MediumBoundary>> boundaries_;  ///< Of each part.
  std::vector<int> attributes_at_;                         ///< Of each of the shapes.
  std::vector<std::string> attributes_;                    ///< Of meshes, that textures show, by their number.
  std::map<const Shape*, int> ranks_;
  std::vector<PackedTree<Real>> groups_;
  std::vector<Real> instances_;  ///< INSTANCE_REALS each.
  std::vector<Bounds<Real>> instance_boxes_;
};

}  // namespace

template <typename Real>
PackedScene<Real> pack_scene(const Scene& scene, const Features& features, const PackOptions& options) {
  return Packing<Real>(scene, features, options).run();
}

template PackedScene<float> pack_scene(const Scene&, const Features&, const PackOptions&);
template PackedScene<double> pack_scene(const Scene&, const Features&, const PackOptions&);

}  // namespace strahl

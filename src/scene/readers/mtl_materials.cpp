// SPDX-License-Identifier: MIT
#include "scene/readers/mtl_materials.h"

#include <fmt/format.h>

#include <algorithm>

#include "image/file_bytes.h"
#include "kinds/textures.h"
#include "scene/readers/read_texture.h"
#include "scene/xml/color_value.h"

namespace strahl {
namespace {

double brightest(const Rgb& c) { return std::max({c.r, c.g, c.b}); }
class Import {
 public:
  Import(const MeshMaterial& from, const Shape& shape, Scene& scene, ImageFiles& images, Diagnostics& diagnostics)
      : from_(from), shape_(shape), scene_(scene), images_(images), diagnostics_(diagnostics) {}

  int run() {
    switch (from_.illumination) {
      case 3:
      case 5:
      case 8:
        return mirror();
      case 4:
      case 6:
      case 7:
      case 9:
        return glass();
      default:
        return highlight();
    }
  }

 private:
  int glass() {
    Dielectric glass;
    glass.int_ior = from_.index;
    const double most = brightest(from_.filter);
    if (most > 0) glass.transmittance.color = kinds::times(1 / most, from_.filter);
    Material material = named(glass);
    material.twosided = false;
    return add(in_relief(material));
  }

  int highlight() {
    const Reflectance base = base_reflectance();
    const Rgb specular = specular_beside(base.color);
    if (from_.illumination < 2 || from_.exponent <= 0 || brightest(specular) <= 0) return opaque(named(Diffuse{base}));
    const Varying exponent{{from_.exponent, from_.exponent, from_.exponent}};
    return opaque(named(Phong{base, {specular}, exponent}));
  }

  /// A blend in which each of the two has the share of its brightest colour. Where these are of different channels and
  /// more than 1 together, no two shares hold both, and each is as much darker.
  int mirror() {
    const Reflectance base = base_reflectance();
    const Rgb specular = specular_beside(base.color);
    const double rest = brightest(base.color), mirrored = brightest(specular), both = rest + mirrored;
    if (mirrored <= 0) return opaque(named(Diffuse{base}));
    if (rest <= 0) return opaque(named(Conductor{{specular}}));
    const double share = mirrored / both, kept = std::min(both, 1.0);
    Reflectance own = base;
    own.color = kinds::times(kept / rest, base.color);
    if (own.texture >= 0) std::get<Bitmap>(scene_.textures.back().pattern).scale = own.color;
    Blend blend;
    blend.weight.color = {share, share, share};
    blend.first = add(twosided(named(Diffuse{own})));
    blend.second = add(twosided(named(Conductor{{kinds::times(kept / mirrored, specular)}})));
    return opaque(named(blend));
  }

  Rgb specular_beside(const Rgb& base) const {
    return {std::min(from_.specular.r, 1 - base.r), std::min(from_.specular.g, 1 - base.g),
            std::min(from_.specular.b, 1 - base.b)};
  }

  Reflectance base_reflectance() {
    Reflectance base{
        clamped_reflectance(from_.reflectance, shape_.where, fmt::format("Kd of {}", from_.name), diagnostics_)};
    if (from_.reflectance_map) base.texture = added_texture(*from_.reflectance_map, base.color, {}, true, "Kd stands");
    return base;
  }

  template <typename Bsdf>
  Material named(const Bsdf& bsdf) const {
    Material material;
    material.id = from_.name;
    material.bsdf = bsdf;
    material.where = shape_.where;
    return material;
  }

  static Material twosided(Material material) {
    material.twosided = true;
    return material;
  }

  int opaque(const Material& from) {
    Material material = in_relief(twosided(from));
    if (from_.opacity < 1 || from_.opacity_map) {
      Reflectance opacity{{from_.opacity, from_.opacity, from_.opacity}};
      if (from_.opacity_map)
        opacity.texture =
            added_texture(*from_.opacity_map, opacity.color, {TexelCurve::Kind::linear}, true, "d stands");
      material.opacity = opacity;
    }
    return add(material);
  }

  /// The material itself where there is no map, or none that can be read.
  Material in_relief(const Material& material) {
    const bool has_heights = !from_.normal_map;
    const std::optional<MeshTexture>& map = has_heights ? from_.bump_map : from_.normal_map;
    if (!map) return material;
    Relief relief;
    relief.kind = has_heights ? Relief::Kind::heights : Relief::Kind::normals;
    relief.scale = map->multiplier;
    if (has_heights) relief.map.color = {0, 0, 0};
    relief.map.texture =
        added_texture(*map, {1, 1, 1}, {TexelCurve::Kind::linear}, false, "the surface stays as smooth as it is",
                      has_heights ? TexelUse::heights : TexelUse::light);
    if (relief.map.texture < 0) return material;
    relief.nested = add(material);
    Material bent = named(relief);
    bent.twosided = material.twosided;
    return bent;
  }

  int add(const Material& material) {
    scene_.materials.push_back(material);
    return static_cast<int>(scene_.materials.size()) - 1;
  }

  /// Its index; -1 where the file cannot be read. is_share: of light, at most 1.
  int added_texture(const MeshTexture& from, const Rgb& scale, const TexelCurve& curve, bool is_share,
                    const char* otherwise, TexelUse use = TexelUse::light) {
    const std::string obstacle = unreadable_because(from.file);
    if (!obstacle.empty()) {
      diagnostics_.warning(from.where, fmt::format("cannot read \"{}\": {}; {}", from.file, obstacle, otherwise));
      return -1;
    }
    Bitmap bitmap;
    // Mitsuba reads no MTL, so that a map of one refuses no scene.
    Diagnostics told(false);
    bitmap.texels = images_.read(from.file, from.where, told, use);
    for (const std::string& file : told.files()) diagnostics_.opened(file);
    for (const Diagnostic& one : told.in_file_order())
      diagnostics_.warning(one.where, bitmap.texels ? one.message : fmt::format("{}; {}", one.message, otherwise));
    if (!bitmap.texels) return -1;
    bitmap.curve = curve;
    bitmap.scale = scale;
    bitmap.wrap = from.is_clamped ? TextureWrap::clamp : TextureWrap::repeat;
    // v counts from the bottom in the file and from the top in the mesh.
    bitmap.to_uv = {from.scale.x, 0, from.offset.x, 0, from.scale.y, 1 - from.scale.y - from.offset.y};
    bitmap.mean = kinds::mean_of(*bitmap.texels, bitmap.curve);
    if (is_share) clamp_to_one(bitmap, from.where, diagnostics_);
    scene_.textures.push_back({"", bitmap, from.where});
    return static_cast<int>(scene_.textures.size()) - 1;
  }

  const MeshMaterial& from_;
  const Shape& shape_;
  Scene& scene_;
  ImageFiles& images_;
  Diagnostics& diagnostics_;
};

}  // namespace

int added_material(const MeshMaterial& from, const Shape& shape, Scene& scene, ImageFiles& images,
                   Diagnostics& diagnostics) {
  return Import(from, shape, scene, images, diagnostics).run();
}

}  // namespace strahl

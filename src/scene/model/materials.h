// SPDX-License-Identifier: MIT
// How surfaces scatter light: the materials of a scene, with Mitsuba's defaults. What holds for each of them:
// kinds/materials.h.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "errors.h"
#include "scene/model/vec.h"

namespace strahl {

/// A share of the light, within [0, 1].
struct Reflectance {
  Rgb color;
  int texture = -1;  ///< Index into Scene::textures, whose colour then takes this one's place; -1: none.
};

/// A value that a texture may vary as well; not held to [0, 1].
using Varying = Reflectance;

/// Lambertian reflectance rho.
struct Diffuse {
  Reflectance reflectance{{0.5, 0.5, 0.5}};
};

/// Index of refraction eta + i k of a metal over that outside. The default reflects everything at every angle.
struct MetalIndex {
  Varying eta{{0, 0, 0}};
  Varying k{{1, 1, 1}};
};

/// Smooth metal.
struct Conductor {
  Reflectance reflectance{{1, 1, 1}};
  MetalIndex index = {};
};

enum class MicrofacetKind { beckmann, ggx };

/// Rough surfaces: alpha along u and v. Alike in both, that of Beckmann is the root mean square slope of microfacets.
struct Microfacets {
  MicrofacetKind kind = MicrofacetKind::beckmann;
  Varying alpha_u{{0.1, 0.1, 0.1}};
  Varying alpha_v{{0.1, 0.1, 0.1}};
  bool sample_visible = true;  ///< Draws normals that are seen; false: any. The picture's mean is the same.
};

struct RoughConductor {
  Reflectance reflectance{{1, 1, 1}};
  MetalIndex index = {};
  Microfacets microfacets = {};
};

/// Smooth boundary between two media that absorb nothing. Indices of refraction, > 0: behind the normal, before it.
struct Dielectric {
  double int_ior = 1.5046;    ///< bk7
  double ext_ior = 1.000277;  ///< air
  Reflectance reflectance{{1, 1, 1}};
  Reflectance transmittance{{1, 1, 1}};
};

/// As Dielectric, rough.
struct RoughDielectric {
  Dielectric glass = {};
  Microfacets microfacets = {};
};

/// A pane of it, as one surface.
struct ThinDielectric {
  Dielectric glass = {};
};

/// A diffuse base under a smooth dielectric.
struct Plastic {
  double int_ior = 1.49;      ///< polypropylene
  double ext_ior = 1.000277;  ///< air
  Reflectance diffuse_reflectance{{0.5, 0.5, 0.5}};
  Reflectance specular_reflectance{{1, 1, 1}};
  bool nonlinear = false;  ///< Light that is reflected within takes the base's colour every time.
};

/// As Plastic, under a rough one, alike along u and v, not textured.
struct RoughPlastic {
  Plastic plastic = {};
  Microfacets microfacets = {};
};

/// B. Burley's material of many looks; each number lies within [0, 1].
struct Principled {
  Reflectance base_color{{0.5, 0.5, 0.5}};
  Varying roughness{{0.5, 0.5, 0.5}};
  Varying anisotropic{{0, 0, 0}};  ///< Of the roughness: wider along u.
  Varying metallic{{0, 0, 0}};
  Varying spec_trans{{0, 0, 0}};  ///< The share of what is no metal that is glass.
  Varying spec_tint{{0, 0, 0}};
  Varying sheen{{0, 0, 0}};
  Varying sheen_tint{{0, 0, 0}};
  Varying flatness{{0, 0, 0}};
  Varying clearcoat{{0, 0, 0}};
  Varying clearcoat_gloss{{0, 0, 0}};
  double eta = 1.5;  ///< Index of refraction inside over outside.
  /// How often each lobe is drawn, next to the others.
  double main_specular_sampling_rate = 1, clearcoat_sampling_rate = 1, diffuse_reflectance_sampling_rate = 1;
};

/// The same of a sheet, alike from both sides.
struct PrincipledThin {
  Reflectance base_color{{0.5, 0.5, 0.5}};
  Varying roughness{{0.5, 0.5, 0.5}};
  Varying anisotropic{{0, 0, 0}};
  Varying spec_trans{{0, 0, 0}};
  Varying spec_tint{{0, 0, 0}};
  Varying sheen{{0, 0, 0}};
  Varying sheen_tint{{0, 0, 0}};
  Varying flatness{{0, 0, 0}};
  Varying diff_trans{{0, 0, 0}};  ///< From 0 to 2, where all of the base's light goes through.
  Varying eta{{1.5, 1.5, 1.5}};
  double specular_reflectance_sampling_rate = 1, specular_transmittance_sampling_rate = 1;
  double diffuse_reflectance_sampling_rate = 1, diffuse_transmittance_sampling_rate = 1;
};

/// A highlight of Mitsuba 0.x over a diffuse base.
struct Phong {
  Reflectance diffuse_reflectance{{0.5, 0.5, 0.5}};
  Reflectance specular_reflectance{{0.2, 0.2, 0.2}};
  Varying exponent{{30, 30, 30}};
};

/// Ward's highlight of Mitsuba 0.x over a diffuse base.
struct Ward {
  enum class Variant { ward, ward_duer, balanced };
  Variant variant = Variant::balanced;
  Reflectance diffuse_reflectance{{0.5, 0.5, 0.5}};
  Reflectance specular_reflectance{{0.2, 0.2, 0.2}};
  Varying alpha_u{{0.1, 0.1, 0.1}};
  Varying alpha_v{{0.1, 0.1, 0.1}};
};

/// Oren's and Nayar's diffuse facets, of Mitsuba 0.x.
struct RoughDiffuse {
  Reflectance reflectance{{0.5, 0.5, 0.5}};
  Varying alpha{{0.2, 0.2, 0.2}};  ///< sqrt(2) times the standard deviation of the facets' angle.
  bool use_fast_approx = false;
};

/// A diffuse sheet of Mitsuba 0.x: all that it scatters goes through.
struct DiffTrans {
  Reflectance transmittance{{0.5, 0.5, 0.5}};
};

/// Two other materials, each for a share of the light.
struct Blend {
  Reflectance weight{{0.5, 0.5, 0.5}};  ///< The share of the second.
  /// Indices into Scene::materials, of materials before this one.
  int first = -1, second = -1;
};

/// Another material, whose normals a texture bends.
struct Relief {
  enum class Kind {
    normals,  ///< The texture holds them relative to the surface's frame, x -> (x + 1) / 2.
    heights   ///< Over the surface, in units of the scene.
  };
  Kind kind = Kind::normals;
  Varying map{{0.5, 0.5, 1}};
  double scale = 1;                    ///< Multiplies heights.
  bool flip_invalid_normals = true;    ///< Turns a normal that faces away from the view.
  bool use_shadowing_function = true;  ///< Fades shallow light.
  int nested = -1;                     ///< As of a Blend.
};

/// A smooth layer of glass over another material, of Mitsuba 0.x.
struct Coat {
  double int_ior = 1.5046;    ///< bk7
  double ext_ior = 1.000277;  ///< air
  double thickness = 1;
  Varying sigma_a{{0, 0, 0}};  ///< Absorption per unit of the thickness.
  Reflectance specular_reflectance{{1, 1, 1}};
  int nested = -1;  ///< As of a Blend; it lets no light through.
};

struct Material {
  std::string id;
  std::variant<Diffuse, Conductor, Dielectric, RoughConductor, RoughDielectric, ThinDielectric, Plastic, RoughPlastic,
               Principled, PrincipledThin, Phong, RoughDiffuse, DiffTrans, Ward, Blend, Relief, Coat>
      bsdf;
  bool twosided = false;  ///< false: black from behind, as in Mitsuba. Of what transmits light it says nothing.
  SourceLocation where;
  /// Index into Scene::materials of what a twosided one is from behind; -1: what it is from the front.
  int back = -1;
  /// The share of rays that meet it; the others go on as if nothing were there. None: all.
  std::optional<Reflectance> opacity = std::nullopt;
};

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "kinds/entries.h"

#include "kinds/lights.h"
#include "kinds/textures.h"

namespace strahl {
namespace {

struct ShapeEntry {
#define SHAPE_KIND(S, kind, area, types) \
  std::string operator()(const S&) const { return #kind; }
#include "kinds/shapes.def"
#undef SHAPE_KIND
};

struct AreaEntry {
#define SHAPE_KIND(S, kind, area, types) \
  std::string operator()(const S&) const { return #area; }
#include "kinds/shapes.def"
#undef SHAPE_KIND
};

}  // namespace

std::string shape_kind(const Shape& shape) { return std::visit(ShapeEntry{}, shape.geometry); }

std::string area_kind(const Geometry& geometry) {
  const std::string area = std::visit(AreaEntry{}, geometry);
  return area == "none" ? "" : area;
}

std::string light_kind(const Light& light) { return kinds::light(light).entry; }

std::string texture_kind(const Texture& texture) { return kinds::texture(texture).entry; }

std::string medium_entry(const Medium& medium) { return medium.is_heterogeneous() ? "heterogeneous" : "homogeneous"; }

std::string phase_entry(PhaseFunction::Kind kind) {
  switch (kind) {
    case PhaseFunction::Kind::hg:
      return "hg";
    case PhaseFunction::Kind::rayleigh:
      return "rayleigh";
    default:
      return "isotropic";
  }
}

std::string sampler_entry(SamplerKind kind) { return kind == SamplerKind::independent ? "independent" : "sobol"; }

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "kinds/lights.h"

#include <algorithm>
#include <type_traits>
#include <variant>

#include "kinds/integrators.h"
#include "kinds/light_rows.h"
#include "kinds/materials.h"
#include "kinds/textures.h"
#include "scene/open_media.h"

namespace strahl::kinds {
namespace {

/// ask(row, emitter) of the light's kind.
template <typename AnyLight, typename Ask>
decltype(auto) of_kind(AnyLight& light, Ask ask) {
  return std::visit(
      [&]<typename Emitter>(Emitter& emitter) -> decltype(auto) {
        return ask(Row<std::remove_const_t<Emitter>>{}, emitter);
      },
      light.emitter);
}

}  // namespace

const LightFacts& light(const Light& light) {
  return of_kind(light, [](auto row, const auto&) -> const LightFacts& { return decltype(row)::facts; });
}

bool finds_all_emission(const Scene& scene) {
  // No ray leaves a medium without an end.
  return integrator(scene.integrator.name).finds_emission() && !open_medium(scene) &&
         std::ranges::all_of(scene.materials, [](const Material& one) { return material_facts(one).draws_all; });
}

bool is_drawn(const Light& light, const Scene& scene) {
  if (!(light.sampling_weight > 0)) return false;
  const LightFacts& facts = kinds::light(light);
  if (facts.is_delta) return integrator(scene.integrator.name).lamps == Lamps::drawn;
  return !(facts.is_even && finds_all_emission(scene));
}

std::vector<double> light_reals(const Light& light, const UploadFrame& frame) {
  return of_kind(light, [&](auto row, const auto& emitter) { return row.reals(emitter, frame); });
}

LightReach light_reach(const Light& light, const UploadFrame& frame) {
  LightReach reach;
  reach.is_far = kinds::light(light).is_far;
  of_kind(light, [&](auto row, const auto& emitter) { row.reach(reach, emitter, frame); });
  reach.weight = light.sampling_weight;
  return reach;
}

const Rgb& light_colour(const Light& light) {
  return of_kind(light, [](auto row, const auto& emitter) -> const Rgb& { return emitter.*row.colour; });
}

Rgb& light_colour(Light& light) {
  return of_kind(light, [](auto row, auto& emitter) -> Rgb& { return emitter.*row.colour; });
}

Rgb brightest(const Light& light) {
  const Rgb colour = light_colour(light);
  const auto* environment = std::get_if<EnvironmentLight>(&light.emitter);
  if (environment == nullptr || !environment->texels) return colour;
  return times(colour, brightest_of(*environment->texels, environment->curve));
}

int light_texture(const Light& light) {
  return of_kind(light, [](auto, const auto& emitter) {
    if constexpr (requires { emitter.texture; }) return emitter.texture;
    return -1;
  });
}

bool gives_light(const Rgb& radiance) { return radiance.r > 0 || radiance.g > 0 || radiance.b > 0; }

bool gives_light(const Shape& shape) {
  if (shape.radiance && gives_light(*shape.radiance)) return true;
  const auto* mesh = std::get_if<Mesh>(&shape.geometry);
  const auto part_gives = [](const MeshPart& part) { return part.radiance && gives_light(*part.radiance); };
  return mesh != nullptr && std::any_of(mesh->parts.begin(), mesh->parts.end(), part_gives);
}

bool gives_light(const Light& light) {
  const Rgb& colour = light_colour(light);
  return colour.r > 0 || colour.g > 0 || colour.b > 0;
}

bool light_glows(const Light& light_asked) { return !light(light_asked).is_delta && gives_light(light_asked); }

void move(Light& light, const MapVec3& point) {
  of_kind(light, [&](auto row, auto& emitter) { row.move(emitter, point); });
}

void scale(Light& light, double factor) {
  of_kind(light, [&](auto row, auto& emitter) { row.scale(emitter, factor); });
}

void mirror(Light& light, const MapVec3& flip_x) {
  of_kind(light, [&](auto row, auto& emitter) { row.mirror(emitter, flip_x); });
}

std::vector<std::string> light_faults(const Light& light) {
  Faults faults;
  of_kind(light, [&](auto row, const auto& emitter) { row.check(emitter, faults); });
  return faults.take();
}

}  // namespace strahl::kinds

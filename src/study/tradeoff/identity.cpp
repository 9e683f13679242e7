// SPDX-License-Identifier: MIT
#include "study/tradeoff/identity.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "checkpoint/host_sources.h"
#include "json_text.h"
#include "kinds/integrators.h"
#include "opencl/program.h"
#include "opencl/program_cache.h"
#include "packing/pack.h"
#include "program/program_text.h"
#include "study/study_sources.h"

namespace strahl {
namespace {

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// What the points vary is the same in all of them.
Scene common(Scene scene, SamplerKind sampler) {
  scene.sampler = {};
  scene.sampler.kind = sampler;
  scene.sampler.sample_count = 1;
  return scene;
}

std::string content_hash(const Scene& scene) {
  PackOptions options;
  options.acceleration = Acceleration::list;
  const Scene same = common(scene, SamplerKind::sobol);
  const PackedScene<double> packed = pack_scene<double>(same, features_of(same, {}), options);
  return fmt::format("{:016x}",
                     fnv1a(bytes_of(packed.geometry), fnv1a(bytes_of(packed.shading), fnv1a(bytes_of(packed.index)))));
}

std::string code_hash(const Scene& scene) {
  std::string texts;
  for (const SamplerKind sampler : {SamplerKind::sobol, SamplerKind::independent}) {
    const Features features = features_of(common(scene, sampler), {});
    texts += program_source(kinds::integrator(scene.integrator.name).kernel(), features, Precision::robust, 1).text;
    if (features.flag("SHARED_SAMPLES")) texts += sharing_source(features, Precision::robust, 1).text;
  }
  return fmt::format("{:016x}", fnv1a(texts));
}

}  // namespace

std::string StudyIdentity::hash() const { return fmt::format("{:016x}", fnv1a(json())); }

std::string StudyIdentity::json() const {
  nlohmann::ordered_json json;
  for (const auto& [name, value] : parts) json[name] = value;
  return json_text(json);
}

std::string StudyIdentity::difference_from(const std::string& other) const {
  const auto there = nlohmann::ordered_json::parse(other, nullptr, false), here = nlohmann::ordered_json::parse(json());
  for (const auto& [name, value] : here.items()) {
    if (!there.is_object() || !there.contains(name)) return fmt::format("the {} (not stated there)", name);
    if (there[name] != value) return fmt::format("the {} ({} there, {} now)", name, there[name].dump(), value.dump());
  }
  return "";
}

StudyIdentity identity_of(const Device& device, const Scene& scene, int seeds, const std::string& reference) {
  return {{{"version", STRAHL_VERSION},
           {"device", driver_key(device)},
           {"size", fmt::format("{} x {}", scene.film.width, scene.film.height)},
           {"scene", content_hash(scene)},
           {"code", code_hash(scene)},
           {"sources", host_sources_hash()},
           {"sources of studies", study_sources_hash()},
           {"seeds", fmt::format("{}", seeds)},
           {"reference", reference}}};
}

}  // namespace strahl

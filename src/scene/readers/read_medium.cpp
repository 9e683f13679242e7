// SPDX-License-Identifier: MIT
// Media with the parameters of Mitsuba 3, and sigma_s, sigma_a and density of Mitsuba 0.x; strahl's own: emission.
#include "scene/readers/read_medium.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/readers/foreign_plugins.h"
#include "scene/readers/read_volume.h"

namespace strahl {
namespace {

double share_in(Properties& properties, const char* name, double low, double high, double otherwise) {
  const double value = properties.number(name).value_or(otherwise);
  if (value >= low && value <= high) return value;
  properties.diagnostics().error(properties.where(name),
                                 fmt::format("{} is {}; it lies within [{}, {}]", name, value, low, high));
  return otherwise;
}

/// Of a medium, whose draws walk along them; blends are within each other no deeper.
constexpr std::size_t most_phases = 256;

/// A number, or the mean of a colour or of a constvolume.
double weight_of_blend(Properties& properties, SceneBuilder& builder) {
  constexpr double even = 0.5;
  const XmlElement* given = properties.peek("weight");
  if (given == nullptr || given->tag == "float" || given->tag == "integer")
    return properties.number("weight").value_or(even);
  const std::optional<Volume> volume =
      read_volume(properties, builder, "weight", ColorUse::value, {even, even, even}, false);
  return volume ? (volume->value.r + volume->value.g + volume->value.b) / 3 : even;
}

/// Adds what `element` is, with a share, to `phases`. within: the blends that hold it, outermost first. False after an
/// error, which ends the walk: references make a small file a large tree.
bool read_phase(const XmlElement& element, double share, std::vector<const XmlElement*>& within, SceneBuilder& builder,
                std::vector<PhaseFunction>& phases) {
  const auto fail = [&](const std::string& what) {
    builder.diagnostics.error(element.where, what);
    return false;
  };
  if (std::find(within.begin(), within.end(), &element) != within.end()) return fail("a blendphase contains itself");
  if (phases.size() == most_phases || within.size() == most_phases)
    return fail(fmt::format("a medium has more than {} phase functions", most_phases));
  Properties properties(element, builder.ids, builder.diagnostics);
  const std::string_view type = properties.type();
  const std::vector<const XmlElement*> inside = properties.objects("phase");
  if (type == "blendphase") {
    const double given = weight_of_blend(properties, builder);
    const double weight =
        clamped_reflectance({given, given, given}, properties.where("weight"), "weight", builder.diagnostics).r;
    if (inside.size() != 2) return fail("a blendphase has two <phase> inside it");
    properties.report_unknown();
    within.push_back(&element);
    const bool is_whole = read_phase(*inside[0], share * (1 - weight), within, builder, phases) &&
                          read_phase(*inside[1], share * weight, within, builder, phases);
    within.pop_back();
    return is_whole;
  }
  PhaseFunction phase;
  phase.share = share;
  if (type == "hg") {
    phase.kind = PhaseFunction::Kind::hg;
    constexpr double most = 0.9999;
    phase.g = share_in(properties, "g", -most, most, 0.8);
  } else if (type == "rayleigh") {
    phase.kind = PhaseFunction::Kind::rayleigh;
  } else if (type != "isotropic") {
    builder.diagnostics.unknown(element.where,
                                not_available("phase", type, {"isotropic", "hg", "rayleigh", "blendphase"}) +
                                    "; an isotropic one takes its place");
    properties.accept_all();
  }
  properties.report_unknown();
  phases.push_back(phase);
  return true;
}

/// Two pairs of parameters describe the same medium: which one is meant, a file with both does not say.
void require_one_pair(const Properties& properties) {
  const auto first_of = [&](const char* one, const char* other) { return properties.has(one) ? one : other; };
  const char* const split = first_of("sigma_s", "sigma_a");
  const char* const whole = first_of("sigma_t", "albedo");
  if (!properties.has(split) || !properties.has(whole)) return;
  properties.diagnostics().error(properties.where(split),
                                 fmt::format("\"{}\" and \"{}\" contradict each other in one medium; give either "
                                             "sigma_t and albedo, or sigma_s and sigma_a",
                                             split, whole));
}

/// sigma_t and albedo of what Mitsuba 0.x says by what is scattered and absorbed.
void read_coefficients(Properties& properties, SceneBuilder& builder, Medium& medium) {
  require_one_pair(properties);
  const std::optional<Volume> scattered = read_volume(properties, builder, "sigma_s", ColorUse::value, {}, false);
  const std::optional<Volume> absorbed = read_volume(properties, builder, "sigma_a", ColorUse::value, {}, false);
  if (!scattered && !absorbed) return;
  const Rgb s = scattered ? scattered->value : Rgb{0, 0, 0}, a = absorbed ? absorbed->value : Rgb{0, 0, 0};
  const auto share = [](double part, double rest) { return part + rest > 0 ? part / (part + rest) : 0.0; };
  medium.sigma_t = Rgb{s.r + a.r, s.g + a.g, s.b + a.b};
  medium.albedo = Rgb{share(s.r, a.r), share(s.g, a.g), share(s.b, a.b)};
}

/// What both kinds of media have.
Medium read_common(Properties& properties, SceneBuilder& builder, bool is_heterogeneous) {
  Medium medium;
  const double scale = properties.number("scale").value_or(1);
  const auto volume = [&](const char* name, ColorUse use, Volume& value) {
    const std::optional<Volume> given = read_volume(properties, builder, name, use, value.value, is_heterogeneous);
    if (given) value = *given;
  };
  // Of what varies Mitsuba 0.x calls it density.
  const bool has_density = is_heterogeneous && properties.has("density");
  volume(has_density ? "density" : "sigma_t", ColorUse::value, medium.sigma_t);
  volume("albedo", ColorUse::reflectance, medium.albedo);
  volume("emission", ColorUse::emission, medium.emission);
  if (is_heterogeneous)
    make_grid(medium.sigma_t);
  else
    read_coefficients(properties, builder, medium);
  Rgb& sigma_t = medium.sigma_t.value;
  sigma_t = {scale * sigma_t.r, scale * sigma_t.g, scale * sigma_t.b};
  const std::vector<const XmlElement*> phases = properties.objects("phase");
  for (std::size_t i = 1; i < phases.size(); ++i)
    builder.diagnostics.error(phases[i]->where, "a medium has one <phase>; a blendphase holds two");
  if (!phases.empty()) {
    medium.phases.clear();
    std::vector<const XmlElement*> within;
    read_phase(*phases.front(), 1, within, builder, medium.phases);
  }
  medium.samples_emitters = properties.boolean("sample_emitters").value_or(true);
  properties.accept({"has_spectral_extinction", "method", "step_size"});
  return medium;
}

}  // namespace

int medium_index(const XmlElement& element, SceneBuilder& builder) {
  const auto known = builder.medium_indices.find(&element);
  if (known != builder.medium_indices.end()) return known->second;
  Properties properties(element, builder.ids, builder.diagnostics);
  int index = -1;
  const bool is_heterogeneous = properties.type() == "heterogeneous";
  if (is_heterogeneous || properties.type() == "homogeneous") {
    Medium medium = read_common(properties, builder, is_heterogeneous);
    medium.id = properties.id();
    medium.where = element.where;
    builder.scene.media.push_back(std::move(medium));
    index = static_cast<int>(builder.scene.media.size()) - 1;
  } else {
    builder.diagnostics.unknown(element.where,
                                not_available("medium", properties.type(), {"homogeneous", "heterogeneous"}) +
                                    "; it is left out, space is empty");
    properties.accept_all();
  }
  properties.report_unknown();
  builder.medium_indices.emplace(&element, index);
  return index;
}

std::optional<MediumBoundary> read_boundary(Properties& shape, SceneBuilder& builder) {
  std::optional<MediumBoundary> boundary;
  const auto take = [&](const char* name, int MediumBoundary::*side) {
    const XmlElement* given = shape.peek(name);
    if (given == nullptr || given->tag != "medium") return;
    shape.accept({name});
    const int medium = medium_index(*given, builder);
    if (!boundary) boundary.emplace();
    (*boundary).*side = medium;
  };
  take("interior", &MediumBoundary::inside);
  take("exterior", &MediumBoundary::outside);
  return boundary;
}

}  // namespace strahl

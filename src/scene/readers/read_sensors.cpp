// SPDX-License-Identifier: MIT
// Which <sensor> of a scene is the camera. Those of a batch, which Mitsuba shows side by side, are sensors like others.
#include <fmt/format.h>

#include <charconv>
#include <vector>

#include "did_you_mean.h"
#include "scene/model/framing.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

struct Candidate {
  const XmlElement* sensor = nullptr;
  const XmlElement* batch = nullptr;  ///< Null: it stands for itself.
  int in_batch = 1;                   ///< So many share the batch's film.
};

std::vector<const XmlElement*> sensors_inside(const XmlElement& batch, SceneBuilder& builder) {
  Properties properties(batch, builder.ids, builder.diagnostics);
  return properties.objects("sensor");
}

std::vector<Candidate> candidates_of(const std::vector<const XmlElement*>& elements, SceneBuilder& builder) {
  std::vector<Candidate> candidates;
  for (const XmlElement* element : elements) {
    const bool is_batch = element->text("type") == "batch";
    const auto inside = is_batch ? sensors_inside(*element, builder) : std::vector<const XmlElement*>{};
    if (is_batch && inside.empty())
      builder.diagnostics.error(element->where, "<sensor type=\"batch\"> needs a <sensor> inside");
    for (const XmlElement* sensor : inside) candidates.push_back({sensor, element, static_cast<int>(inside.size())});
    if (!is_batch) candidates.push_back({element});
  }
  return candidates;
}

/// By its id, else by its number. Null after an error.
const Candidate* chosen(const std::vector<Candidate>& candidates, const std::string& name, const XmlElement& root,
                        Diagnostics& diagnostics) {
  std::vector<std::string> ids;
  for (const Candidate& candidate : candidates) {
    if (candidate.sensor->text("id") == name) return &candidate;
    if (const auto id = candidate.sensor->attribute("id")) ids.emplace_back(*id);
  }
  std::size_t number = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, fault] = std::from_chars(name.data(), end, number);
  if (fault == std::errc{} && rest == end && number < candidates.size()) return &candidates[number];
  diagnostics.error(root.where, fmt::format("no <sensor> is \"{}\"{}; the scene has {}, counted from 0", name,
                                            did_you_mean(name, ids), candidates.size()));
  return nullptr;
}

/// Mitsuba takes the first, too, but of a batch it shows all.
void tell_others(const std::vector<Candidate>& candidates, Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const Candidate& other = candidates[i];
    std::string message = fmt::format("the first <sensor> is used; this one is left out (--sensor {} takes it)", i);
    if (other.batch != nullptr && other.batch == candidates.front().batch)
      diagnostics.warning(other.sensor->where, std::move(message));
    else
      diagnostics.note(other.sensor->where, std::move(message));
  }
}

/// Each of its sensors has an equal part of its film's width.
void share_batch(const Candidate& candidate, SceneBuilder& builder) {
  Properties batch(*candidate.batch, builder.ids, builder.diagnostics);
  static_cast<void>(batch.objects("sensor"));
  for (const XmlElement* sampler : batch.objects("sampler")) builder.scene.sampler = read_sampler(*sampler, builder);
  for (const XmlElement* film : batch.objects("film")) {
    builder.scene.film = read_film(*film, builder);
    int& width = builder.scene.film.width;
    if (width % candidate.in_batch != 0)
      builder.diagnostics.error(film->where, fmt::format("{} sensors cannot share a film of {} pixels' width evenly",
                                                         candidate.in_batch, width));
    width /= candidate.in_batch;
    builder.scene.film.crop.reset();  // As in Mitsuba.
  }
  batch.accept_all();
}

}  // namespace

void read_sensors(const std::vector<const XmlElement*>& elements, const XmlElement& root, SceneBuilder& builder) {
  const std::vector<Candidate> candidates = candidates_of(elements, builder);
  const std::string& name = builder.sensor;
  if (candidates.empty() && elements.empty() && name.empty()) {
    builder.diagnostics.warning(root.where,
                                "the scene has no <sensor>; a perspective camera that looks along -z frames it");
    builder.scene.camera = camera_framing(bounds(builder.scene));
    return;
  }
  if (name.empty()) tell_others(candidates, builder.diagnostics);
  const Candidate* candidate = name.empty() ? candidates.data() : chosen(candidates, name, root, builder.diagnostics);
  if (candidate == nullptr || candidates.empty()) return;
  read_sensor(*candidate->sensor, builder);
  if (candidate->batch != nullptr) share_batch(*candidate, builder);
}

}  // namespace strahl

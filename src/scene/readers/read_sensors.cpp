// SPDX-License-Identifier: MIT
// Which <sensor> of a scene is the camera. Those of a batch, which Mitsuba shows side by side, are sensors like others.
#include <fmt/format.h>

#include <charconv>
#include <deque>
#include <set>
#include <vector>

#include "did_you_mean.h"
#include "scene/model/framing.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

/// A batch, and what all of its sensors share.
struct Batch {
  const XmlElement* film = nullptr;
  const XmlElement* sampler = nullptr;
  int sensors = 0;
};

struct Candidate {
  const XmlElement* sensor = nullptr;
  const Batch* batch = nullptr;  ///< Null: it stands for itself.
};

/// All sensors of a scene, each once, however often a <ref> names it.
class Candidates {
 public:
  Candidates(const std::vector<const XmlElement*>& elements, SceneBuilder& builder) : builder_(builder) {
    for (const XmlElement* element : elements)
      if (is_new(*element)) element->text("type") == "batch" ? add_batch(*element) : all_.push_back({element});
  }

  [[nodiscard]] const std::vector<Candidate>& all() const { return all_; }

 private:
  bool is_new(const XmlElement& element) { return known_.insert(&element).second; }

  void add_batch(const XmlElement& element) {
    Properties properties(element, builder_.ids, builder_.diagnostics);
    Batch& batch = batches_.emplace_back();
    for (const XmlElement* sensor : properties.objects("sensor")) {
      if (sensor->text("type") == "batch") {
        builder_.diagnostics.error(sensor->where, "a batch of sensors cannot hold another");
      } else if (is_new(*sensor)) {
        all_.push_back({sensor, &batch});
        ++batch.sensors;
      }
    }
    if (batch.sensors == 0)
      builder_.diagnostics.error(element.where, fmt::format("{} needs a <sensor> inside", properties.title()));
    batch.film = only_object(properties, "film");
    batch.sampler = only_object(properties, "sampler");
    properties.accept({"to_world", "shutter_open", "shutter_close"});
    properties.report_unknown();
  }

  SceneBuilder& builder_;
  std::vector<Candidate> all_;
  std::deque<Batch> batches_;  ///< Which stay where they are.
  std::set<const XmlElement*> known_;
};

/// By its id, else by its number. Null after an error.
const Candidate* chosen(const std::vector<Candidate>& candidates, const std::string& name, const XmlElement& root,
                        SceneBuilder& builder) {
  const XmlElement* named = builder.ids.find(name);
  std::vector<std::string> ids;
  for (const Candidate& candidate : candidates) {
    if (candidate.sensor == named) return &candidate;
    if (const auto id = candidate.sensor->attribute("id")) ids.emplace_back(*id);
  }
  std::size_t number = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, fault] = std::from_chars(name.data(), end, number);
  if (fault == std::errc{} && rest == end && number < candidates.size()) return &candidates[number];
  builder.diagnostics.error(
      root.where,
      fmt::format("no <sensor> has the id or the number \"{}\"{}; the scene has {}", name, did_you_mean(name, ids),
                  candidates.empty() ? "none" : fmt::format("{}, from 0 on", candidates.size())));
  return nullptr;
}

/// Mitsuba takes the first, too, but of a batch it shows all.
void tell_others(const std::vector<Candidate>& candidates, Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const XmlElement& other = *candidates[i].sensor;
    const std::string name(other.attribute("id").value_or(fmt::format("{}", i)));
    std::string message = fmt::format("the first <sensor> is used; this one is left out (--sensor {} takes it)", name);
    if (candidates[i].batch != nullptr && candidates[i].batch == candidates.front().batch)
      diagnostics.warning(other.where, std::move(message));
    else
      diagnostics.note(other.where, std::move(message));
  }
}

/// Each of its sensors has an equal part of its film's width, and no crop window.
void share(const Batch& batch, SceneBuilder& builder) {
  Film& film = builder.scene.film;
  if (batch.sampler != nullptr) builder.scene.sampler = read_sampler(*batch.sampler, builder);
  if (batch.film == nullptr) return;
  film = read_film(*batch.film, builder);
  if (film.crop)
    builder.diagnostics.warning(batch.film->where,
                                "the crop window of a batch's film has no effect; --crop states one");
  film.crop.reset();
  if (film.width % batch.sensors != 0)
    builder.diagnostics.error(
        batch.film->where,
        fmt::format("{} sensors cannot share a film of {} pixels' width evenly", batch.sensors, film.width));
  film.width /= batch.sensors;
}

}  // namespace

void read_sensors(const std::vector<const XmlElement*>& elements, const XmlElement& root, SceneBuilder& builder) {
  const std::string& name = builder.sensor;
  if (elements.empty() && name.empty()) {
    builder.diagnostics.warning(root.where,
                                "the scene has no <sensor>; a perspective camera that looks along -z frames it");
    builder.scene.camera = camera_framing(bounds(builder.scene));
    return;
  }
  const Candidates candidates(elements, builder);
  const std::vector<Candidate>& all = candidates.all();
  if (name.empty()) tell_others(all, builder.diagnostics);
  const Candidate* camera = name.empty() ? all.data() : chosen(all, name, root, builder);
  if (camera == nullptr || all.empty()) return;
  read_sensor(*camera->sensor, builder);
  builder.scene.camera.number = static_cast<int>(camera - all.data());
  if (camera->batch != nullptr) share(*camera->batch, builder);
}

}  // namespace strahl

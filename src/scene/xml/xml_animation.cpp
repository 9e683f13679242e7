// SPDX-License-Identifier: MIT
// Before its first time and after its last one a thing stands still, as in Mitsuba 0.x, and so it does while a shutter
// opens and closes at once.
#include "scene/xml/xml_animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

/// While light falls onto a film: of several sensors, from the first that opens to the last that closes.
struct Shutter {
  double open = 0, close = 0;
};

struct Pose {
  double time;
  const XmlElement* transform;
};

double parameter_of(const XmlElement& sensor, std::string_view name) {
  for (const XmlElement* child = sensor.first_child; child != nullptr; child = child->next_sibling)
    if (child->text("name") == name) return parse_number(child->text("value")).value_or(0);
  return 0;
}

void add_shutters(const XmlElement& element, std::optional<Shutter>& shutter) {
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling) {
    if (child->tag == "sensor") {
      const Shutter own{parameter_of(*child, "shutter_open"), parameter_of(*child, "shutter_close")};
      if (!shutter) shutter = own;
      shutter->open = std::min(shutter->open, own.open);
      shutter->close = std::max(shutter->close, own.close);
    }
    add_shutters(*child, shutter);
  }
}

/// By their times; none after an error.
std::vector<Pose> poses_of(const XmlElement& animation, Diagnostics& diagnostics) {
  std::vector<Pose> poses;
  for (const XmlElement* child = animation.first_child; child != nullptr; child = child->next_sibling) {
    const std::optional<double> time = child->tag == "transform" ? parse_number(child->text("time")) : std::nullopt;
    if (!time || !std::isfinite(*time)) {
      diagnostics.error(child->where, "an <animation> holds a <transform time=\"...\"> for each of its times");
      return {};
    }
    poses.push_back({*time, child});
  }
  if (poses.empty()) diagnostics.error(animation.where, "<animation> needs a <transform time=\"...\">");
  std::ranges::stable_sort(poses, {}, &Pose::time);
  return poses;
}

/// poses: at least one.
const Pose& pose_at_opening(const std::vector<Pose>& poses, const Shutter& shutter) {
  const auto later = std::ranges::upper_bound(poses, shutter.open, {}, &Pose::time);
  return later == poses.begin() ? poses.front() : *std::prev(later);
}

bool stands_still(const std::vector<Pose>& poses, const Shutter& shutter) {
  const bool is_exposed_at_once = shutter.open == shutter.close;
  return poses.size() == 1 || shutter.close <= poses.front().time || poses.back().time <= shutter.open ||
         (is_exposed_at_once && pose_at_opening(poses, shutter).time == shutter.open);
}

void freeze(XmlElement& element, const Shutter& shutter, Diagnostics& diagnostics) {
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling) {
    if (child->tag != "animation") {
      freeze(*child, shutter, diagnostics);
      continue;
    }
    const std::vector<Pose> poses = poses_of(*child, diagnostics);
    child->tag = "transform";
    child->first_child = nullptr;
    if (poses.empty()) continue;
    const Pose& pose = pose_at_opening(poses, shutter);
    child->first_child = pose.transform->first_child;
    if (!stands_still(poses, shutter))
      diagnostics.unknown(child->where,
                          fmt::format("motion is not rendered; the <transform> of time {} takes the place of this "
                                      "<animation>",
                                      pose.transform->text("time")));
  }
}

}  // namespace

void freeze_animations(XmlElement& root, Diagnostics& diagnostics) {
  std::optional<Shutter> shutter;
  add_shutters(root, shutter);
  freeze(root, shutter.value_or(Shutter{}), diagnostics);
}

}  // namespace strahl

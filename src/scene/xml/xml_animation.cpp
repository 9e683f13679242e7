// SPDX-License-Identifier: MIT
// The earliest time is that at which shutters of Mitsuba 0.x open by default, 0, in files that begin with it.
#include "scene/xml/xml_animation.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

/// Of its <transform>s; null after an error.
const XmlElement* earliest(const XmlElement& animation, Diagnostics& diagnostics) {
  const XmlElement* first = nullptr;
  double earliest_time = 0;
  for (const XmlElement* child = animation.first_child; child != nullptr; child = child->next_sibling) {
    const std::optional<double> time = child->tag == "transform" ? parse_number(child->text("time")) : std::nullopt;
    if (!time || !std::isfinite(*time)) {
      diagnostics.error(child->where, "an <animation> holds a <transform time=\"...\"> for each of its times");
      return nullptr;
    }
    if (first != nullptr && *time >= earliest_time) continue;
    first = child;
    earliest_time = *time;
  }
  if (first == nullptr) diagnostics.error(animation.where, "<animation> needs a <transform time=\"...\">");
  return first;
}

}  // namespace

void hold_animations(XmlElement& root, Diagnostics& diagnostics) {
  for (XmlElement* child = root.first_child; child != nullptr; child = child->next_sibling) {
    if (child->tag != "animation") {
      hold_animations(*child, diagnostics);
      continue;
    }
    const XmlElement* held = earliest(*child, diagnostics);
    if (held != nullptr)
      diagnostics.unknown(child->where,
                          fmt::format("motion is not rendered; the <transform> of time {} takes the place of this "
                                      "<animation>",
                                      held->text("time")));
    child->tag = "transform";
    child->first_child = held == nullptr ? nullptr : held->first_child;
  }
}

}  // namespace strahl

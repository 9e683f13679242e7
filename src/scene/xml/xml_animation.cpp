// SPDX-License-Identifier: MIT
// Until its earliest time a thing does not move, so that a picture is as it should be whose shutter closes by then; in
// Mitsuba 0.x it opens and closes at 0 by default.
#include "scene/xml/xml_animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

/// When the last shutter of the scene closes.
double closing_time(const XmlElement& element) {
  double last = 0;
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling) {
    if (child->text("name") == "shutter_close") last = std::max(last, parse_number(child->text("value")).value_or(0));
    last = std::max(last, closing_time(*child));
  }
  return last;
}

double time_of(const XmlElement& pose) { return parse_number(pose.text("time")).value_or(NAN); }

/// Of its <transform>s; null after an error.
const XmlElement* earliest(const XmlElement& animation, Diagnostics& diagnostics) {
  const XmlElement* first = nullptr;
  for (const XmlElement* child = animation.first_child; child != nullptr; child = child->next_sibling) {
    if (child->tag != "transform" || !std::isfinite(time_of(*child))) {
      diagnostics.error(child->where, "an <animation> holds a <transform time=\"...\"> for each of its times");
      return nullptr;
    }
    if (first == nullptr || time_of(*child) < time_of(*first)) first = child;
  }
  if (first == nullptr) diagnostics.error(animation.where, "<animation> needs a <transform time=\"...\">");
  return first;
}

void hold(XmlElement& element, double closing, Diagnostics& diagnostics) {
  for (XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling) {
    if (child->tag != "animation") {
      hold(*child, closing, diagnostics);
      continue;
    }
    const XmlElement* held = earliest(*child, diagnostics);
    if (held != nullptr && closing > time_of(*held))
      diagnostics.unknown(child->where,
                          fmt::format("motion is not rendered; the <transform> of time {} takes the place of this "
                                      "<animation>",
                                      held->text("time")));
    child->tag = "transform";
    child->first_child = held == nullptr ? nullptr : held->first_child;
  }
}

}  // namespace

void hold_animations(XmlElement& root, Diagnostics& diagnostics) { hold(root, closing_time(root), diagnostics); }

}  // namespace strahl

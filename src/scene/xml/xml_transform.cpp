// SPDX-License-Identifier: MIT
#include "scene/xml/xml_transform.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/xml/parse_value.h"

namespace strahl {

namespace {

// A unit vector whose components were rounded to three decimals is off by sqrt(3) * 0.0005 at the most.
constexpr double unit_to_three_decimals = 0.00087;

using Step = std::optional<Transform> (*)(const XmlElement&, Diagnostics&);

std::optional<double> finite_number(const XmlElement& element, std::string_view text, Diagnostics& diagnostics) {
  const std::optional<double> number = parse_number(text);
  if (number && std::isfinite(*number)) return number;
  diagnostics.error(element.where,
                    fmt::format("\"{}\" in <{}> is not {}", text, element.tag, number ? "finite" : "a number"));
  return std::nullopt;
}

std::optional<Vec3> listed(const XmlElement& element, std::string_view text, bool broadcast, Diagnostics& diagnostics) {
  const std::vector<std::string_view> words = split_list(text);
  if (words.size() != 3 && !(broadcast && words.size() == 1)) {
    diagnostics.error(element.where, fmt::format("\"{}\" in <{}> has {} components; three are needed", text,
                                                 element.tag, words.size()));
    return std::nullopt;
  }
  const auto x = finite_number(element, words[0], diagnostics);
  const auto y = words.size() == 3 ? finite_number(element, words[1], diagnostics) : x;
  const auto z = words.size() == 3 ? finite_number(element, words[2], diagnostics) : x;
  return x && y && z ? std::optional(Vec3{*x, *y, *z}) : std::nullopt;
}

std::optional<Transform> read_translate(const XmlElement& element, Diagnostics& diagnostics) {
  const std::optional<Vec3> t = read_components(element, 0, diagnostics);
  if (!t) return std::nullopt;
  return Transform{{{{1, 0, 0, t->x}, {0, 1, 0, t->y}, {0, 0, 1, t->z}}}};
}

std::optional<Transform> read_scale(const XmlElement& element, Diagnostics& diagnostics) {
  const std::optional<Vec3> s = read_components(element, 1, diagnostics);
  if (!s) return std::nullopt;
  return Transform{{{{s->x, 0, 0, 0}, {0, s->y, 0, 0}, {0, 0, s->z, 0}}}};
}

/// Mitsuba 3 puts the axis into Rodrigues' formula as it stands: c I + (1 - c) a a^T + s [a]_x.
void warn_of_axis(const XmlElement& element, double size, double angle, Diagnostics& diagnostics) {
  const auto [s, c] = sin_cos_degrees(angle);
  diagnostics.warning(
      element.where,
      fmt::format("the axis of <rotate> has length {:.4g}; strahl turns by {:g} degrees about its direction. Mitsuba "
                  "takes it as it stands: that turns by {:.4g} degrees and scales by {:.4g} along the axis, {:.4g} "
                  "across; make it a unit vector to have the same in both",
                  size, angle, std::atan2(s * size, c) * (180.0 / std::numbers::pi), c + (1 - c) * size * size,
                  std::hypot(c, s * size)));
}

std::optional<Transform> read_rotate(const XmlElement& element, Diagnostics& diagnostics) {
  const std::optional<Vec3> axis = read_components(element, 0, diagnostics);
  const std::optional<double> angle = finite_number(element, element.text("angle"), diagnostics);
  if (!axis || !angle) return std::nullopt;
  if (*axis == Vec3{}) {
    diagnostics.error(element.where, "<rotate> needs an axis, for example y=\"1\"");
    return std::nullopt;
  }
  if (std::abs(length(*axis) - 1) > unit_to_three_decimals && std::remainder(*angle, 360.0) != 0)
    warn_of_axis(element, length(*axis), *angle, diagnostics);
  return rotation(*axis, *angle);
}

std::optional<Transform> read_lookat(const XmlElement& element, Diagnostics& diagnostics) {
  const auto origin = listed(element, element.text("origin"), false, diagnostics);
  const auto target = listed(element, element.text("target"), false, diagnostics);
  auto up = element.text("up").empty() ? Vec3{} : listed(element, element.text("up"), false, diagnostics);
  if (!origin || !target || !up) return std::nullopt;
  if (*origin == *target) {
    diagnostics.error(element.where, "degenerate lookat: origin and target are the same point");
    return std::nullopt;
  }
  if (*up == Vec3{}) up = orthonormal_basis(normalized(*target - *origin))[0];
  const std::optional<Transform> view = look_at(*origin, *target, *up);
  if (!view) diagnostics.error(element.where, "degenerate lookat: up is parallel to the view direction");
  return view;
}

std::optional<Transform> read_matrix(const XmlElement& element, Diagnostics& diagnostics) {
  const std::vector<std::string_view> words = split_list(element.text("value"));
  if (words.size() != 9 && words.size() != 16) {
    diagnostics.error(element.where, fmt::format("<matrix> has {} values; 9 or 16 are needed", words.size()));
    return std::nullopt;
  }
  const std::size_t columns = words.size() == 9 ? 3 : 4;
  Transform transform;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::optional<double> number = finite_number(element, words[i], diagnostics);
    if (!number) return std::nullopt;
    if (i < 3 * columns) {
      transform.m[i / columns][i % columns] = *number;
    } else if (*number != (i == 15 ? 1.0 : 0.0)) {
      diagnostics.error(element.where, "the last row of a <matrix> must be 0 0 0 1");
      return std::nullopt;
    }
  }
  return transform;
}

/// Why a step has no inverse; empty where it has one, or needs none.
std::string fault_of_step(const XmlElement& element, const Transform& step, TransformUse use) {
  if (use == TransformUse::uv) return {};
  if (element.tag == "scale" && (step.m[0][0] == 0 || step.m[1][1] == 0 || step.m[2][2] == 0))
    return "a scale of 0 is singular; every factor must differ from 0";
  if (element.tag != "matrix") return {};
  const std::string why = singular_because(step);
  return why.empty() ? why : fmt::format("the <matrix> is singular: {}", why);
}

Step step_of(std::string_view tag) {
  if (tag == "translate") return read_translate;
  if (tag == "scale") return read_scale;
  if (tag == "rotate") return read_rotate;
  if (tag == "lookat") return read_lookat;
  return tag == "matrix" ? read_matrix : nullptr;
}

}  // namespace

std::optional<Vec3> read_components(const XmlElement& element, double missing, Diagnostics& diagnostics) {
  const std::optional<std::string_view> value = element.attribute("value");
  const std::optional<std::string_view> given[] = {element.attribute("x"), element.attribute("y"),
                                                   element.attribute("z")};
  const bool any = given[0] || given[1] || given[2];
  const bool may_lack_all = element.tag == "translate" || element.tag == "scale";  // Which then change nothing.
  if (any == value.has_value() && (any || !may_lack_all)) {
    diagnostics.error(element.where, fmt::format("<{}> needs either value or x, y, z", element.tag));
    return std::nullopt;
  }
  if (value) return listed(element, *value, true, diagnostics);
  double components[3];
  bool ok = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = given[i] ? finite_number(element, *given[i], diagnostics) : missing;
    ok = ok && number.has_value();
    components[i] = number.value_or(missing);
  }
  return ok ? std::optional(Vec3{components[0], components[1], components[2]}) : std::nullopt;
}

std::optional<Transform> read_transform(const XmlElement& element, Diagnostics& diagnostics, TransformUse use) {
  Transform transform;
  bool ok = true;
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling) {
    const Step step = step_of(child->tag);
    if (step == nullptr) {
      diagnostics.error(child->where, fmt::format("<{}> is not a step of a <transform>", child->tag));
      ok = false;
      continue;
    }
    const std::optional<Transform> next = step(*child, diagnostics);
    const std::string fault = next ? fault_of_step(*child, *next, use) : "";
    if (!fault.empty()) diagnostics.error(child->where, fault);
    ok = ok && next && fault.empty();
    if (next) transform = *next * transform;
  }
  const std::string why = use == TransformUse::uv ? "" : singular_because(transform);
  if (ok && !transform.is_finite()) {
    diagnostics.error(element.where, "the composed transform leaves the range of double");
    ok = false;
  } else if (ok && !why.empty()) {
    diagnostics.error(element.where, fmt::format("the composed transform is singular: {}", why));
    ok = false;
  }
  return ok ? std::optional(transform) : std::nullopt;
}

}  // namespace strahl

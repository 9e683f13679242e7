// SPDX-License-Identifier: MIT
// Typed access to the children of a plugin element.
#include "scene/xml/properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "did_you_mean.h"
#include "scene/xml/color_value.h"
#include "scene/xml/parse_value.h"
#include "scene/xml/typed_spectrum.h"
#include "scene/xml/xml_vocabulary.h"

namespace strahl {

namespace {

/// So many are within each other at the most: they are read recursively.
constexpr int deepest_spectrum = 256;

}  // namespace

Properties::Properties(const XmlElement& element, const ElementIds& ids, Diagnostics& diagnostics)
    : element_(element), ids_(ids), diagnostics_(diagnostics) {
  std::size_t count = 0;
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling) ++count;
  entries_.reserve(count);
  known_.reserve(8);
  for (const XmlElement* child = element.first_child; child != nullptr; child = child->next_sibling) {
    if (child->tag == "alias") continue;
    if (child->tag == old_rule_tag) {
      old_rules_.push_back(child->text("name"));
      continue;
    }
    const XmlElement* meant = child->tag == "ref" ? ids.resolve(*child, diagnostics) : child;
    if (meant != nullptr) entries_.push_back({child, meant, child->text("name")});
  }
  report_duplicates();
}

void Properties::report_duplicates() {
  std::set<std::string_view> names;
  for (Entry& entry : entries_) {
    if (entry.name.empty() || names.insert(entry.name).second) continue;
    entry.used = true;
    diagnostics_.error(entry.given->where, fmt::format("\"{}\" of {} is given twice", entry.name, title()));
  }
}

std::string Properties::title() const {
  return type().empty() ? fmt::format("<{}>", element_.tag) : fmt::format("<{} type=\"{}\">", element_.tag, type());
}

SourceLocation Properties::where(std::string_view name) const {
  for (const Entry& entry : entries_)
    if (entry.name == name) return entry.given->where;
  return element_.where;
}

bool Properties::has(std::string_view name) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.name == name; });
}

bool Properties::has_old_rule(std::string_view name) const {
  return std::find(old_rules_.begin(), old_rules_.end(), name) != old_rules_.end();
}

const XmlElement* Properties::peek(std::string_view name) const {
  const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
  return entry == entries_.end() ? nullptr : entry->meant;
}

const XmlElement* Properties::take(std::string_view name, std::initializer_list<const char*> tags) {
  known_.emplace_back(name);
  const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
  if (entry == entries_.end()) return nullptr;
  entry->used = true;
  if (std::find(tags.begin(), tags.end(), entry->meant->tag) != tags.end()) return entry->meant;
  diagnostics_.error(entry->given->where, fmt::format("\"{}\" of {} is a <{}>; it must be a <{}>", name, title(),
                                                      entry->meant->tag, *tags.begin()));
  return nullptr;
}

std::optional<double> Properties::number(std::string_view name) {
  const XmlElement* given = take(name, {"float", "integer"});
  if (given == nullptr) return std::nullopt;
  const std::optional<double> value = parse_number(given->text("value"));
  if (value && std::isfinite(*value)) return value;
  diagnostics_.error(given->where, fmt::format("\"{}\" is \"{}\", which is not {}", name, given->text("value"),
                                               value ? "finite" : "a number"));
  return std::nullopt;
}

std::optional<double> Properties::positive(std::string_view name) {
  const std::optional<double> value = number(name);
  if (!value || *value > 0) return value;
  diagnostics_.error(where(name), fmt::format("\"{}\" is {}; it must be greater than 0", name, *value));
  return std::nullopt;
}

std::optional<int> Properties::integer(std::string_view name) {
  const XmlElement* given = take(name, {"integer"});
  if (given == nullptr) return std::nullopt;
  const std::optional<int> value = parse_integer(given->text("value"));
  if (!value)
    diagnostics_.error(given->where,
                       fmt::format("\"{}\" is \"{}\", which is not a whole number", name, given->text("value")));
  return value;
}

std::optional<int> Properties::integer_in(std::string_view name, int low, int high) {
  const std::optional<int> value = integer(name);
  if (!value || (low <= *value && *value <= high)) return value;
  diagnostics_.error(where(name), fmt::format("\"{}\" is {}; it must lie in [{}, {}]", name, *value, low, high));
  return std::nullopt;
}

std::optional<bool> Properties::boolean(std::string_view name) {
  const XmlElement* given = take(name, {"boolean"});
  if (given == nullptr) return std::nullopt;
  const std::optional<bool> value = parse_boolean(given->text("value"));
  if (!value)
    diagnostics_.error(given->where,
                       fmt::format("\"{}\" is \"{}\"; it must be true or false", name, given->text("value")));
  return value;
}

std::optional<std::string> Properties::string(std::string_view name) {
  const XmlElement* given = take(name, {"string"});
  return given == nullptr ? std::nullopt : std::optional<std::string>(given->text("value"));
}

std::optional<Vec3> Properties::vector(std::string_view name) {
  const XmlElement* given = take(name, {"point", "vector"});
  if (given == nullptr) return std::nullopt;
  for (const char* component : {"x", "y", "z"}) {
    if (given->attribute("value") || given->attribute(component)) continue;
    diagnostics_.error(given->where, fmt::format("\"{}\" needs {} (or value=\"x, y, z\")", name, component));
    return std::nullopt;
  }
  return read_components(*given, 0, diagnostics_);
}

std::optional<Vec3> Properties::required_vector(std::string_view name) {
  if (!has(name)) diagnostics_.error(where(), fmt::format("{} needs the point \"{}\"", title(), name));
  return vector(name);
}

std::optional<Transform> Properties::transform(std::string_view name, TransformUse use) {
  const XmlElement* given = take(name, {"transform"});
  return given == nullptr ? std::nullopt : read_transform(*given, diagnostics_, use);
}

std::optional<Rgb> Properties::color(std::string_view name, ColorUse use, const Rgb& substitute) {
  const XmlElement* given =
      take(name, {"rgb", "srgb", "spectrum", "float", "integer", "texture", "blackbody", "volume"});
  if (given == nullptr) return std::nullopt;
  std::optional<Rgb> value;
  if (is_typed_spectrum(*given)) {
    int depth = 0;
    for (const Properties* around = this; around != nullptr; around = around->around_, ++depth)
      if (&around->element_ == given) {
        diagnostics_.error(given->where, fmt::format("{} contains itself", around->title()));
        return std::nullopt;
      }
    if (depth > deepest_spectrum) {
      diagnostics_.error(given->where, fmt::format("spectra are nested deeper than {}", deepest_spectrum));
      return std::nullopt;
    }
    Properties spectrum(*given, ids_, diagnostics_);
    spectrum.around_ = this;
    value = read_typed_spectrum(spectrum, use);
  } else {
    value = read_color(*given, use, substitute, diagnostics_);
  }
  if (!value) return std::nullopt;
  if (!is_finite(*value)) {
    diagnostics_.error(where(name), fmt::format("\"{}\" is not finite: the numbers of its <{}> are too large to be "
                                                "summed",
                                                name, given->tag));
    return std::nullopt;
  }
  if (use == ColorUse::reflectance) return clamped_reflectance(*value, given->where, name, diagnostics_);
  if (use == ColorUse::unclamped || (value->r >= 0 && value->g >= 0 && value->b >= 0)) return value;
  const char* what = use == ColorUse::emission ? "is negative; light cannot be" : "must not be negative";
  diagnostics_.error(where(name), fmt::format("\"{}\" {}", name, what));
  return std::nullopt;
}

std::optional<std::vector<double>> Properties::numbers(std::string_view name) {
  const XmlElement* given = take(name, {"string", "float"});
  if (given == nullptr) return std::nullopt;
  std::optional<std::vector<double>> values = parse_numbers(given->text("value"));
  if (!values)
    diagnostics_.error(given->where,
                       fmt::format("\"{}\" is \"{}\", which is no list of numbers", name, given->text("value")));
  return values;
}

std::vector<const XmlElement*> Properties::objects(std::string_view tag) {
  std::vector<const XmlElement*> found;
  for (const NamedObject& placed : placed_objects(tag)) found.push_back(placed.object);
  return found;
}

std::vector<NamedObject> Properties::placed_objects(std::string_view tag) {
  std::vector<NamedObject> found;
  for (Entry& entry : entries_) {
    if (entry.used || entry.meant->tag != tag) continue;
    entry.used = true;
    found.push_back({std::string(entry.name), entry.meant, entry.given->where});
  }
  return found;
}

std::vector<NamedObject> Properties::named_objects(std::string_view tag) {
  std::vector<NamedObject> found;
  for (Entry& entry : entries_) {
    if (entry.used || entry.name.empty() || entry.meant->tag != tag) continue;
    entry.used = true;
    found.push_back({std::string(entry.name), entry.meant, entry.given->where});
  }
  return found;
}

void Properties::accept(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    known_.emplace_back(name);
    for (Entry& entry : entries_)
      if (entry.name == name) entry.used = true;
  }
}

void Properties::accept_all() {
  for (Entry& entry : entries_) entry.used = true;
}

void Properties::report_unknown() {
  for (const Entry& entry : entries_) {
    if (entry.used) continue;
    const bool is_reference = entry.given != entry.meant;
    const bool is_parameter = !entry.name.empty() && !is_reference && !is_object_tag(entry.meant->tag);
    const std::string what =
        is_parameter
            ? fmt::format("unknown parameter \"{}\" of {}{}", entry.name, title(), did_you_mean(entry.name, known_))
        : is_reference
            ? fmt::format("{} has no use for \"{}\", a <{}>", title(), entry.given->text("id"), entry.meant->tag)
            : fmt::format("{} has no use for a <{}>", title(), entry.meant->tag);
    diagnostics_.unknown(entry.given->where, what + "; it is ignored");
  }
}

}  // namespace strahl

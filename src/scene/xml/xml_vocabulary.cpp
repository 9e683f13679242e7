// SPDX-License-Identifier: MIT
// One table; the language is Mitsuba 3's, with <srgb> of 0.x.
#include "scene/xml/xml_vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "did_you_mean.h"

namespace strahl {

namespace {

struct Tag {
  std::string name;
  std::vector<std::string> required;
  std::vector<std::string> optional;
  bool has_children = false;
};

const std::vector<Tag>& vocabulary() {
  static const std::vector<Tag> tags = [] {
    std::vector<Tag> all{
        {"scene", {}, {"version", "type", "id"}, true},
        {"ref", {"id"}, {"name"}},
        {"alias", {"id", "as"}, {}},
        {"transform", {"name"}, {}, true},
        {"animation", {"name"}, {}, true},
        {"translate", {}, {"x", "y", "z", "value"}},
        {"scale", {}, {"x", "y", "z", "value"}},
        {"rotate", {"angle"}, {"x", "y", "z", "value"}},
        {"lookat", {"origin", "target"}, {"up"}},
        {"matrix", {"value"}, {}},
        {"point", {"name"}, {"x", "y", "z", "value"}},
        {"vector", {"name"}, {"x", "y", "z", "value"}},
        {"spectrum", {}, {"name", "value", "filename", "type", "id", "intent"}, true},
        {"blackbody", {}, {"name", "temperature", "scale"}},
    };
    for (const char* value : {"float", "integer", "boolean", "string"}) all.push_back({value, {"name", "value"}, {}});
    for (const char* color : {"rgb", "srgb"}) all.push_back({color, {"name", "value"}, {"intent"}});
    for (const char* object : {"integrator", "sensor", "film", "rfilter", "sampler", "bsdf", "shape", "emitter",
                               "texture", "medium", "phase", "volume"})
      all.push_back({object, {"type"}, {"id", "name"}, true});
    return all;
  }();
  return tags;
}

const Tag* find_tag(std::string_view name) {
  static const std::unordered_map<std::string_view, const Tag*> tags = [] {
    std::unordered_map<std::string_view, const Tag*> all;
    for (const Tag& tag : vocabulary()) all.emplace(tag.name, &tag);
    return all;
  }();
  const auto found = tags.find(name);
  return found == tags.end() ? nullptr : found->second;
}

std::string unknown_tag(std::string_view name) {
  std::vector<std::string> known;
  for (const Tag& tag : vocabulary()) known.push_back(tag.name);
  return fmt::format("unknown element <{}>{}; it is ignored", name, did_you_mean(name, known));
}

void check_attributes(const XmlElement& element, const Tag& tag, Diagnostics& diagnostics) {
  const auto is_in = [](const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& [key, value] : element.attributes) {
    if (is_in(tag.required, key) || is_in(tag.optional, key)) continue;
    std::vector<std::string> known = tag.required;
    known.insert(known.end(), tag.optional.begin(), tag.optional.end());
    diagnostics.unknown(element.where, fmt::format("unknown attribute \"{}\" of <{}>{}; it is ignored", key,
                                                   element.tag, did_you_mean(key, known)));
  }
}

bool has_required(const XmlElement& element, const Tag& tag, Diagnostics& diagnostics) {
  bool complete = true;
  for (const std::string& name : tag.required) {
    if (element.attribute(name)) continue;
    diagnostics.error(element.where, fmt::format("<{}> needs the attribute {}", element.tag, name));
    complete = false;
  }
  return complete;
}

/// A <spectrum> has its value as an attribute, or is a plugin of a type, whose parameters are elements.
void check_spectrum(XmlElement& element, Diagnostics& diagnostics) {
  if (!element.attribute("type")) {
    if (element.first_child == nullptr) return;
    diagnostics.unknown(element.first_child->where,
                        "a <spectrum> without a type cannot contain other elements; they are ignored");
    element.first_child = nullptr;
    return;
  }
  for (const char* key : {"value", "filename"})
    if (element.attribute(key))
      diagnostics.unknown(element.where,
                          fmt::format("unknown attribute \"{}\" of <spectrum type=\"{}\">, whose parameters are "
                                      "elements inside it; it is ignored",
                                      key, element.text("type")));
}

/// A <transform> within an <animation> has a time in place of a name.
const Tag* tag_within(const XmlElement* parent, std::string_view name) {
  static const Tag pose{"transform", {"time"}, {}, true};
  return parent != nullptr && parent->tag == "animation" && name == pose.name ? &pose : find_tag(name);
}

/// False: the element is to be removed. parent: null of the root.
bool check(XmlElement& element, const XmlElement* parent, Diagnostics& diagnostics) {
  if (element.tag == old_rule_tag) return true;
  const Tag* tag = tag_within(parent, element.tag);
  if (tag == nullptr) {
    diagnostics.unknown(element.where, unknown_tag(element.tag));
    return false;
  }
  check_attributes(element, *tag, diagnostics);
  if (!has_required(element, *tag, diagnostics)) return false;
  if (element.tag == "spectrum") check_spectrum(element, diagnostics);
  if (!tag->has_children && element.first_child != nullptr) {
    diagnostics.unknown(element.first_child->where,
                        fmt::format("<{}> cannot contain other elements; they are ignored", element.tag));
    element.first_child = nullptr;
  }
  for (XmlElement** place = &element.first_child; XmlElement* child = *place;) {
    if (child->tag == "scene") diagnostics.error(child->where, "<scene> can only be the root");
    if (child->tag != "scene" && check(*child, &element, diagnostics)) {
      place = &child->next_sibling;
    } else {
      *place = child->next_sibling;
    }
  }
  return true;
}

}  // namespace

bool check_vocabulary(XmlElement& root, Diagnostics& diagnostics) {
  if (root.tag == "scene") return check(root, nullptr, diagnostics);
  diagnostics.error(root.where,
                    fmt::format("the root is <{}>; a scene begins with <scene version=\"3.0.0\">", root.tag));
  return false;
}

void check_expanded(const XmlElement& element, Diagnostics& diagnostics) {
  static const std::vector<Tag> tags{
      {"default", {"name", "value"}, {}}, {"include", {"filename"}, {"name"}}, {"path", {"value"}, {}}};
  for (const Tag& tag : tags)
    if (tag.name == element.tag) check_attributes(element, tag, diagnostics);
}

bool is_object_tag(std::string_view tag) {
  const Tag* known = find_tag(tag);
  return known != nullptr && !known->required.empty() && known->required.front() == "type";
}

}  // namespace strahl

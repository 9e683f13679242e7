// SPDX-License-Identifier: MIT
// The parameters and nested objects of one plugin, by name and type. Getters remember what was asked for, so that
// report_unknown() can name what nobody asked for and what was probably meant.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/vec.h"
#include "scene/xml/color_value.h"
#include "scene/xml/diagnostics.h"
#include "scene/xml/element_ids.h"
#include "scene/xml/xml_element.h"
#include "scene/xml/xml_transform.h"

namespace strahl {

/// Both as they stand in the file; a reference's where it is one that gives the object.
struct NamedObject {
  std::string name;
  const XmlElement* object;
  SourceLocation where;
};

class Properties {
 public:
  Properties(const XmlElement& element, const ElementIds& ids, Diagnostics& diagnostics);

  [[nodiscard]] const XmlElement& element() const { return element_; }
  [[nodiscard]] std::string_view type() const { return element_.text("type"); }
  [[nodiscard]] std::string id() const { return std::string(element_.text("id")); }
  /// `<shape type="sphere">`, for messages.
  [[nodiscard]] std::string title() const;
  [[nodiscard]] SourceLocation where() const { return element_.where; }
  /// Where the parameter is given, else where the plugin stands.
  [[nodiscard]] SourceLocation where(std::string_view name) const;
  [[nodiscard]] Diagnostics& diagnostics() const { return diagnostics_; }

  // Each returns none where the parameter is absent, or faulty (which is then reported).
  [[nodiscard]] std::optional<double> number(std::string_view name);
  [[nodiscard]] std::optional<int> integer(std::string_view name);
  [[nodiscard]] std::optional<bool> boolean(std::string_view name);
  [[nodiscard]] std::optional<std::string> string(std::string_view name);
  [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view name);
  [[nodiscard]] std::optional<Vec3> vector(std::string_view name);
  [[nodiscard]] std::optional<Transform> transform(std::string_view name, TransformUse use = TransformUse::space);
  /// A colour; what strahl cannot read as one is replaced by `substitute` with a warning.
  [[nodiscard]] std::optional<Rgb> color(std::string_view name, ColorUse use, const Rgb& substitute);

  [[nodiscard]] std::optional<double> positive(std::string_view name);  ///< Reports what is not > 0.
  [[nodiscard]] std::optional<int> integer_in(std::string_view name, int low, int high);
  [[nodiscard]] std::optional<Vec3> required_vector(std::string_view name);  ///< Reports a missing one.

  [[nodiscard]] bool has(std::string_view name) const;
  /// Whether xml_upgrade.h wrote that this rule of Mitsuba 0.x holds here; no file can.
  [[nodiscard]] bool has_old_rule(std::string_view name) const;
  /// The element that gives a parameter, references resolved; null where it is absent. Does not count as asked for.
  [[nodiscard]] const XmlElement* peek(std::string_view name) const;
  /// Nested objects of a kind ("bsdf"), references resolved.
  [[nodiscard]] std::vector<const XmlElement*> objects(std::string_view tag);
  /// The same with the places that give them, a reference's where it is one.
  [[nodiscard]] std::vector<NamedObject> placed_objects(std::string_view tag);
  /// Those of them that have a name, as theirs or their reference's.
  [[nodiscard]] std::vector<NamedObject> named_objects(std::string_view tag);
  /// Parameters that are known and have no effect on what strahl computes.
  void accept(std::initializer_list<const char*> names);
  /// Accepts whatever there is: the plugin itself is unknown and that has been said.
  void accept_all();
  /// To be called last.
  void report_unknown();

 private:
  struct Entry {
    const XmlElement* given;
    const XmlElement* meant;  ///< What a <ref> points to, else `given`.
    std::string_view name;
    bool used = false;
  };

  const XmlElement* take(std::string_view name, std::initializer_list<const char*> tags);
  void report_duplicates();

  const XmlElement& element_;
  const Properties* around_ = nullptr;  ///< Of the spectrum that this one stands in; null: of none.
  const ElementIds& ids_;
  Diagnostics& diagnostics_;
  std::vector<Entry> entries_;
  std::vector<std::string_view> old_rules_;
  std::vector<std::string> known_;
};

}  // namespace strahl

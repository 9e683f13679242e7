// SPDX-License-Identifier: MIT
// Names of precisions and AOVs, as the command line and the files spell them.
#include "settings/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include "errors.h"

namespace strahl {
namespace {

constexpr std::array<std::pair<const char*, Precision>, 4> precisions{{
    {"fast", Precision::fast},
    {"stable", Precision::stable},
    {"robust", Precision::robust},
    {"double", Precision::fp64},
}};

constexpr std::array<std::pair<const char*, Aov>, 11> aovs{{
    {"depth", Aov::depth},
    {"normal", Aov::normal},
    {"position", Aov::position},
    {"uv", Aov::uv},
    {"shape_id", Aov::shape_id},
    {"primitive_id", Aov::primitive_id},
    {"numeric_error", Aov::numeric_error},
    {"albedo", Aov::albedo},
    {"geo_normal", Aov::geo_normal},
    {"xyz", Aov::xyz},
    {"xyz_squared", Aov::xyz_squared},
}};

/// They stand first.
constexpr std::size_t first_sample_aovs = 9;

template <typename Table>
auto by_name(const Table& table, const char* what, const std::string& name) {
  std::string known;
  for (const auto& [text, value] : table) {
    if (name == text) return value;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", text);
  }
  throw UsageError(fmt::format("unknown {} \"{}\"; known: {}", what, name, known));
}

template <typename Table, typename Value>
const char* name_of(const Table& table, Value value) {
  const auto* entry =
      std::find_if(table.begin(), table.end(), [value](const auto& known) { return known.second == value; });
  if (entry == table.end()) throw std::logic_error("a setting without a name");
  return entry->first;
}

}  // namespace

Precision precision_from_name(const std::string& name) { return by_name(precisions, "precision", name); }

const char* precision_name(Precision precision) { return name_of(precisions, precision); }

Aov aov_from_name(const std::string& name) { return by_name(aovs, "AOV", name); }

Aov first_sample_aov(const std::string& name) {
  static_assert(is_of_first_sample(aovs[first_sample_aovs - 1].second) &&
                !is_of_first_sample(aovs[first_sample_aovs].second));
  return by_name(std::span(aovs).first<first_sample_aovs>(), "AOV", name);
}

const char* aov_name(Aov aov) { return name_of(aovs, aov); }

}  // namespace strahl

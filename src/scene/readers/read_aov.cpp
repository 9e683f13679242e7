// SPDX-License-Identifier: MIT
// <integrator type="aov">: values of each pixel's first sample, beside the picture of the integrator inside it.
#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "did_you_mean.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {
namespace {

/// Mitsuba's types; none: strahl does not have it yet.
const std::map<std::string, std::optional<Aov>, std::less<>>& types() {
  static const std::map<std::string, std::optional<Aov>, std::less<>> all{
      {"depth", Aov::depth},          {"position", Aov::position},     {"uv", Aov::uv},
      {"sh_normal", Aov::normal},     {"albedo", Aov::albedo},         {"prim_index", Aov::primitive_id},
      {"shape_index", Aov::shape_id}, {"geo_normal", Aov::geo_normal}, {"dp_du", std::nullopt},
      {"dp_dv", std::nullopt},        {"duv_dx", std::nullopt},        {"duv_dy", std::nullopt},
      {"boundary_test", std::nullopt}};
  return all;
}

std::vector<std::string> supported_types() {
  std::vector<std::string> names;
  for (const auto& [name, aov] : types())
    if (aov) names.push_back(name);
  return names;
}

/// "d:depth" and "n:uv" of " d : depth ,, n:uv". Mitsuba takes blanks for commas.
std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream pieces(list);
  for (std::string piece; std::getline(pieces, piece, ',');) {
    std::istringstream words(piece);
    bool is_new = true;
    for (std::string word; words >> word;) {
      is_new = is_new || !(word.starts_with(':') || parts.back().ends_with(':'));
      if (is_new) parts.emplace_back();
      parts.back() += word;
      is_new = false;
    }
  }
  return parts;
}

/// Fills `aovs` from the parameter, whose faults it reports.
class AovReader {
 public:
  AovReader(Properties& properties, std::vector<NamedAov>& aovs) : properties_(properties), aovs_(aovs) {
    for (const NamedAov& named : aovs) {
      taken_.emplace(named.name, named.aov);
      take_channels(named);
    }
  }

  void read(const std::string& list) {
    for (const std::string& part : parts_of(list)) read_part(part);
    if (!missing_.empty())
      unknown(fmt::format("{} {} not supported yet; {} left out", fmt::join(missing_, ", "),
                          missing_.size() == 1 ? "is" : "are", missing_.size() == 1 ? "it is" : "they are"));
  }

 private:
  void read_part(const std::string& part) {
    const std::size_t colon = part.find(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == part.size() || colon != part.rfind(':'))
      return fault(fmt::format("\"{}\" is not NAME:TYPE, as \"dist:depth\"", part));
    const std::string name = part.substr(0, colon), type = part.substr(colon + 1);
    if (name.size() > longest_layer_name)
      return fault(
          fmt::format("the name of \"{}\" has {} bytes; a file holds {}", part, name.size(), longest_layer_name));
    const auto found = types().find(type);
    if (found == types().end())
      return unknown(fmt::format("unknown type \"{}\"{}; \"{}\" is left out; strahl has {}", type,
                                 did_you_mean(type, supported_types()), part, fmt::join(supported_types(), ", ")));
    if (!found->second) {
      missing_.push_back(fmt::format("\"{}\"", part));
      return;
    }
    const NamedAov named{name, *found->second};
    if (taken_.contains({named.name, named.aov})) return;  // Once more the same.
    if (const std::string taken = take_channels(named); !taken.empty())
      return unknown(
          fmt::format("\"{}\" is left out: one before it has the channel {}; give it another name", part, taken));
    taken_.emplace(named.name, named.aov);
    aovs_.push_back(named);
  }

  /// A channel that another one has; empty: none, and they are taken.
  std::string take_channels(const NamedAov& named) {
    const std::vector<std::string> channels = channels_of(named);
    for (const std::string& channel : channels)
      if (channels_.contains(channel)) return channel;
    channels_.insert(channels.begin(), channels.end());
    return {};
  }

  void fault(const std::string& what) {
    properties_.diagnostics().error(properties_.where("aovs"), fmt::format("\"aovs\": {}", what));
  }
  void unknown(const std::string& what) {
    properties_.diagnostics().unknown(properties_.where("aovs"), fmt::format("\"aovs\": {}", what));
  }

  Properties& properties_;
  std::vector<NamedAov>& aovs_;
  std::set<std::pair<std::string, Aov>> taken_;
  std::set<std::string> channels_;
  std::vector<std::string> missing_;
};

}  // namespace

IntegratorSettings read_aov(Properties& properties, SceneBuilder& builder) {
  IntegratorSettings integrator = read_inner_integrator(properties, builder);
  if (const std::optional<std::string> list = properties.string("aovs"))
    AovReader(properties, integrator.aovs).read(*list);
  else if (!properties.has("aovs"))
    builder.diagnostics.unknown(
        properties.where(),
        fmt::format("{} needs \"aovs\", as \"dist:depth, n:sh_normal\"; nothing is written beside the picture",
                    properties.title()));
  integrator.aovs_where = properties.where("aovs");
  properties.report_unknown();
  return integrator;
}

}  // namespace strahl

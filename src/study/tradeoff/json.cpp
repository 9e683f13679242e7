// SPDX-License-Identifier: MIT
#include "study/tradeoff/json.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "errors.h"
#include "json_text.h"
#include "settings/sampler_name.h"

namespace strahl {
namespace {

using Json = nlohmann::ordered_json;

Json depth_json(const TradeoffSetting& setting) { return setting.max_depth ? Json(*setting.max_depth) : Json(); }

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json value_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json setting_json(const TradeoffSetting& setting) {
  return {{"precision", precision_name(setting.precision)},
          {"sampler", sampler_name(setting.sampler)},
          {"max_depth", depth_json(setting)},
          {"spp", setting.spp},
          {"generic", setting.generic}};
}

TradeoffSetting setting_of(const Json& json) {
  TradeoffSetting setting;
  setting.precision = precision_from_name(json.at("precision"));
  setting.sampler = sampler_from_name(json.at("sampler"));
  if (!json.at("max_depth").is_null()) setting.max_depth = json.at("max_depth").get<int>();
  setting.spp = json.at("spp");
  setting.generic = json.at("generic");
  return setting;
}

Json json_of(const TradeoffPoint& point) {
  Json json{{"id", point.setting.id()}};
  json.update(setting_json(point.setting));
  json["seeds"] = point.seeds;
  json["seconds"] = {{"program", point.seconds.program},
                     {"bvh", point.seconds.bvh},
                     {"upload", point.seconds.upload},
                     {"kernel", point.seconds.kernel},
                     {"wall", point.seconds.wall}};
  json["program"] = point.program;
  json["program_from_cache"] = point.program_from_cache;
  json["mse"] = point.error.mse;
  json["mse_error"] = point.error.mse_error;
  json["bias2"] = point.error.bias2;
  json["bias2_error"] = point.error.bias2_error;
  json["variance"] = point.error.variance;
  json["rmse"] = point.error.rmse();
  json["rmse_low"] = point.error.rmse_low();
  json["rmse_high"] = point.error.rmse_high();
  for (const auto& [name, value] : point.metrics) json[name] = finite_or_null(value);
  json["saturated_samples"] = point.unusual.saturated;
  json["invalid_samples"] = point.unusual.invalid;
  json["lost_branches"] = point.unusual.lost_branches;
  json["lost_interfaces"] = point.unusual.lost_interfaces;
  json["pareto"] = point.pareto;
  json["picture"] = picture_name(point.setting);
  json["difference"] = difference_name(point.setting);
  return json;
}

TradeoffPoint point_of(const Json& json) {
  TradeoffPoint point;
  point.setting = setting_of(json);
  point.seeds = json.at("seeds");
  const Json& seconds = json.at("seconds");
  point.seconds = {seconds.at("program"), seconds.at("bvh"), seconds.at("upload"), seconds.at("kernel"),
                   seconds.at("wall")};
  point.program = json.at("program");
  point.program_from_cache = json.at("program_from_cache");
  point.error.mse = json.at("mse");
  point.error.mse_error = json.at("mse_error");
  point.error.bias2 = json.at("bias2");
  point.error.bias2_error = json.at("bias2_error");
  point.error.variance = json.at("variance");
  for (const Metric metric : study_metrics()) {
    const Json& value = json.at(metric_name(metric));
    const double none = metric == Metric::psnr ? std::numeric_limits<double>::infinity() : std::nan("");
    point.metrics.emplace_back(metric_name(metric), value.is_null() ? none : value.get<double>());
  }
  point.unusual.saturated = json.at("saturated_samples");
  point.unusual.invalid = json.at("invalid_samples");
  point.unusual.lost_branches = json.at("lost_branches");
  point.unusual.lost_interfaces = json.at("lost_interfaces");
  return point;
}

Json json_of(const TradeoffFit& fit) {
  Json json = setting_json(fit.setting);
  json.erase("spp");
  json["slope"] = fit.seconds.slope;
  json["slope_low"] = fit.seconds.slope_low;
  json["slope_high"] = fit.seconds.slope_high;
  json["factor"] = fit.seconds.factor;
  json["points"] = fit.seconds.points;
  json["samples_slope"] = fit.samples ? Json(fit.samples->slope) : Json();
  json["samples_slope_low"] = fit.samples ? Json(fit.samples->slope_low) : Json();
  json["samples_slope_high"] = fit.samples ? Json(fit.samples->slope_high) : Json();
  return json;
}

Json json_of(const TradeoffReference& reference) {
  Json json;
  if (reference.setting) {
    json = setting_json(*reference.setting);
    json.erase("generic");
  } else {
    json = {{"precision", nullptr}, {"sampler", nullptr}, {"max_depth", nullptr}, {"spp", nullptr}};
  }
  json["file"] = reference.source.empty() ? Json() : Json(reference.source);
  json["seconds"] = value_or_null(reference.seconds);
  json["rmse"] = value_or_null(reference.rmse);
  json["rmse_low"] = value_or_null(reference.rmse_low);
  json["rmse_high"] = value_or_null(reference.rmse_high);
  json["picture"] = reference_picture_name;
  return json;
}

/// A device may name itself in any encoding; JSON is UTF-8.
std::string text_of(const Json& json) { return json_text(json); }

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::string picture_name(const TradeoffSetting& setting) { return "points/" + setting.id() + ".png"; }
std::string difference_name(const TradeoffSetting& setting) { return "points/" + setting.id() + ".difference.png"; }

std::string tradeoff_json(const TradeoffStudy& study) {
  Json json{{"strahl", STRAHL_VERSION},
            {"scene", study.scene_path},
            {"name", study.scene_name},
            {"device", study.device},
            {"command", study.command},
            {"width", study.reference.picture.width},
            {"height", study.reference.picture.height},
            {"reference", json_of(study.reference)},
            {"points", Json::array()},
            {"fits", Json::array()}};
  for (const TradeoffPoint& point : study.points) json["points"].push_back(json_of(point));
  for (const TradeoffFit& fit : study.fits) json["fits"].push_back(json_of(fit));
  return text_of(json);
}

std::string tradeoff_csv(const TradeoffStudy& study) {
  std::string header, rows;
  for (const TradeoffPoint& point : study.points) {
    header.clear();
    const auto add = [&](const std::string& name, const Json& value) {
      header += (header.empty() ? "" : ",") + name;
      rows += (name == "id" ? "" : ",") + cell(value);
    };
    const Json json = json_of(point);
    for (const auto& [name, value] : json.items()) {
      if (!value.is_object()) {
        add(name, value);
        continue;
      }
      for (const auto& [inner, part] : value.items()) add(name + "." + inner, part);
    }
    rows += "\n";
  }
  return header + "\n" + rows;
}

std::string point_json(const TradeoffPoint& point, const std::string& study) {
  Json json = json_of(point);
  json["study"] = study;
  return text_of(json);
}

std::optional<TradeoffPoint> point_from_json(const std::string& text, const std::string& study) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  try {
    if (json.at("study") != study) return std::nullopt;
    return point_of(json);
  } catch (const Json::exception&) {  // Of another version, or damaged: measured again.
  } catch (const UsageError&) {       // A name that nobody knows.
  }
  return std::nullopt;
}

}  // namespace strahl

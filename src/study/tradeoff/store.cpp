// SPDX-License-Identifier: MIT
#include "study/tradeoff/store.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <map>

#include "image/atomic_file.h"
#include "image/file_bytes.h"
#include "image/image_io.h"
#include "study/report/html_report.h"
#include "study/tradeoff/json.h"

namespace strahl {
namespace fs = std::filesystem;

namespace {

constexpr char identity_name[] = "study.json", reference_name[] = "reference.exr", json_name[] = "tradeoff.json",
               table_name[] = "tradeoff.csv", report_name[] = "report.html";

void write_text(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

void create(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error(fmt::format("cannot create the folder \"{}\": {}; choose another one (-o)", folder, error.message()));
}

std::optional<double> number(const std::map<std::string, std::string>& metadata, const std::string& name) {
  const auto found = metadata.find(name);
  double value = 0;
  if (found == metadata.end()) return std::nullopt;
  const char* const end = found->second.data() + found->second.size();
  const auto [stop, error] = std::from_chars(found->second.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

}  // namespace

std::vector<std::string> study_file_names() {
  return {identity_name, reference_name, reference_picture_name, table_name, json_name, report_name};
}

TradeoffStore::TradeoffStore(std::string folder, const StudyIdentity& identity, bool restart)
    : folder_(std::move(folder)), study_(identity.hash()) {
  create(path(study_points_name));
  const std::string file = path(identity_name);
  const bool is_resumed = fs::exists(file) && !restart;
  const std::string difference = is_resumed ? identity.difference_from(read_file(file)) : "";
  if (!difference.empty())
    throw UsageError(fmt::format(
        "\"{}\" holds a study that differs in {}: name another folder (-o), or give that one up with --restart",
        folder_, difference));
  write_text(file, identity.json());
}

std::string TradeoffStore::path(const std::string& name) const { return (fs::path(folder_) / name).string(); }

std::optional<TradeoffPoint> TradeoffStore::point(const TradeoffSetting& setting) const {
  const std::string file = path("points/" + setting.id() + ".json");
  if (!fs::exists(file) || !fs::exists(path(picture_name(setting))) || !fs::exists(path(difference_name(setting))))
    return std::nullopt;
  std::optional<TradeoffPoint> point = point_from_json(read_file(file), study_);
  return point && point->setting == setting ? point : std::nullopt;
}

std::optional<TradeoffReference> TradeoffStore::reference(const TradeoffSetting& setting) const {
  if (!fs::exists(path(reference_name))) return std::nullopt;
  TradeoffReference reference;
  reference.picture = read_image(path(reference_name));
  const std::map<std::string, std::string> metadata = std::move(reference.picture.metadata);
  reference.picture.metadata.clear();
  if (!metadata.contains("study") || metadata.at("study") != study_) return std::nullopt;
  reference.setting = setting;
  reference.seconds = number(metadata, "seconds");
  reference.rmse = number(metadata, "rmse");
  reference.rmse_low = number(metadata, "rmse_low");
  reference.rmse_high = number(metadata, "rmse_high");
  return reference;
}

void TradeoffStore::keep(const TradeoffPoint& point, const Image& picture, const Image& difference,
                         double exposure) const {
  static_cast<void>(write_image(picture, path(picture_name(point.setting)), {8, exposure}));
  static_cast<void>(write_image(difference, path(difference_name(point.setting))));
  write_text(path("points/" + point.setting.id() + ".json"), point_json(point, study_));
}

void TradeoffStore::keep(const TradeoffReference& reference) const {
  Image picture = reference.picture;
  picture.metadata = {{"Software", "strahl " STRAHL_VERSION}, {"study", study_}};
  const auto note = [&](const char* name, const std::optional<double>& value) {
    if (value) picture.metadata[name] = fmt::format("{}", *value);
  };
  note("seconds", reference.seconds);
  note("rmse", reference.rmse);
  note("rmse_low", reference.rmse_low);
  note("rmse_high", reference.rmse_high);
  static_cast<void>(write_image(picture, path(reference_name)));
}

void TradeoffStore::publish(const TradeoffStudy& study) const {
  const std::string json = tradeoff_json(study);
  std::map<std::string, std::string> pictures;
  const auto add = [&](const std::string& name) { pictures[name] = read_file(path(name)); };
  add(reference_picture_name);
  for (const TradeoffPoint& point : study.points) {
    add(picture_name(point.setting));
    add(difference_name(point.setting));
  }
  write_text(path(json_name), json);
  write_text(path(table_name), tradeoff_csv(study));
  write_text(path(report_name), html_report(json, pictures));
}

}  // namespace strahl

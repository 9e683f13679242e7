// SPDX-License-Identifier: MIT
// report.html names what goes into it, {{page.css}} or {{study}}, and is read through once: nothing that was put in
// is looked at again. Data stand in blocks that are not run, where the only danger is an end tag or a comment in a
// string: JSON spells every < there \u003c. The page's content security policy keeps it from asking for anything.
#include "study/report/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "errors.h"
#include "study/report/embedded_report.h"

namespace strahl {
namespace {

using Json = nlohmann::ordered_json;
using Insertions = std::map<std::string, std::string, std::less<>>;

Json parsed(const std::string& tradeoff_json) {
  try {
    return Json::parse(tradeoff_json);
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("the study of a trade-off is not JSON: {}", error.what()));
  }
}

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t taken = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < taken ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= taken ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// What of an object's member names a picture goes into `uris` under that name.
void take_picture(const Json& object, const char* member, const std::map<std::string, std::string>& pictures,
                  Json& uris) {
  const auto name = object.find(member);
  if (name == object.end() || name->is_null()) return;
  const auto picture = pictures.find(name->get<std::string>());
  if (picture == pictures.end()) {
    throw InputError(
        fmt::format("the study of a trade-off names a picture that is not there: \"{}\"", name->get<std::string>()));
  }
  uris[picture->first] = "data:image/png;base64," + base64(picture->second);
}

/// Throws InputError where there is nothing to show.
Json with_points(Json study) {
  if (study.at("points").empty()) throw InputError("the study of a trade-off has no points");
  return study;
}

Json picture_uris(const Json& study, const std::map<std::string, std::string>& pictures) {
  Json uris = Json::object();
  take_picture(study.at("reference"), "picture", pictures, uris);
  for (const Json& point : study.at("points")) {
    take_picture(point, "picture", pictures, uris);
    take_picture(point, "difference", pictures, uris);
  }
  return uris;
}

/// The same JSON, fit to stand in a <script> element.
std::string inside_script(std::string_view json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string filled(std::string_view page, const Insertions& insertions) {
  std::string text;
  while (true) {
    const std::size_t open = page.find("{{");
    text += page.substr(0, open);
    if (open == std::string_view::npos) return text;
    const std::size_t close = page.find("}}", open);
    if (close == std::string_view::npos) throw std::logic_error("report.html: {{ without }}");
    const auto insertion = insertions.find(page.substr(open + 2, close - open - 2));
    if (insertion == insertions.end()) {
      throw std::logic_error(fmt::format("report.html: nothing is called {}", page.substr(open, close + 2 - open)));
    }
    text += insertion->second;
    page.remove_prefix(close + 2);
  }
}

}  // namespace

std::string html_report(const std::string& tradeoff_json, const std::map<std::string, std::string>& pictures) {
  Insertions insertions;
  for (const EmbeddedReportFile& file : embedded_report_files()) insertions.emplace(file.name, file.text);
  insertions.emplace("study", inside_script(tradeoff_json));
  insertions.emplace("pictures", inside_script(picture_uris(with_points(parsed(tradeoff_json)), pictures).dump()));
  return filled(insertions.at("report.html"), insertions);
}

}  // namespace strahl

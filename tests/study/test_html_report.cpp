// SPDX-License-Identifier: MIT
// The report as a file: what was put in comes out again, nothing breaks out of it, and nothing is asked of a network.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "errors.h"
#include "study/report/html_report.h"

using nlohmann::json;
using strahl::html_report;

namespace {

json study() {
  return json{
      {"strahl", "0.0"},
      {"scene", "box.xml"},
      {"reference", {{"picture", "reference.png"}}},
      {"points",
       {{{"id", "a"}, {"picture", "points/a.png"}, {"difference", "points/a.difference.png"}, {"psnr", nullptr}}}},
      {"fits", json::array()}};
}

const std::map<std::string, std::string> pictures{{"reference.png", "foobar"},
                                                  {"points/a.png", "fooba"},
                                                  {"points/a.difference.png", std::string("\0\xff\xfe\xfd", 4)}};

std::string block(const std::string& page, const std::string& id) {
  const std::string start = "<script type=\"application/json\" id=\"" + id + "\">";
  const std::size_t begin = page.find(start);
  REQUIRE(begin != std::string::npos);
  const std::size_t from = begin + start.size();
  return page.substr(from, page.find('<', from) - from);
}

std::size_t count(const std::string& page, const std::string& text) {
  std::size_t found = 0;
  for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("the study is in the page as it was") {
  const json given = study();
  for (const int indent : {-1, 2})
    CHECK(json::parse(block(html_report(given.dump(indent), pictures), "study")) == given);
}

TEST_CASE("nothing in the study ends its block or opens another") {
  json given = study();
  given["scene"] = "</script><script>alert(1)</script>\u2028<!--<script>{{main.js}}{{study}}";
  given["points"][0]["id"] = "\"</SCRIPT >&lt;'";
  const std::string page = html_report(given.dump(), pictures);
  CHECK(json::parse(block(page, "study")) == given);
  const std::string harmless = html_report(study().dump(), pictures);
  for (const char* tag : {"<script", "</script", "<!--"}) CHECK(count(page, tag) == count(harmless, tag));
}

TEST_CASE("every picture that the study names is in the page, and no other") {
  auto given = pictures;
  given["unnamed.png"] = "x";
  const json uris = json::parse(block(html_report(study().dump(), given), "pictures"));
  CHECK(uris == json{{"reference.png", "data:image/png;base64,Zm9vYmFy"},
                     {"points/a.png", "data:image/png;base64,Zm9vYmE="},
                     {"points/a.difference.png", "data:image/png;base64,AP/+/Q=="}});
}

TEST_CASE("a point may have no difference") {
  json given = study();
  given["points"][0]["difference"] = nullptr;
  CHECK(json::parse(block(html_report(given.dump(), pictures), "pictures")).size() == 2);
}

TEST_CASE("a page without one of its pictures is not made") {
  auto given = pictures;
  given.erase("points/a.png");
  CHECK_THROWS_AS(html_report(study().dump(), given), strahl::InputError);
  CHECK_THROWS_AS(html_report("{", pictures), strahl::InputError);
}

TEST_CASE("a page without points is not made") {
  json given = study();
  given["points"] = json::array();
  CHECK_THROWS_AS(html_report(given.dump(), pictures), strahl::InputError);
}

TEST_CASE("the page names nothing that a browser would fetch") {
  const std::string page = html_report(study().dump(), pictures);
  for (const char* word : {"http:", "https:", "//cdn", "@import", "url(", "fetch(", "XMLHttpRequest", "import("})
    CHECK(count(page, word) == 0);
  CHECK_FALSE(std::regex_search(page, std::regex("<[^>]*\\s(src|href|action|data)=\"(?!#)")));
  CHECK(count(page, "Content-Security-Policy\" content=\"default-src 'none'") == 1);
}

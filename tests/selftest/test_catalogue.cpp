// SPDX-License-Identifier: MIT
// The catalogue itself: every case is there, every frozen answer is the oracle's, every rule of the loader holds, and
// every test that a row names exists.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "errors.h"
#include "scene/scene_text.h"
#include "selftest/answer.h"
#include "selftest/catalogue.h"

using namespace strahl;
using namespace strahl::selftest;

namespace {

std::string contents_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::filesystem::path source(const std::string& path) { return std::filesystem::path(STRAHL_SOURCE_DIR) / path; }

struct Family {
  const char* prefix;
  int cases;
};

/// Ids run from 01: S01 ... S26.
constexpr Family numbered[] = {{"S", 26}, {"PL", 11}, {"T", 23}, {"A", 18}, {"R", 8},
                               {"D", 8},  {"Y", 10},  {"C", 6},  {"CB", 5}, {"M", 8}};

}  // namespace

TEST_CASE("every case has its row, once") {
  std::set<std::string> ids, wanted;
  for (const Row& row : catalogue()) {
    INFO(row.id);
    CHECK(ids.insert(row.id).second);
  }
  for (const Family& family : numbered)
    for (int i = 1; i <= family.cases; ++i)
      wanted.insert(family.prefix + std::string(i < 10 ? "0" : "") + std::to_string(i));
  CHECK(ids == wanted);
}

TEST_CASE("frozen answers are those of exact arithmetic") {
  int count = 0;
  for (const Row& row : catalogue())
    for (std::size_t i = 0; i < row.frozen.size(); ++i, ++count) {
      const Question& q = row.frozen[i];
      const ExactAnswer exact = exact_answer(q);
      INFO("[" << row.id << "] case " << i);
      if (q.expected == Expected::either) {
        CHECK_FALSE(exact.is_promised);
        continue;
      }
      CHECK(exact.hit == (q.expected == Expected::hit));
      if (!exact.hit) continue;
      if (q.primitive >= 0) CHECK(q.primitive == exact.primitive);
      CHECK(q.t.value == exact.t.value);
      CHECK(std::fabs(q.t.rest - exact.t.rest) <= 0x1p-90 * std::fabs(exact.t.value));
      CHECK(q.t_rounding >= 0);
    }
  CHECK(count > 100);
}

TEST_CASE("the loader keeps the rules of the catalogue") {
  int count = 0;
  for (const Row& row : catalogue())
    for (const LoaderRule& rule : row.rules) {
      INFO("[" << row.id << "]\n" << rule.scene);
      ++count;
      const std::vector<std::string> found = test::problems(rule.scene);
      if (rule.refusal.empty()) {
        CHECK(found == std::vector<std::string>{});
        continue;
      }
      REQUIRE(found.size() == 1);
      CHECK(found[0].find("error: ") != std::string::npos);
      CHECK(found[0].find(rule.refusal) != std::string::npos);
    }
  CHECK(count > 10);
}

TEST_CASE("tests that rows name exist and are registered") {
  for (const Row& row : catalogue())
    for (const std::string& test : row.held_by) {
      INFO("[" << row.id << "] " << test);
      const std::filesystem::path path(test);
      CHECK(std::filesystem::is_regular_file(source("tests/" + test)));
      std::string stem = path.stem().string();
      std::string list = contents_of(source("tests/" + path.parent_path().string() + "/tests.cmake"));
      std::replace(list.begin(), list.end(), '\n', ' ');
      const bool in_full = list.find(test) != std::string::npos;
      // Or as "foreach(name a b c) strahl_test(folder/test_${name}.cpp".
      const std::string name = stem.rfind("test_", 0) == 0 ? stem.substr(5) : stem;
      const bool in_loop =
          list.find("/test_${name}.cpp") != std::string::npos &&
          (list.find(" " + name + " ") != std::string::npos || list.find(" " + name + ")") != std::string::npos);
      CHECK((in_full || in_loop));
    }
}

TEST_CASE("docs/catalogue.md lists the rows as they are") {
  const auto cell = [](std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
  };
  std::ostringstream table;
  table << "| id | case | contents | source |\n|---|---|---|---|\n";
  for (const Row& row : catalogue())
    table << "| " << row.id << " | " << cell(row.title) << " | " << contents(row) << " | " << cell(row.source)
          << " |\n";
  const std::filesystem::path path = source("docs/catalogue.md");
  std::string text = contents_of(path);
  const std::size_t begin = text.find("| id |");
  REQUIRE(begin != std::string::npos);
  if (std::getenv("STRAHL_WRITE_CATALOGUE") != nullptr)
    std::ofstream(path) << (text = text.substr(0, begin) + table.str());
  CHECK(text.substr(begin) == table.str());
}

TEST_CASE("a fault in a file of rows names file and line") {
  const auto fault = [](const std::string& text) -> std::string {
    try {
      (void)parse_rows("sphere", text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  const std::string head = "[S01] title\nsource: none\n", shape = "sphere 0 0 0 1\n";
  CHECK(fault(head + shape + "ray 0 0 5 0 0 -1 -> hit 0 t 4 0\n") == "none");
  CHECK(fault("sphere 0 0 0 1\n").find("sphere.txt:1: ") == 0);
  CHECK(fault(head + "sphere 0 0 0 0.1\n") == "sphere.txt:3: 0.1 is not a float; the nearest is 0x1.99999ap-4");
  CHECK(fault(head + "sphere 0 0 0\n") == "sphere.txt:3: the line ends too early");
  CHECK(fault(head + "sphere 0 0 0 1 1\n") == "sphere.txt:3: \"1\" is one word too many");
  CHECK(fault(head + "ray 0 0 5 0 0 -1 -> miss\n") == "sphere.txt:3: a ray needs a shape before it");
  CHECK(fault(head + shape + "ray 0 0 5 0 0 -1\n").find("an answer is needed") != std::string::npos);
  CHECK(fault(head + shape + "ray 0 0 5 0 0 -1 -> hit 1 t 4 0\n").find("not there to be hit") != std::string::npos);
  CHECK(fault(head + shape + "ray 0 0 5 0 0 -1 left 1 -> miss\n").find("not there to be left") != std::string::npos);
  CHECK(fault(head + "generate nothing seed 1 count 1\n") == "sphere.txt:3: there is no generator \"nothing\"");
  CHECK(fault(head + "refuse radius\nray\n").find("sphere.txt:3: the scene is missing") == 0);
  CHECK(fault(head + "ball 0\n") == "sphere.txt:3: unknown word \"ball\"");
  CHECK(fault("[S01] title\nsphere 0 0 0 1\n").find("sphere.txt:1: [S01] names no source") == 0);
  CHECK(fault(head).find("asks nothing") != std::string::npos);
}

TEST_CASE("a generator is the same from the same seed, and refuses sizes that it does not have") {
  const Generated call{"sphere_seen", 7, 3, {{"radius", 2}}};
  const auto parse = [](const std::string& sizes) {
    return parse_rows("sphere", "[S01] t\nsource: none\ngenerate sphere_seen seed 7 count 3 " + sizes + "\n");
  };
  const auto first = questions_of(parse("radius 2")[0]), again = questions_of(parse("radius 2")[0]);
  REQUIRE(first.size() == 3);
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(first[i].ray.direction == again[i].ray.direction);
  CHECK_THROWS_WITH(questions_of(parse("width 2")[0]), Catch::Contains("has no size \"width\""));
}

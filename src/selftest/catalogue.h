// SPDX-License-Identifier: MIT
// The catalogue of hard cases: rows of src/selftest/rows/*.txt, embedded in the program. Its language stands at the
// head of rows/sphere.txt; docs/catalogue.md lists the rows.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "selftest/question.h"

namespace strahl::selftest {

/// Questions from a seed: generators.h.
struct Generated {
  std::string generator;
  std::uint64_t seed = 0;
  int count = 0;
  std::map<std::string, double> sizes;
};

/// What the loader must say to a scene.
struct LoaderRule {
  std::string scene;    ///< The text of a whole scene file.
  std::string refusal;  ///< Words of the error; empty: the scene is accepted.
};

/// A picture and what a test demands of it.
struct Picture {
  std::string scene;  ///< The text of a whole scene file.
  std::string check;  ///< Name of a demand in tests/selftest/test_catalogue_pictures.cpp.
};

/// A row has at least one of the parts below.
struct Row {
  std::string id, title, source;
  bool is_once = false;  ///< Of the primitives of a question exactly one is met, whichever is asked.
  std::vector<Question> frozen;
  std::vector<Generated> generated;
  std::vector<LoaderRule> rules;
  std::vector<Picture> pictures;
  std::vector<std::string> held_by;  ///< Tests by their source file below tests/.
  std::string family;                ///< "sphere": the file that the row stands in.
  int line = 0;
};

/// All rows, in the order of families and then of ids. Throws InputError for a fault, with file and line.
[[nodiscard]] const std::vector<Row>& catalogue();

/// One file of rows. Throws InputError ("sphere.txt:12: ...").
[[nodiscard]] std::vector<Row> parse_rows(const std::string& family, const std::string& text);

/// The frozen questions, then the generated ones: the first `most` of each generator.
[[nodiscard]] std::vector<Question> questions_of(const Row& row, int most = 1 << 30);

/// "12 frozen, 1000 generated, loader": what a row consists of, for people.
[[nodiscard]] std::string contents(const Row& row);

}  // namespace strahl::selftest

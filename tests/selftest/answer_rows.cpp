// SPDX-License-Identifier: MIT
// A tool for authors of rows, no test: answer_rows FILE... fills in "-> ?" with the exact answer of the oracle, in
// place, and lists those that the robust tier does not promise: for the author to leave, or to make "either".
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "selftest/answer.h"
#include "selftest/catalogue.h"

using namespace strahl;
using namespace strahl::selftest;

namespace {

std::string written(const Question& q) {
  const ExactAnswer exact = exact_answer(q);
  if (!exact.hit) return "miss";
  // + 0: no sign of a zero.
  return fmt::format("hit {} t {:a} {:a}", exact.primitive, exact.t.value + 0.0, exact.t.rest + 0.0);
}

std::string answered(const std::string& name, const std::string& text) {
  // Ids and sources are checked with the whole; here each ray is asked with "either" in the place of its answer.
  std::string open = text;
  for (std::size_t at = 0; (at = open.find("-> ?", at)) != std::string::npos;) open.replace(at, 4, "-> either");
  const std::vector<Row> rows = parse_rows(name, open);
  std::vector<const Question*> questions;
  for (const Row& row : rows)
    for (const Question& q : row.frozen) questions.push_back(&q);
  std::istringstream lines(text);
  std::string line, result;
  std::size_t next = 0;
  while (std::getline(lines, line)) {
    const bool is_ray = line.rfind("ray ", 0) == 0;
    if (const auto at = line.find("-> ?"); is_ray && at != std::string::npos) {
      const Question& q = *questions.at(next);
      line.replace(at, 4, "-> " + written(q));
      if (!exact_answer(q).is_promised) std::cout << name << ": exact, but not promised: " << line << '\n';
    }
    next += is_ray;
    result += line + "\n";
  }
  return result;
}

}  // namespace

int main(int count, char** files) try {
  for (int i = 1; i < count; ++i) {
    std::ifstream in(files[i]);
    std::ostringstream text;
    text << in.rdbuf();
    const std::string result = answered(std::filesystem::path(files[i]).stem().string(), text.str());
    std::ofstream(files[i]) << result;
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}

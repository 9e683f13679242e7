// SPDX-License-Identifier: MIT
// Tables of what Mitsuba 3 has told (tests/acceptance/mitsuba_*.csv): some words, a place and a colour a row.
#pragma once

#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include "physics/transport_tiers.h"

namespace strahl::test {

/// Told has `at` and `colour`, three numbers each; words: its members for the words, in their order. The first line
/// names the columns.
template <class Told>
std::vector<Told> told_by_mitsuba(const std::string& name, std::initializer_list<std::string Told::*> words) {
  std::ifstream file(STRAHL_SOURCE_DIR "/tests/acceptance/" + name);
  std::vector<Told> all;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream columns(line);
    Told told;
    for (std::string Told::*word : words) std::getline(columns, told.*word, ',');
    for (Triad* numbers : {&told.at, &told.colour})
      for (double& number : *numbers) {
        std::string word;
        std::getline(columns, word, ',');
        number = std::stod(word);
      }
    all.push_back(told);
  }
  return all;
}

}  // namespace strahl::test

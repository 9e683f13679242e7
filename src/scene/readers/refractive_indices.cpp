// SPDX-License-Identifier: MIT
// Gases at 0 C and 1 atmosphere, liquids at 20 C, solids at room temperature, at 589 nm.
#include "scene/readers/refractive_indices.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace strahl {
namespace {

constexpr std::array<std::pair<const char*, double>, 23> indices_of_names{
    {{"vacuum", 1.0},      {"helium", 1.000036},        {"hydrogen", 1.000132},
     {"air", 1.000277},    {"carbon dioxide", 1.00045}, {"water", 1.3330},
     {"acetone", 1.36},    {"ethanol", 1.361},          {"carbon tetrachloride", 1.461},
     {"glycerol", 1.4729}, {"benzene", 1.501},          {"silicone oil", 1.52045},
     {"bromine", 1.661},   {"water ice", 1.31},         {"fused quartz", 1.458},
     {"pyrex", 1.470},     {"acrylic glass", 1.49},     {"polypropylene", 1.49},
     {"bk7", 1.5046},      {"sodium chloride", 1.544},  {"amber", 1.55},
     {"pet", 1.5750},      {"diamond", 2.419}}};

bool is_same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::optional<double> refractive_index(std::string_view name) {
  for (const auto& [known, index] : indices_of_names)
    if (is_same(name, known)) return index;
  return std::nullopt;
}

std::vector<std::string> refractive_names() {
  std::vector<std::string> names;
  for (const auto& [name, index] : indices_of_names) names.emplace_back(name);
  return names;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>

#include "study/generated/scenes.h"

namespace strahl {
namespace {

struct Form {
  const char* name;
  const char* size;
  int least, most;
  Scene (*make)(int);
};

constexpr Form forms[] = {
    {"sphereflake", "DEPTH", 0, 7, sphereflake},
    {"terrain", "TRIANGLES", 2, 100'000'000, terrain},
    {"tetra", "DEPTH", 1, 12, tetra},
    {"lattice", "N", 1, 128, box_lattice},
};

}  // namespace

const std::vector<std::string>& generated_scene_forms() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> texts;
    for (const Form& form : forms) texts.push_back(fmt::format("{}-{}", form.name, form.size));
    texts.emplace_back("ten");
    return texts;
  }();
  return all;
}

Scene generated_scene(const std::string& name) {
  if (name == "ten") return ten_spheres();
  for (const Form& form : forms) {
    const std::string start = fmt::format("{}-", form.name);
    if (!name.starts_with(start)) continue;
    int size = 0;
    const char* end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + start.size(), end, size);
    if (error != std::errc{} || rest != end || size < form.least || size > form.most)
      throw UsageError(
          fmt::format("scene \"{}\": {} is a number from {} to {}", name, form.size, form.least, form.most));
    return form.make(size);
  }
  throw UsageError(fmt::format("unknown scene \"{}\"; there are {}", name, fmt::join(generated_scene_forms(), ", ")));
}

}  // namespace strahl

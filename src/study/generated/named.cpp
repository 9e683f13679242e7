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

/// Whose name and a hyphen `scene` begins with; null: none.
const Form* form_of(const std::string& scene) {
  for (const Form& form : forms)
    if (scene.starts_with(fmt::format("{}-", form.name))) return &form;
  return nullptr;
}

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

bool is_generated_scene(const std::string& name) { return name == "ten" || form_of(name) != nullptr; }

Scene generated_scene(const std::string& name) {
  if (name == "ten") return ten_spheres();
  const Form* const form = form_of(name);
  if (form == nullptr)
    throw UsageError(fmt::format("unknown scene \"{}\"; there are {}", name, fmt::join(generated_scene_forms(), ", ")));
  int size = 0;
  const char* end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + name.find('-') + 1, end, size);
  if (error != std::errc{} || rest != end || size < form->least || size > form->most)
    throw UsageError(
        fmt::format("scene \"{}\": {} is a number from {} to {}", name, form->size, form->least, form->most));
  return form->make(size);
}

}  // namespace strahl

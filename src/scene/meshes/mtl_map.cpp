// SPDX-License-Identifier: MIT
// Options: "Object Files", Wavefront Advanced Visualizer manual, appendix B1, "Options for texture map statements".
#include "scene/meshes/mtl_map.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace strahl {
namespace {

/// Words behind each option; those of -o, -s and -t are up to three numbers.
const std::map<std::string_view, int>& options() {
  static const std::map<std::string_view, int> words = {{"-blendu", 1}, {"-blendv", 1},  {"-boost", 1},  {"-cc", 1},
                                                        {"-clamp", 1},  {"-imfchan", 1}, {"-mm", 2},     {"-bm", 1},
                                                        {"-o", 3},      {"-s", 3},       {"-texres", 1}, {"-t", 3}};
  return words;
}

/// Up to three numbers; what is no number is left for the file's name.
Vec2 numbers(TextCursor& cursor, Vec2 absent) {
  std::array<double, 3> values{absent.x, absent.y, 0};
  for (double& value : values) {
    TextCursor ahead = cursor;
    double number = 0;
    if (!parse_number(ahead.word(), number)) break;
    value = number;
    cursor = ahead;
  }
  return {values[0], values[1]};
}

}  // namespace

MeshTexture read_mtl_map(TextCursor& cursor, const std::string& mtl_path) {
  MeshTexture map;
  while (cursor.find_word()) {
    TextCursor ahead = cursor;
    const std::string_view option = ahead.word();
    const auto known = options().find(option);
    if (known == options().end()) break;
    cursor = ahead;
    if (option == "-s")
      map.scale = numbers(cursor, {1, 1});
    else if (option == "-o")
      map.offset = numbers(cursor, {0, 0});
    else if (option == "-t")
      (void)numbers(cursor, {0, 0});
    else if (option == "-bm")
      map.multiplier = numbers(cursor, {1, 1}).x;
    else if (option == "-clamp")
      map.is_clamped = cursor.word() == "on";
    else
      for (int i = 0; i < known->second; ++i) cursor.word();
  }
  std::string name = cursor.rest();
  if (name.empty()) return map;
  std::replace(name.begin(), name.end(), '\\', '/');
  map.file = (std::filesystem::path(mtl_path).parent_path() / name).lexically_normal().string();
  return map;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// A program is made from names of strahl's own alone: where every string that a scene brings along is an attack (its
// files' names, ids, names of materials and attributes in meshes), text and options are those of the harmless scene.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "image/temporary_folder.h"
#include "kinds/integrators.h"
#include "program/program_text.h"
#include "scene/loader.h"

using namespace strahl;
namespace fs = std::filesystem;

namespace {

/// For names of files and values in XML: whatever might end a string, a comment, a line or an option.
const std::string attack = "*\\ \"; }\n#define real double\n#include <secret> %s`id` -D HAS_AOV=1 '";
/// The same in words of a mesh file.
const std::string word = "*\";}#define-DHAS_AOV=1%s`id`";

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    const auto at = std::string("\"&<>\n'").find(c);
    xml += at == std::string::npos ? std::string(1, c)
                                   : std::vector<std::string>{"&quot;", "&amp;", "&lt;", "&gt;", "&#10;", "&apos;"}[at];
  }
  return xml;
}

/// The regular expression's first group stands before an attack, the second after it.
std::string put_after(const std::string& text, const std::string& where, const std::string& what, int& count) {
  std::string result;
  const std::regex pattern(where);
  auto end = text.cbegin();
  for (auto at = std::sregex_iterator(text.begin(), text.end(), pattern); at != std::sregex_iterator(); ++at, ++count) {
    result.append(end, (*at)[0].first);
    result += (*at)[1].str() + what + (*at)[2].str();
    end = (*at)[0].second;
  }
  return result.append(end, text.cend());
}

fs::path renamed(const fs::path& path) { return path.parent_path() / (attack + path.filename().string()); }

/// A copy of all shipped scenes, all names changed.
class HostileScenes {
 public:
  HostileScenes() {
    for (const auto& entry : fs::recursive_directory_iterator(original)) {
      const fs::path copy = folder_.path() / fs::relative(entry.path(), original);
      if (entry.is_directory()) {
        fs::create_directories(copy);
        continue;
      }
      std::string text = test::bytes_of(entry.path());
      const std::string type = entry.path().extension();
      if (type == ".xml") {
        text = put_after(text, "(\\bid=\")([^\"]*)", escaped(attack + "*/ // "), ids);
        // In the last folder of a path, and without one.
        text = put_after(text, "((?:filename\" value|<include filename)=\"(?:[^\"]*/)?)([^\"/]*\")", escaped(attack),
                         files);
        text = put_after(text, "(\"(?:vertex|face)_)(heat\")", escaped(word), attributes);
      } else if (type == ".obj") {
        text = put_after(text, "(\n?mtllib )(.*)", word, files);
        text = put_after(text, "(\nusemtl )(.*)", word, materials);
      } else if (type == ".mtl") {
        text = put_after(text, "(\nnewmtl )(.*)", word, materials);
      } else if (type == ".ply") {
        text = put_after(text, "(property float )(heat_0)", word, attributes);
      }
      // Named by a mesh, in a word.
      const bool is_word = type == ".mtl";
      test::put_bytes(is_word ? copy.parent_path() / (word + copy.filename().string()) : renamed(copy), text);
    }
  }

  /// Paths of the harmless scene and of the hostile one.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> pairs() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto& entry : fs::recursive_directory_iterator(original))
      if (entry.path().extension() == ".xml")
        all.emplace_back(entry.path(), renamed(folder_.path() / fs::relative(entry.path(), original)));
    return all;
  }

  int ids = 0, files = 0, attributes = 0, materials = 0;

 private:
  const fs::path original = STRAHL_SOURCE_DIR "/scenes";
  test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("no string of a scene is in a program's text or options") {
  const HostileScenes scenes;
  CHECK(scenes.ids > 20);
  CHECK(scenes.files > 20);
  CHECK(scenes.attributes >= 2);
  CHECK(scenes.materials >= 2);
  std::size_t compared = 0;
  std::set<std::string> roots;
  for (const auto& [harmless_path, hostile_path] : scenes.pairs()) {
    INFO(harmless_path);
    const Scene harmless = load_scene(harmless_path).scene, hostile = load_scene(hostile_path).scene;
    CHECK(hostile.name == attack + harmless.name);
    REQUIRE(hostile.shapes.size() == harmless.shapes.size());
    for (const Precision precision : {Precision::robust, Precision::fast})
      for (const char* root : {kinds::integrator(harmless.integrator.name).kernel(), "kernels/intersect.cl"}) {
        roots.insert(root);
        RenderSettings settings;
        settings.precision = precision;
        if (precision == Precision::robust) settings.aovs = {Aov::depth, Aov::shape_id};
        const int lanes = precision == Precision::robust ? 8 : 1;
        const ProgramSource a = program_source(root, features_of(harmless, settings), precision, lanes);
        const ProgramSource b = program_source(root, features_of(hostile, settings), precision, lanes);
        REQUIRE(a.text == b.text);
        REQUIRE(a.options == b.options);
        ++compared;
      }
  }
  CHECK(compared > 150);
  CHECK(roots == std::set<std::string>{"kernels/intersect.cl", "kernels/light_tracing.cl", "kernels/render.cl"});
}

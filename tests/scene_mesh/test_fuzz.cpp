// SPDX-License-Identifier: MIT
// Damaged mesh files: thousands of variants of small seeds, with a fixed random sequence, must each load or end in
// SceneError. Build with -fsanitize=address,undefined to see what a crash would hide.
#include <cstdint>
#include <random>

#include "scene_mesh/ply_bytes.h"
#include "scene_mesh/serialized_bytes.h"
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::bytes;

std::string binary_ply(bool big_endian) {
  std::string text = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\nproperty "
                     "list uchar uchar l\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 4; ++i) {
    text += bytes(static_cast<float>(i % 2), big_endian) + bytes(0.5 * (i / 2), big_endian) +
            bytes<std::int16_t>(0, big_endian) + bytes<std::uint8_t>(2, big_endian) + "ab";
  }
  for (const auto& face : {std::vector{0, 1, 3, 2}, std::vector{0, 1, 3}}) {
    text += bytes(static_cast<std::uint8_t>(face.size()), big_endian);
    for (int i : face) text += bytes(i, big_endian);
  }
  return text;
}

const std::string whole_obj =
    "# c\nmtllib m.mtl\nv 0 0 0\nv 1.5e0 0 0\nv 1 1 0\nv -0 .1e1 +0\nv .5 .5 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 0 "
    "0\nusemtl "
    "a\nf 1/1/1 2/2/1 3/1/2 4/2\ng x\ns 1\nf -5 -4 \\\n -3\nf 1//1 5//1 2//1 3//1 4//1\nl 1 2\np 3\nusemtl b c\nf 2 3 "
    "4\n";
const std::string mtl = "newmtl a\nKd 0.1 0.2 0.3\nKe 1 0 0\nmap_Kd x.png\nnewmtl b c\nKd xyz 1 1 1\nKe 2\n";
const std::string ascii_ply =
    "ply\nformat ascii 1.0\ncomment c\nelement vertex 5\nproperty float x\nproperty float y\nproperty float "
    "z\nproperty "
    "float nx\nproperty float ny\nproperty float nz\nproperty list uchar int l\nelement face 2\nproperty list uchar "
    "int "
    "vertex_indices\nproperty uchar r\nend_header\n0 0 0 0 0 1 0\n1 0 0 0 0 1 1 7\n1 1 0 0 0 1 0\n0 1 0 0 0 0 2 1 "
    "2\n.5 .5 0 "
    "0 0 1 0\n5 0 4 1 2 3 1\n3 0 1 2 255\n";

/// Stored, not squeezed, so that damage comes through; the checksum is made good again.
std::string serialized(const std::string& content) {
  return test::serialized_header(4) + test::zlib_stream(content, 0);
}

std::string serialized_content() {
  test::SerializedMesh mesh;
  mesh.flags = 0x1003;
  mesh.numbers.insert(mesh.numbers.end(), {0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1, 1});
  return mesh.content(4);
}

std::string damaged(std::string text, std::mt19937& random) {
  using namespace std::string_literals;
  static const std::string spice = "\0\n\r\\/#-+.0919999999999eEnif \t\xFF\x80"s;
  const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (std::size_t n = 1 + pick(4); n > 0 && !text.empty(); --n) {
    const std::size_t at = pick(text.size());
    switch (pick(6)) {
      case 0:
        text[at] = static_cast<char>(text[at] ^ (1 << pick(8)));
        break;
      case 1:
        text[at] = static_cast<char>(random());
        break;
      case 2:
        text[at] = spice[pick(spice.size())];
        break;
      case 3:
        text.erase(at, 1 + pick(8));
        break;
      case 4:
        text.insert(at, text.substr(pick(text.size()), pick(30)));
        break;
      default:
        text.insert(at, spice.substr(pick(spice.size()), 1 + pick(6)));
        break;
    }
  }
  if (pick(10) == 0) text.resize(pick(text.size() + 1));
  return text;
}

/// 1 where the file loads; what loads must be sound.
int load(const std::string& path) {
  try {
    const Mesh mesh = read_mesh(path).mesh;
    REQUIRE_FALSE(mesh.triangles.empty());
    for (const auto& triangle : mesh.triangles) {
      for (int v : triangle) REQUIRE(is_finite(mesh.positions.at(static_cast<std::size_t>(v))));
    }
    REQUIRE((mesh.normals.empty() || mesh.normals.size() == mesh.positions.size()));
    for (const Vec3& n : mesh.normals) REQUIRE(length(n) == Approx(1));
    REQUIRE((mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size()));
    return 1;
  } catch (const SceneError& error) {
    REQUIRE_FALSE(error.diagnostics().empty());
    return 0;
  }
}

TEST_CASE("damaged files load or are refused, and never do worse") {
  const test::TempFolder folder;
  std::mt19937 random(20260101);
  folder.write("m.mtl", mtl);
  constexpr int variants = 500;
  for (const auto& [name, seed] : {std::pair<std::string, std::string>{"a.obj", whole_obj},
                                   {"text.ply", ascii_ply},
                                   {"little.ply", binary_ply(false)},
                                   {"big.ply", binary_ply(true)}}) {
    REQUIRE(load(folder.write(name, seed)) == 1);
    int loaded = 0;
    for (int i = 0; i < variants; ++i) loaded += load(folder.write(name, damaged(seed, random)));
    CHECK(loaded > 0);
    CHECK(loaded < variants);
  }
  for (const bool inside : {true, false}) {
    int loaded = 0;
    for (int i = 0; i < variants; ++i) {
      const std::string text =
          inside ? serialized(damaged(serialized_content(), random)) : damaged(test::serialized_file({{}, {}}), random);
      loaded += load(folder.write("a.serialized", text));
    }
    CHECK(loaded > 0);
    CHECK(loaded < variants);
  }
  const std::string user = folder.write("a.obj", whole_obj);
  int loaded = 0;
  for (int i = 0; i < variants; ++i) {
    folder.write("m.mtl", damaged(mtl, random));
    loaded += load(user);
  }
  CHECK(loaded > 0);
}

}  // namespace
}  // namespace strahl

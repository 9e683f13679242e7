// SPDX-License-Identifier: MIT
// Serialized meshes that must be refused, and with which words; files cut off at every byte.
#include <limits>

#include "scene_mesh/serialized_bytes.h"
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::bytes;
using test::serialized_file;
using test::serialized_header;
using test::SerializedMesh;
using test::TempFolder;
using test::zlib_stream;

std::string error_of_index(const std::string& path, int index) {
  try {
    static_cast<void>(read_serialized(path, index));
  } catch (const SceneError& error) {
    return test::text_of(error.diagnostics());
  }
  FAIL("no error");
  return {};
}

TEST_CASE("faults of the file") {
  const TempFolder folder;
  const auto fault = [&](const std::string& text, int index = 0) {
    return error_of_index(folder.write("a.serialized", text), index);
  };
  const std::string sound = serialized_file({{}, {}});
  const std::string kind =
      "a.serialized: error: not a file of serialized meshes: it does not begin with the bytes 1C 04\n";
  CHECK(fault("") == kind);
  CHECK(fault("\x1C\x04") == kind);
  CHECK(fault("ply\nformat ascii 1.0\n") == kind);
  CHECK(fault(serialized_header(5) + sound) ==
        "a.serialized: error: version 5 of serialized meshes is not read, only 3 and 4\n");
  CHECK(fault(sound, 2) ==
        "a.serialized: error: shape_index 2 is out of range: the file has 2 meshes, counted from 0\n");
  CHECK(fault(sound.substr(0, sound.size() - 1), 1) ==
        "a.serialized: error: the list of meshes at the end of the file is damaged; only the first can be read\n");
  std::string lost = sound;
  lost.replace(sound.size() - 12, 8, bytes<std::uint64_t>(7, false));
  CHECK(fault(lost, 1) ==
        "a.serialized: error: no mesh begins at byte 7, where the list at the end of the file puts mesh 1\n");
  lost.replace(sound.size() - 12, 8, bytes<std::uint64_t>(sound.size(), false));
  CHECK(fault(lost, 1) == "a.serialized: error: the list at the end of the file puts mesh 1 where no mesh can be\n");
  CHECK(error_of_index(folder.path() + "/none.serialized", 0) ==
        "none.serialized: error: cannot be read: there is no such file; is the path right?\n");
}

TEST_CASE("faults of the compressed stream") {
  const TempFolder folder;
  const auto fault = [&](const std::string& text) { return test::error_of(folder.write("a.serialized", text)); };
  const std::string content = SerializedMesh{}.content(4);
  CHECK(fault(serialized_header(4) + "not compressed at all") ==
        "a.serialized: error: byte 4: the compressed mesh that begins here is damaged (incorrect header check)\n");
  CHECK(fault(serialized_header(4) + zlib_stream(content.substr(0, content.size() - 1))) ==
        "a.serialized: error: byte 4: the compressed mesh that begins here ends before all that its header promises\n");
  const std::string stream = zlib_stream(content);
  CHECK(fault(serialized_header(4) + stream.substr(0, stream.size() - 6)) ==
        "a.serialized: error: byte 4: the file ends inside the mesh that begins here\n");
  // Stored, not squeezed: one bit of a coordinate turns, and only the checksum knows.
  std::string file = serialized_header(4) + zlib_stream(content, 0);
  file[file.size() - 4 - 12 - 1] ^= 1;
  CHECK(fault(file) ==
        "a.serialized: error: byte 4: the compressed mesh that begins here is damaged (incorrect data check)\n");
}

TEST_CASE("a place in the second mesh counts from the beginning of the file") {
  const TempFolder folder;
  SerializedMesh wrong;
  wrong.indices = {0, 1, 3};
  const std::size_t first = 4 + zlib_stream(SerializedMesh{}.content(4)).size();
  CHECK(error_of_index(folder.write("a.serialized", serialized_file({{}, wrong})), 1) ==
        "a.serialized: error: byte " + std::to_string(first) +
            ": triangle 0 names vertex 3; there are 3, counted from 0\n");
}

TEST_CASE("faults of the mesh") {
  const TempFolder folder;
  const auto fault = [&](const SerializedMesh& mesh) {
    return test::error_of(folder.write("a.serialized", serialized_file({mesh})));
  };
  SerializedMesh bad;
  bad.numbers[4] = std::numeric_limits<double>::infinity();
  CHECK(fault(bad) == "a.serialized: error: byte 0: vertex 2 is not made of finite numbers, and a face uses it\n");
  SerializedMesh empty;
  empty.triangles = 0;
  empty.indices.clear();
  CHECK(fault(empty) ==
        "a.serialized: error: byte 0: mesh without triangles; give it at least one face with an area\n");
}

TEST_CASE("absurd counts of serialized meshes are refused before anything is allocated for them") {
  const TempFolder folder;
  const auto fault = [&](std::uint64_t vertices, std::uint64_t triangles) {
    SerializedMesh mesh;
    mesh.vertices = vertices;
    mesh.triangles = triangles;
    return test::error_of(folder.write("a.serialized", serialized_file({mesh})));
  };
  for (const std::uint64_t most : {std::uint64_t{1} << 31, std::numeric_limits<std::uint64_t>::max()}) {
    const std::string counts = std::to_string(most);
    CHECK(fault(most, 1) == "a.serialized: error: byte 0: the mesh promises " + counts +
                                " vertices and 1 triangles; 2147483647 of each are read at most\n");
    CHECK(fault(3, most) == "a.serialized: error: byte 0: the mesh promises 3 vertices and " + counts +
                                " triangles; 2147483647 of each are read at most\n");
  }
  CHECK(fault(2000000000, 1) ==
        "a.serialized: error: byte 0: the mesh promises 2000000000 vertices and 1 triangles, more than the file can "
        "hold; it is truncated or damaged\n");
}

TEST_CASE("a file cut off anywhere loads its first mesh whole or not at all") {
  const TempFolder folder;
  const std::string sound = serialized_file({{}, {}});
  const std::size_t first = 4 + zlib_stream(SerializedMesh{}.content(4)).size();
  for (std::size_t size = 0; size < sound.size(); ++size) {
    const std::string path = folder.write("a.serialized", sound.substr(0, size));
    if (size < first) {
      CHECK_FALSE(test::error_of(path).empty());
    } else {
      CHECK(read_mesh(path).mesh.triangles.size() == 1);
    }
    CHECK_FALSE(error_of_index(path, 1).empty());
  }
}

}  // namespace
}  // namespace strahl

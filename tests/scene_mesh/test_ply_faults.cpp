// SPDX-License-Identifier: MIT
// PLY files that must be refused, each with line and column or byte offset.
#include <cstdint>
#include <limits>

#include "scene_mesh/ply_bytes.h"
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::bytes;
using test::error_of;
using test::TempFolder;

const std::string vertex_xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string faces = "property list uchar int vertex_indices\n";
const std::string header =
    "ply\nformat ascii 1.0\nelement vertex 3\n" + vertex_xyz + "element face 1\n" + faces + "end_header\n";
const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";

std::string with(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

TEST_CASE("faults of the header") {
  const TempFolder folder;
  const auto fault = [&](const std::string& text) { return error_of(folder.write("a.ply", text)); };
  const std::string data = vertices + "3 0 1 2\n";
  CHECK(fault("") == "a.ply:1:1: error: not a PLY file: it does not begin with \"ply\"\n");
  CHECK(fault("plywood\n") == "a.ply:1:1: error: not a PLY file: it does not begin with \"ply\"\n");
  CHECK(fault("ply\nformat ascii 1.0\n") == "a.ply:1:1: error: the header has no end_header; the file is truncated\n");
  CHECK(fault(with(header, "format ascii 1.0\n", "") + data) == "a.ply:8:1: error: the header names no format\n");
  CHECK(fault(with(header, "1.0", "2.0") + data) == "a.ply:2:1: error: PLY version \"2.0\" is not read, only 1.0\n");
  CHECK(
      fault(with(header, "ascii", "xml") + data) ==
      "a.ply:2:8: error: PLY format \"xml\" is unknown; there are ascii, binary_little_endian and binary_big_endian\n");
  CHECK(fault(with(header, "float y", "half y") + data) ==
        "a.ply:5:10: error: \"half\" is no type of a PLY property\n");
  CHECK(fault(with(header, "float y", "float") + data) == "a.ply:5:1: error: the property has no name\n");
  CHECK(fault(with(header, "property float y\n", "") + data) == "a.ply:3:1: error: the vertices have no property y\n");
  CHECK(fault(with(header, "uchar int", "float int") + data) ==
        "a.ply:8:15: error: a list cannot count its items with \"float\"; use an integer type\n");
  CHECK(fault(with(header, "uchar int", "uchar float") + data) ==
        "a.ply:7:1: error: the property vertex_indices is not a list of integers\n");
  CHECK(fault(with(header, "vertex_indices", "corners") + data) ==
        "a.ply:7:1: error: the faces have no property vertex_indices (or vertex_index)\n");
  CHECK(fault(with(header, "element vertex", "element point") + data) ==
        "a.ply:1:1: error: the header names no element vertex\n");
  CHECK(fault(with(with(header, "element face", "element tristrips"), "vertex_indices", "corners") + data) ==
        "a.ply:7:1: error: the tristrips have no property vertex_indices (or vertex_index)\n");
  CHECK(fault(with(header, "element face 1\n" + faces, "") + vertices) ==
        "a.ply:1:1: error: mesh without triangles: the header names no element face\n");
  CHECK(fault(with(header, "vertex 3", "vertex -3") + data) ==
        "a.ply:3:16: error: \"-3\" is no number of elements of \"vertex\"\n");
  CHECK(fault(with(header, "element vertex 3\n", "") + data) ==
        "a.ply:3:1: error: a property before the first element\n");
}

TEST_CASE("absurd counts are refused before anything is allocated for them") {
  const TempFolder folder;
  const std::string data = vertices + "3 0 1 2\n";
  for (const char* count : {"1000000000", "9223372036854775807", "99999999999999999999999"}) {
    for (const char* element : {"vertex 3", "face 1"}) {
      const std::string name = std::string(element).substr(0, std::string(element).size() - 1);
      const std::string text = error_of(folder.write("a.ply", with(header, element, name + count) + data));
      CHECK(text.find("but the file can hold at most") != std::string::npos);
    }
  }
  const std::string binary = with(with(header, "ascii", "binary_big_endian"), "uchar int", "uint int");
  std::string points;
  for (float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) points += bytes(v, true);
  const std::string place = "a.ply: error: byte " + std::to_string(binary.size() + points.size()) + ": ";
  CHECK(error_of(folder.write("a.ply", binary + points + bytes<std::uint32_t>(4000000000u, true))) ==
        place + "a list \"vertex_indices\" of 4000000000 items: the file is too short for it\n");
  const std::string negative = with(binary, "uint int", "int int");
  CHECK(error_of(folder.write("a.ply", negative + points + bytes<std::int32_t>(-1, true) + "    ")) ==
        "a.ply: error: byte " + std::to_string(negative.size() + points.size()) +
            ": a list \"vertex_indices\" of -1 items: less than none\n");
}

TEST_CASE("faults of the text") {
  const TempFolder folder;
  const auto fault = [&](const std::string& data) { return error_of(folder.write("a.ply", header + data)); };
  CHECK(fault("0 0 0\n1 0\n0 1 0\n3 0 1 2\n") ==
        "a.ply:11:4: error: the line ends before all values that the header names\n");
  CHECK(fault(vertices + "\n\n      \n") ==
        "a.ply:16:1: error: the file ends before the elements that its header promises\n");
  CHECK(fault("0 0 0\n1 0 0\n0 1 0\n3 0\n1\n") ==
        "a.ply:15:1: error: the file ends before the elements that its header promises\n");
  CHECK(fault("0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n") == "a.ply:11:5: error: \"x\" is not a number\n");
  CHECK(fault(vertices + "3 0 1 3\n") ==
        "a.ply:13:7: error: vertex index 3 is out of range: there are 3, counted from 0\n");
  CHECK(fault(vertices + "3 -1 1 2\n") ==
        "a.ply:13:3: error: vertex index -1 is out of range: there are 3, counted from 0\n");
  CHECK(fault(vertices + "3 0 1 1.5\n") == "a.ply:13:7: error: 1.5 is not an integer of 32 bits\n");
  CHECK(fault(vertices + "-3 0 1 2\n") == "a.ply:13:1: error: a list \"vertex_indices\" of -3 items: less than none\n");
  CHECK(fault(vertices + "99 0 1 2\n") ==
        "a.ply:13:1: error: a list \"vertex_indices\" of 99 items: the file is too short for it\n");
  CHECK(fault(vertices + "2 0 1 2\n")
            .ends_with("a.ply: error: mesh without triangles; give it at least one face with an area\n"));
  CHECK(fault("0 inf 0\n1 0 0\n0 1 0\n3 0 1 2\n") ==
        "a.ply:10:1: error: vertex 1 is not made of finite numbers, and the face in line 13 uses it\n");
}

TEST_CASE("faults of triangle strips") {
  const TempFolder folder;
  const std::string strips = with(header, "element face", "element tristrips");
  const auto fault = [&](const std::string& text) { return error_of(folder.write("a.ply", text)); };
  CHECK(fault(strips + vertices + "5 0 1 2 -1 3\n") ==
        "a.ply:13:12: error: vertex index 3 is out of range: there are 3, counted from 0\n");
  CHECK(fault(strips + vertices + "5 0 1 -1 2 1\n") ==
        "a.ply: error: mesh without triangles; give it at least one face with an area\n");
}

TEST_CASE("faults of the binary data") {
  const TempFolder folder;
  const std::string binary = with(header, "ascii", "binary_little_endian");
  std::string points;
  for (float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) points += bytes(v, false);
  const auto face = [](std::int32_t last) {
    return bytes<std::uint8_t>(3, false) + bytes(0, false) + bytes(1, false) + bytes(last, false);
  };
  const auto at = [&](std::size_t offset) {
    return "a.ply: error: byte " + std::to_string(binary.size() + offset) + ": ";
  };
  CHECK(read_mesh(folder.write("a.ply", binary + points + face(2))).mesh.triangles.size() == 1);
  CHECK(error_of(folder.write("a.ply", binary + points + face(3))) ==
        at(45) + "vertex index 3 is out of range: there are 3, counted from 0\n");
  CHECK(error_of(folder.write("a.ply", binary + points + face(-1))).starts_with(at(45)));
  for (std::size_t cut = 1; cut < 13; ++cut) {
    const std::string whole = binary + points + face(2);
    CHECK(error_of(folder.write("a.ply", whole.substr(0, whole.size() - cut))) ==
          (cut < 13 ? at(36) + "a list \"vertex_indices\" of 3 items: the file is too short for it\n" : ""));
  }
  CHECK(error_of(folder.write("a.ply", binary + points)).find("can hold at most 0") != std::string::npos);
  std::string nan = points;
  nan.replace(16, 4, bytes(std::numeric_limits<float>::quiet_NaN(), false));
  CHECK(error_of(folder.write("a.ply", binary + nan + face(2))) ==
        at(12) + "vertex 2 is not made of finite numbers, and a face uses it\n");
}

}  // namespace
}  // namespace strahl

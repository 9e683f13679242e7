// SPDX-License-Identifier: MIT
// npy files: hand-made ones of every version, type and order, damaged ones, and what is written.
#include <catch2/catch.hpp>
#include <string>

#include "errors.h"
#include "image/damaged_files.h"
#include "image/npy.h"
#include "image/pictures.h"
#include "image/temporary_folder.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;
using namespace std::string_literals;

namespace {

/// A file as numpy.save writes it.
std::string npy(int version, const std::string& dictionary, const std::string& data) {
  std::string file = "\x93NUMPY"s + static_cast<char>(version) + '\0';
  std::string header = dictionary + '\n';
  file += static_cast<char>(header.size() & 255U);
  file += static_cast<char>(header.size() >> 8U);
  if (version > 1) file += "\0\0"s;
  return file + header + data;
}

std::string dictionary(const std::string& descr, bool fortran, const std::string& shape) {
  return "{'descr': '" + descr + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }";
}

// 1, 2, 3, 4, 5, 6.5 in each type.
const std::string f4 = "\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40\0\0\x80\x40\0\0\xa0\x40\0\0\xd0\x40"s;
const std::string f4_big = "\x3f\x80\0\0\x40\0\0\0\x40\x40\0\0\x40\x80\0\0\x40\xa0\0\0\x40\xd0\0\0"s;
const std::string f8 =
    "\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\0\x40\0\0\0\0\0\0\x08\x40\0\0\0\0\0\0\x10\x40\0\0\0\0\0\0\x14\x40\0\0\0\0\0\0\x1a\x40"s;
const std::string f8_big =
    "\x3f\xf0\0\0\0\0\0\0\x40\0\0\0\0\0\0\0\x40\x08\0\0\0\0\0\0\x40\x10\0\0\0\0\0\0\x40\x14\0\0\0\0\0\0\x40\x1a\0\0\0\0\0\0"s;

const std::vector<double> numbers{1, 2, 3, 4, 5, 6.5};

}  // namespace

TEST_CASE("every version, type and order") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.npy";
  for (const auto& [descr, data] : {std::pair{"<f4", f4}, {">f4", f4_big}, {"<f8", f8}, {">f8", f8_big}}) {
    for (const int version : {1, 2, 3}) {
      INFO(descr << " version " << version);
      put_bytes(path, npy(version, dictionary(descr, false, "(2, 3)"), data));
      const Matrix rows = read_npy(path);
      CHECK(rows.rows == 2);
      CHECK(rows.columns == 3);
      CHECK(rows.data == numbers);
      put_bytes(path, npy(version, dictionary(descr, true, "(2, 3)"), data));
      CHECK(read_npy(path).data == std::vector<double>{1, 3, 5, 2, 4, 6.5});
    }
  }
}

TEST_CASE("other ways to write the same header") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.npy";
  for (const std::string header : {"{'shape':(3,2),'fortran_order':False,'descr':'<f8'}",
                                   "{ \"descr\" : \"<f8\",\n\"fortran_order\": False, "
                                   "'shape': ( 3 , 2 , ) }        ",
                                   "{'descr': '<f8', 'fortran_order': False, 'shape': (3L, 2L), }"}) {
    INFO(header);
    put_bytes(path, npy(1, header, f8));
    CHECK(read_npy(path).rows == 3);
    CHECK(read_npy(path).data == numbers);
  }
}

TEST_CASE("a written matrix is read back bit by bit and is what numpy expects") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.npy";
  Matrix matrix{3, 5, {}};
  for (const float value : awkward_values()) matrix.data.push_back(static_cast<double>(value) * 1.1);
  write_npy(matrix, path);
  const std::string bytes = bytes_of(path);
  CHECK(bytes.substr(0, 8) == "\x93NUMPY\x01\0"s);
  CHECK(bytes.size() == 128 + 15 * 8);
  CHECK(bytes[127] == '\n');
  CHECK(static_cast<unsigned char>(bytes[8]) + 256 * static_cast<unsigned char>(bytes[9]) == 118);
  CHECK(bytes.substr(10, 61) == "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 5), }  ");
  const Matrix back = read_npy(path);
  CHECK(back.rows == 3);
  CHECK(back.columns == 5);
  REQUIRE(back.data.size() == matrix.data.size());
  CHECK(std::memcmp(back.data.data(), matrix.data.data(), 15 * sizeof(double)) == 0);
  CHECK_THROWS_AS(write_npy({2, 2, {1}}, path), Error);
}

TEST_CASE("no rows at all") {
  const TemporaryFolder folder;
  write_npy({0, 8, {}}, folder / "a.npy");
  const Matrix matrix = read_npy(folder / "a.npy");
  CHECK(matrix.rows == 0);
  CHECK(matrix.columns == 8);
  CHECK(matrix.data.empty());
}

TEST_CASE("rows without columns take no time, however many the header states") {
  const TemporaryFolder folder;
  for (const bool is_fortran : {false, true}) {
    put_bytes(folder / "a.npy", npy(1, dictionary("<f8", is_fortran, "(1000000000000000000, 0)"), ""));
    const Matrix matrix = read_npy(folder / "a.npy");
    CHECK(matrix.columns == 0);
    CHECK(matrix.data.empty());
  }
}

TEST_CASE("what is no matrix of floats is refused with the remedy") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.npy";
  const auto refusal = [&path](const std::string& bytes, const std::string& reason) {
    put_bytes(path, bytes);
    INFO(bytes.substr(0, 80));
    CHECK_THROWS_AS(read_npy(path), InputError);
    CHECK_THROWS_WITH(read_npy(path), Contains(path) && Contains(reason));
  };
  refusal("hello, this is no such file", "numpy.save");
  refusal("", "not an npy file");
  refusal("\x93NUMPY", "truncated");
  refusal(npy(4, dictionary("<f8", false, "(2, 3)"), f8), "version 4");
  for (const std::string type : {"<i4", "<f2", "|b1", "<c8", "|O"}) {
    refusal(npy(1, dictionary(type, false, "(2, 3)"), f8), "type " + type + ", not float32 or float64; convert with");
  }
  refusal(npy(1, "{'descr': [('x', '<f8'), ('y', '<f8')], 'fortran_order': False, 'shape': (3,), }", f8),
          "('y', '<f8')");
  refusal(npy(1, dictionary("<f8", false, "(6,)"), f8), "array.reshape(1, -1)");
  refusal(npy(1, dictionary("<f8", false, "()"), f8), "not a matrix");
  refusal(npy(1, dictionary("<f8", false, "(1, 2, 3)"), f8), "shape (1, 2, 3), not a matrix");
  refusal(npy(1, dictionary("<f8", false, "(2, 4)"), f8), "48 bytes of data do not fit 2 x 4");
  refusal(npy(1, dictionary("<f8", false, "(2, 3)"), f8 + "x"), "49 bytes");
  refusal(npy(1, dictionary("<f8", false, "(2, -3)"), f8), "a length expected");
  refusal(npy(1, "{'descr': '<f8', 'shape': (2, 3)}", f8), "lacks");
  refusal(npy(1, "{'descr': '<f8', 'other': 1}", f8), "descr, fortran_order or shape expected");
  refusal(npy(1, "{'descr': '<f8', 'fortran_order': Maybe}", f8), "True or False");
}

TEST_CASE("shapes whose size overflows") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.npy";
  // The first two need 48 bytes modulo 2^64, as many as there are; the others overflow or exceed the number itself.
  for (const std::string shape :
       {"(2305843009213693958, 1)", "(2305843009213693954, 3)", "(4294967296, 4294967296)", "(18446744073709551615, 3)",
        "(0, 6)", "(99999999999999999999999, 1)", "(1000000000000, 11)"}) {
    INFO(shape);
    put_bytes(path, npy(1, dictionary("<f8", false, shape), f8));
    CHECK_THROWS_AS(read_npy(path), InputError);
  }
}

TEST_CASE("damaged NPY files") {
  const TemporaryFolder folder;
  const auto read = [](const std::string& name) { return read_npy(name); };
  const std::string good = npy(2, dictionary("<f4", true, "(2, 3)"), f4);
  check_truncations(good, folder / "a.npy", read);
  CHECK(check_mutations(good, folder / "a.npy", 1000, read) > 500);
}

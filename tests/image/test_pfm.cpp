// SPDX-License-Identifier: MIT
// PFM files: bit-exact both ways, both byte orders, hand-made files, damaged files.
#include <catch2/catch.hpp>
#include <string_view>

#include "errors.h"
#include "image/damaged_files.h"
#include "image/image_io.h"
#include "image/pictures.h"
#include "image/temporary_folder.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;
using namespace std::string_literals;

TEST_CASE("values survive bit by bit, colour and grey") {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& channels : {std::vector<std::string>{"R", "G", "B"}, {"Y"}}) {
    const Image image = picture(5, 3, channels, awkward_values());
    const WriteReport report = write_image(image, folder / "a.pfm");
    CHECK(report.invalid == (channels.size() == 1 ? 3 : 9));
    CHECK(report.clipped == 0);
    const Image back = read_image(folder / "a.pfm");
    CHECK(back.width == 5);
    CHECK(back.height == 3);
    CHECK(back.channels == channels);
    CHECK(bits(back.data) == bits(image.data));
  }
}

TEST_CASE("the file is what the format says: little-endian, bottom row first") {
  const TemporaryFolder folder;
  write_image(picture(1, 2, {"Y"}, {1, -2}), folder / "a.pfm");
  CHECK(bytes_of(folder / "a.pfm") == "Pf\n1 2\n-1.0\n\x00\x00\x00\xc0\x00\x00\x80\x3f"s);
}

TEST_CASE("alpha is left out and a missing blue is 0") {
  const TemporaryFolder folder;
  write_image(picture(1, 1, {"R", "G", "B", "A"}, {1, 2, 3, 4}), folder / "a.pfm");
  CHECK(read_image(folder / "a.pfm").data == std::vector<float>{1, 2, 3});
  write_image(picture(1, 1, {"uv.U", "uv.V"}, {1, 2}), folder / "a.pfm");
  CHECK(read_image(folder / "a.pfm").data == std::vector<float>{1, 2, 0});
}

TEST_CASE("big-endian files, and a scale other than 1") {
  const TemporaryFolder folder;
  put_bytes(folder / "a.pfm", "Pf\n1 2\n1\n\xc0\x00\x00\x00\x3f\x80\x00\x00"s);
  CHECK(read_image(folder / "a.pfm").data == std::vector<float>{1, -2});
  put_bytes(folder / "a.pfm", "PF 1 1 -0.5\n\x00\x00\x80\x3f\x00\x00\x00\xc0\x00\x00\x80\x3f"s);
  CHECK(read_image(folder / "a.pfm").data == std::vector<float>{0.5F, -1, 0.5F});
}

TEST_CASE("damaged PFM files") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.pfm";
  const auto read = [](const std::string& name) { return read_image(name); };
  for (const std::string& bad :
       {"P6\n1 1\n255\nabc"s, "Pf\n1 1\n0\nabcd"s, "Pf\n0 1\n-1\n"s, "Pf\n-1 -1\n-1\nabcd"s, "Pf\n1 1\nnan\nabcd"s,
        "Pf\n1x 1\n-1\nabcd"s, "Pf\n1 1\n-1\nabcdefgh"s, "Pf\r\n1 1\r\n-1\r\nabcd"s, "PF\n99999 99999\n-1\nabcd"s,
        "PF\n2147483647 2147483647\n-1\nabcd"s, "PF\n4294967296 4294967296\n-1\n"s}) {
    put_bytes(path, bad);
    INFO(bad);
    CHECK_THROWS_AS(read_image(path), InputError);
  }
  put_bytes(path, "Pf\n2 3\n-1\nabcd");
  CHECK_THROWS_WITH(read_image(path), Contains("a.pfm") && Contains("2 x 3 pixels need 24 bytes") && Contains("has 4"));
  write_image(picture(7, 5, {"R", "G", "B"}, {1, 2, 3}), folder / "good.pfm");
  const std::string good = bytes_of(folder / "good.pfm");
  check_truncations(good, path, read);
  CHECK(check_mutations(good, path, 300, read) > 3);
}

// SPDX-License-Identifier: MIT
// Formats by extension, and the checks that all formats share.
#include <catch2/catch.hpp>

#include "errors.h"
#include "image/colour_channels.h"
#include "image/image_io.h"
#include "image/pictures.h"
#include "image/temporary_folder.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

TEST_CASE("the extension decides, in any case") {
  CHECK(image_format("a/b.png") == ImageFormat::png);
  CHECK(image_format("a.b.EXR") == ImageFormat::exr);
  CHECK(image_format("x.Pfm") == ImageFormat::pfm);
}

TEST_CASE("an unknown extension is a mistake of usage that names the known ones") {
  for (const std::string path : {"a.jpg", "a", "png", "a.png/b"}) {
    CHECK_THROWS_AS(image_format(path), UsageError);
    CHECK_THROWS_WITH(image_format(path), Contains(path) && Contains(".png, .exr and .pfm"));
    CHECK_THROWS_AS(read_image(path), UsageError);
    CHECK_THROWS_AS(write_image(Image{}, path), UsageError);
  }
}

TEST_CASE("pictures that are none are not written") {
  const TemporaryFolder folder;
  const Image good = picture(2, 2, {"R", "G", "B"}, {0});
  for (const std::string name : {"a.png", "a.exr", "a.pfm"}) {
    Image bad = good;
    bad.width = 0;
    CHECK_THROWS_AS(write_image(bad, folder / name), Error);
    bad = good;
    bad.data.pop_back();
    CHECK_THROWS_WITH(write_image(bad, folder / name), Contains("needs 12 values and has 11"));
    bad = good;
    bad.channels = {"R", "G", "R"};
    CHECK_THROWS_WITH(write_image(bad, folder / name), Contains("R, G, R"));
    CHECK_THROWS_WITH(write_image(good, folder / ("none/" + name)), Contains("create it first"));
    CHECK_THROWS_AS(read_image(folder / name), InputError);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("a picture without a colour is no PNG and no PFM") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.png", "a.pfm"})
    CHECK_THROWS_WITH(write_image(picture(2, 2, {"A"}, {1}), folder / name), Contains("channels, A, have none"));
  CHECK(folder.names().empty());
  write_image(picture(2, 2, {"A"}, {1}), folder / "a.exr");
  CHECK(read_image(folder / "a.exr").channels == std::vector<std::string>{"A"});
  write_image(picture(2, 2, {"A", "B"}, {0.25F, 0.75F}), folder / "a.pfm");
  CHECK(read_image(folder / "a.pfm").data == std::vector<float>(4, 0.75F));
  write_image(picture(1, 1, {"U", "V"}, {0.25F, 0.75F}), folder / "a.pfm");
  CHECK(read_image(folder / "a.pfm").data == std::vector<float>{0.25F, 0.75F, 0});
}

TEST_CASE("a file of one format under the name of another") {
  const TemporaryFolder folder;
  const Image image = picture(2, 2, {"R", "G", "B"}, {0.5F});
  for (const std::string from : {"png", "exr", "pfm"}) {
    write_image(image, folder / ("a." + from));
    for (const std::string to : {"png", "exr", "pfm"}) {
      if (from == to) continue;
      put_bytes(folder / ("b." + to), bytes_of(folder / ("a." + from)));
      CHECK_THROWS_AS(read_image(folder / ("b." + to)), InputError);
    }
  }
}

TEST_CASE("colour is the first layer without its alpha") {
  const auto colours = [](std::vector<std::string> channels) {
    Image image;
    image.channels = std::move(channels);
    return colour_channels(image);
  };
  CHECK(colours({"R", "G", "B", "A", "normal.X"}) == std::vector{0, 1, 2});
  CHECK(colours({"A", "R", "G", "B"}) == std::vector{1, 2, 3});
  CHECK(colours({"Y", "A"}) == std::vector{0});
  CHECK(colours({"Y", "normal.X", "normal.Y"}) == std::vector{0});
  CHECK(colours({"a.b.X", "a.b.Y", "a.b.A", "a.b.Z", "a.b.W"}) == std::vector{0, 1, 3});
}

// SPDX-License-Identifier: MIT
// PNG files: exact codes, exposure, counts, metadata, every colour type that libpng can write, damaged files.
#include <png.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "errors.h"
#include "image/damaged_files.h"
#include "image/image_io.h"
#include "image/pictures.h"
#include "image/srgb.h"
#include "image/temporary_folder.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

/// The file's 8-bit codes by libpng's own simplified interface.
std::vector<png_byte> codes(const std::string& path, png_uint_32 format) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, path.c_str()) != 0);
  image.format = format;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  return pixels;
}

struct Raw {
  int width, height, bits, colour_type;
  std::vector<std::vector<png_byte>> rows;
  int interlace = PNG_INTERLACE_NONE;
  double gamma = 0;
  std::vector<png_color> palette{};
  std::vector<png_byte> palette_alpha{};
  const char* latin1 = nullptr;
};

void put_png(const std::string& path, Raw raw) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  REQUIRE(file);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, static_cast<png_uint_32>(raw.width), static_cast<png_uint_32>(raw.height), raw.bits,
               raw.colour_type, raw.interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (raw.gamma > 0) png_set_gAMA(png, info, raw.gamma);
  if (!raw.palette.empty()) png_set_PLTE(png, info, raw.palette.data(), static_cast<int>(raw.palette.size()));
  if (!raw.palette_alpha.empty()) {
    png_set_tRNS(png, info, raw.palette_alpha.data(), static_cast<int>(raw.palette_alpha.size()), nullptr);
  }
  std::string key = "Comment";
  std::string value = raw.latin1 ? raw.latin1 : "";
  png_text text{};
  text.compression = PNG_TEXT_COMPRESSION_zTXt;
  text.key = key.data();
  text.text = value.data();
  if (raw.latin1) png_set_text(png, info, &text, 1);
  std::vector<png_bytep> rows;
  for (auto& row : raw.rows) rows.push_back(row.data());
  png_set_rows(png, info, rows.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

}  // namespace

TEST_CASE("all 8-bit codes come out as they went in") {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& channels : {std::vector<std::string>{"Y"}, rgb}) {
    Image image = picture(16, 16 * static_cast<int>(channels.size()), channels, {0});
    image.height = 16;
    image.data.resize(image.index(0, 16, 0));
    std::vector<png_byte> expected;
    for (std::size_t i = 0; i < image.data.size(); ++i) {
      expected.push_back(static_cast<png_byte>(i * 7 % 256));
      image.data[i] = static_cast<float>(linear_from_srgb(expected.back() / 255.0));
    }
    const WriteReport report = write_image(image, folder / "a.png");
    CHECK(report.clipped == 0);
    CHECK(report.invalid == 0);
    CHECK(codes(folder / "a.png", channels.size() == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB) == expected);
    const Image back = read_image(folder / "a.png");
    CHECK(back.channels == channels);
    CHECK(back.data == image.data);
  }
}

TEST_CASE("16 bits keep every value within half a code") {
  const TemporaryFolder folder;
  Image image = picture(64, 64, rgb, {0});
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(image.data.size() - 1);
    image.data[i] = static_cast<float>(t * t);
  }
  write_image(image, folder / "a.png", {16, 0});
  const Image back = read_image(folder / "a.png");
  double largest = 0;
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    largest = std::max(largest, std::fabs(srgb_from_linear(static_cast<double>(back.data[i])) -
                                          srgb_from_linear(static_cast<double>(image.data[i]))));
  }
  CHECK(largest * 65535 < 0.5 + 1e-2);  // 1e-2: the float that a code is decoded to.
  CHECK(largest * 65535 > 0.4);
}

TEST_CASE("exposure in stops, clipping and invalid values are counted") {
  const TemporaryFolder folder;
  const float inf = std::numeric_limits<float>::infinity();
  const Image image = picture(4, 1, rgb, {0.25F, 0.5F, 1, 1.5F, -0.1F, 0, inf, -inf, std::nanf(""), 0.75F, 1e-3F, 2});
  WriteReport report = write_image(image, folder / "a.png");
  CHECK(report.clipped == 3);
  CHECK(report.invalid == 3);
  const auto code = [](double linear) { return static_cast<png_byte>(srgb_from_linear(linear) * 255 + 0.5); };
  CHECK(codes(folder / "a.png", PNG_FORMAT_RGB) ==
        std::vector<png_byte>{code(0.25), code(0.5), 255, 255, 0, 0, 255, 0, 0, code(0.75), code(1e-3), 255});
  report = write_image(image, folder / "a.png", {8, -1});
  CHECK(report.clipped == 1);
  CHECK(codes(folder / "a.png", PNG_FORMAT_RGB)[0] == code(0.125));
  report = write_image(image, folder / "a.png", {8, 1.5});
  CHECK(report.clipped == 6);
  CHECK(codes(folder / "a.png", PNG_FORMAT_RGB)[0] == code(0.25 * std::sqrt(8)));
  report = write_image(image, folder / "a.png", {8, 5000});
  CHECK(report.clipped == 8);
}

TEST_CASE("options that no PNG can have") {
  const TemporaryFolder folder;
  const Image image = picture(1, 1, rgb, {0});
  CHECK_THROWS_AS(write_image(image, folder / "a.png", {12, 0}), UsageError);
  CHECK_THROWS_AS(write_image(image, folder / "a.png", {8, std::nan("")}), UsageError);
  CHECK(folder.names().empty());
}

TEST_CASE("metadata survives, ASCII and UTF-8") {
  const TemporaryFolder folder;
  Image image = picture(1, 1, rgb, {0});
  image.metadata = {{"command line", "strahl render scene.xml -o \"a b.png\""},
                    {"device", "π-Gerät für 光線"},
                    {"empty", ""},
                    {"long", std::string(100000, 'x')},
                    {"lines", "one\ntwo"}};
  write_image(image, folder / "a.png");
  CHECK(read_image(folder / "a.png").metadata == image.metadata);
  const std::string bytes = bytes_of(folder / "a.png");
  CHECK(bytes.find("tEXtcommand line") != std::string::npos);
  CHECK(bytes.find("iTXtdevice") != std::string::npos);
  CHECK(bytes.find("sRGB") != std::string::npos);
  CHECK(bytes.find("gAMA") != std::string::npos);
  const std::vector<std::string> bad_keys{"", " x", "x ", "a  b", "ümlaut", std::string(80, 'k')};
  for (const std::string& key : bad_keys) {
    INFO(key);
    image.metadata = {{key, "value"}};
    CHECK_THROWS_WITH(write_image(image, folder / "bad.png"), Contains("1 to 79 printable"));
  }
  CHECK(folder.names() == std::set<std::string>{"a.png"});
}

TEST_CASE("colour types that strahl does not write") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.png";
  const auto linear = [](double encoded) { return static_cast<float>(linear_from_srgb(encoded)); };
  SECTION("RGBA: alpha is linear") {
    put_png(path, {1, 1, 8, PNG_COLOR_TYPE_RGBA, {{255, 128, 0, 128}}});
    const Image image = read_image(path);
    CHECK(image.channels == std::vector<std::string>{"R", "G", "B", "A"});
    CHECK(image.data == std::vector<float>{1, linear(128 / 255.0), 0, 128 / 255.0F});
  }
  SECTION("grey with alpha, 16 bits") {
    put_png(path, {1, 1, 16, PNG_COLOR_TYPE_GRAY_ALPHA, {{0x12, 0x34, 0x80, 0x00}}});
    const Image image = read_image(path);
    CHECK(image.channels == std::vector<std::string>{"Y", "A"});
    CHECK(image.data == std::vector<float>{linear(0x1234 / 65535.0), 0x8000 / 65535.0F});
  }
  SECTION("2-bit grey") {
    put_png(path, {4, 1, 2, PNG_COLOR_TYPE_GRAY, {{0b00011011}}});
    CHECK(read_image(path).data == std::vector<float>{0, linear(85 / 255.0), linear(170 / 255.0), 1});
  }
  SECTION("palette") {
    put_png(path, {2, 1, 8, PNG_COLOR_TYPE_PALETTE, {{1, 0}}, 0, 0, {{255, 0, 0}, {0, 85, 255}}});
    CHECK(read_image(path).channels == rgb);
    CHECK(read_image(path).data == std::vector<float>{0, linear(85 / 255.0), 1, 1, 0, 0});
  }
  SECTION("palette with transparency") {
    put_png(path, {2, 1, 8, PNG_COLOR_TYPE_PALETTE, {{1, 0}}, 0, 0, {{255, 0, 0}, {0, 0, 255}}, {0, 51}});
    CHECK(read_image(path).data == std::vector<float>{0, 0, 1, 0.2F, 1, 0, 0, 0});
  }
  SECTION("interlaced") {
    std::vector<std::vector<png_byte>> rows(9, std::vector<png_byte>(11));
    for (std::size_t y = 0; y < 9; ++y) {
      for (std::size_t x = 0; x < 11; ++x) rows[y][x] = static_cast<png_byte>(y * 11 + x);
    }
    put_png(path, {11, 9, 8, PNG_COLOR_TYPE_GRAY, rows, PNG_INTERLACE_ADAM7});
    const Image image = read_image(path);
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 11; ++x) CHECK(image.at(x, y, 0) == linear((y * 11 + x) / 255.0));
    }
  }
  SECTION("a gamma other than sRGB's") {
    put_png(path, {1, 1, 8, PNG_COLOR_TYPE_GRAY, {{51}}, 0, 1.0});
    CHECK(read_image(path).data == std::vector<float>{0.2F});
    put_png(path, {1, 1, 8, PNG_COLOR_TYPE_GRAY, {{51}}, 0, 0.45455});
    CHECK(read_image(path).data == std::vector<float>{linear(0.2)});
  }
  SECTION("Latin-1 text becomes UTF-8") {
    put_png(path, {1, 1, 8, PNG_COLOR_TYPE_GRAY, {{51}}, 0, 0, {}, {}, "K\xe4se"});
    CHECK(read_image(path).metadata.at("Comment") == "Käse");
  }
}

TEST_CASE("pictures of more than a million pixels along a side") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.png";
  for (const auto& [width, height] : {std::pair(1000001, 1), {1, 1000001}}) {
    const Image image = picture(width, height, {"Y"}, {0, 1});
    write_image(image, path);
    CHECK(read_image(path).data == image.data);
  }
  // Colours of a palette with its own alpha are four channels, as grey with one that is transparent is two.
  put_png(path, {1, 1, 8, PNG_COLOR_TYPE_PALETTE, {{0}}, 0, 0, {{255, 0, 0}}, {128}});
  CHECK(read_image(path).channels.size() == 4);
}

TEST_CASE("damaged PNG files") {
  const TemporaryFolder folder;
  const auto read = [](const std::string& name) { return read_image(name); };
  Image image = picture(31, 17, rgb, {0.1F, 0.5F, 0.9F, 0.3F});
  image.metadata = {{"device", "a device"}, {"scene", "Szene für alle"}};
  write_image(image, folder / "good.png", {16, 0});
  const std::string good = bytes_of(folder / "good.png");
  check_truncations(good, folder / "a.png", read);
  CHECK(check_mutations(good, folder / "a.png", 600, read) > 300);
  put_bytes(folder / "a.png", "GIF89a");
  CHECK_THROWS_WITH(read_image(folder / "a.png"), Contains("not a PNG file"));
  put_bytes(folder / "a.png", good.substr(0, good.size() / 2));
  CHECK_THROWS_WITH(read_image(folder / "a.png"), Contains("damaged PNG file: the file ends too early"));
}

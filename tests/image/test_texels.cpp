// SPDX-License-Identifier: MIT
// Images as textures: the codes of every kind of file, what they mean, how they lie in words; files that are damaged,
// too large, or of another kind.
#include <turbojpeg.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "errors.h"
#include "image/image_io.h"
#include "image/temporary_folder.h"
#include "image/texels.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

std::string le16(int x) { return {static_cast<char>(x & 255), static_cast<char>(x >> 8 & 255)}; }
std::string le32(int x) { return le16(x & 65535) + le16(x >> 16); }
std::string be32(int x) {
  const std::string le = le32(x);
  return {le.rbegin(), le.rend()};
}

/// 2 x 2: red, green; blue, grey 128. Rows of a BMP go upwards and end at multiples of four bytes.
std::string bmp_file() {
  const std::string rows = std::string("\xff\x00\x00\x80\x80\x80\x00\x00\x00\x00\xff\x00\xff\x00\x00\x00", 16);
  return "BM" + le32(54 + 16) + le32(0) + le32(54) + le32(40) + le32(2) + le32(2) + le16(1) + le16(24) + le32(0) +
         le32(16) + le32(0) + le32(0) + le32(0) + le32(0) + rows;
}
/// The same, from the top.
std::string tga_file() {
  return std::string("\0\0\x02\0\0\0\0\0\0\0\0\0", 12) + le16(2) + le16(2) + std::string("\x18\x20", 2) +
         std::string("\x00\x00\xff\x00\xff\x00\xff\x00\x00\x80\x80\x80", 12);
}
/// 2 x 1: (1, 0.5, 0.25), and a bright one.
std::string hdr_file() {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + std::string("\x80\x40\x20\x81\xff\x01\x00\x90", 8);
}
/// 8 x 2 with runs: each row is a grey ramp of literals in red, runs in green and blue, exponent 129.
std::string packed_hdr_file() {
  std::string row = std::string("\x02\x02\x00\x08", 4) + std::string("\x08\x10\x20\x30\x40\x50\x60\x70\x80", 9);
  for (int run = 0; run < 2; ++run) row += std::string("\x88\x40", 2);
  row += std::string("\x88\x81", 2);
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n" + row + row;
}
/// 2 x 2 of grey 9 in runs.
std::string packed_tga_file() {
  return std::string("\0\0\x0b\0\0\0\0\0\0\0\0\0", 12) + le16(2) + le16(2) + std::string("\x08\x20", 2) +
         std::string("\x83\x09", 2);
}
std::string jpeg_file(const std::vector<unsigned char>& grey, int width, int height) {
  tjhandle jpeg = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  REQUIRE(tjCompress2(jpeg, grey.data(), width, 0, height, TJPF_GRAY, &bytes, &size, TJSAMP_GRAY, 100, 0) == 0);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(jpeg);
  return file;
}

using Value = std::array<double, 3>;

Value value(const Texels& texels, std::size_t n, TexelCurve::Kind kind = TexelCurve::Kind::linear) {
  return TexelDecoder(texels, {kind, 2})(n);
}

void require_colours(const Texels& texels) {
  REQUIRE(texels.width == 2);
  REQUIRE(texels.height == 2);
  CHECK(texels.format == TexelFormat::bits_8);
  CHECK(value(texels, 0) == Value{1, 0, 0});
  CHECK(value(texels, 1) == Value{0, 1, 0});
  CHECK(value(texels, 2) == Value{0, 0, 1});
  CHECK(value(texels, 3)[1] == 128.0 / 255);
  CHECK(texels.words == std::vector<std::int32_t>{0xff, 0xff00, 0xff0000, 0x808080});
}

struct Read {
  TemporaryFolder folder;
  Texels operator()(const std::string& name, const std::string& bytes) const {
    put_bytes(folder / name, bytes);
    return read_texels(folder / name);
  }
};

TEST_CASE("BMP, TGA and PNG keep their codes, whatever they are called") {
  const Read read;
  require_colours(read("a.bmp", bmp_file()));
  require_colours(read("b.tga", tga_file()));
  require_colours(read("named.png", bmp_file()));
  Image image{
      2, 2, {"R", "G", "B", "A"}, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 0.5F, 0.2158605F, 0.2158605F, 0.2158605F, 0}, {}};
  write_image(image, read.folder / "c.png");
  require_colours(read_texels(read.folder / "c.png"));
}

TEST_CASE("PNG of 16 bits keeps them, and grey is one code a texel") {
  const Read read;
  Image image{3, 1, {"Y"}, {0, 0.2F, 1}, {}};
  write_image(image, read.folder / "wide.png", PngOptions{.bits = 16});
  const Texels wide = read_texels(read.folder / "wide.png");
  CHECK(wide.format == TexelFormat::bits_16);
  CHECK(wide.is_grey);
  CHECK(wide.words.size() == 2);
  CHECK(value(wide, 1, TexelCurve::Kind::srgb)[2] == Approx(0.2).epsilon(1e-4));
  write_image(image, read.folder / "narrow.png");
  const Texels narrow = read_texels(read.folder / "narrow.png");
  CHECK(narrow.words.size() == 1);
  CHECK(value(narrow, 2) == Value{1, 1, 1});
}

TEST_CASE("JPEG is read as it was written, but for its quantisation") {
  const Read read;
  std::vector<unsigned char> grey;
  for (int i = 0; i < 19 * 17; ++i) grey.push_back(static_cast<unsigned char>(i % 19 * 12));
  const Texels texels = read("a.jpg", jpeg_file(grey, 19, 17));
  REQUIRE(texels.width == 19);
  REQUIRE(texels.height == 17);
  REQUIRE(texels.is_grey);
  for (std::size_t n = 0; n < grey.size(); ++n) CHECK(255 * value(texels, n)[0] == Approx(grey[n]).margin(3));
}

TEST_CASE("Radiance HDR keeps mantissas and exponent") {
  const Texels texels = Read()("a.hdr", hdr_file());
  CHECK(texels.format == TexelFormat::rgbe);
  CHECK(static_cast<std::uint32_t>(texels.words.at(0)) == 0x81204080U);
  CHECK(value(texels, 0) == Value{1, 0.5, 0.25});
  CHECK(value(texels, 1) == Value{65280, 256, 0});
  CHECK(value(texels, 0, TexelCurve::Kind::srgb) == Value{1, 0.5, 0.25});
}

TEST_CASE("floats are halves where halves hold them") {
  const Read read;
  Image image{2, 1, {"R", "G", "B"}, {0.5F, 1024, 0, 0.25F, 3, 65504}, {}};
  write_image(image, read.folder / "half.exr");
  CHECK(read_texels(read.folder / "half.exr").format == TexelFormat::half);
  CHECK(value(read_texels(read.folder / "half.exr"), 1) == Value{0.25, 3, 65504});
  image.data[1] = 0.1F;
  write_image(image, read.folder / "real.pfm");
  const Texels real = read_texels(read.folder / "real.pfm");
  CHECK(real.format == TexelFormat::real);
  CHECK(value(real, 0)[1] == static_cast<double>(0.1F));
  image.data = {-1, 2, 3, std::numeric_limits<float>::quiet_NaN(), 1, std::numeric_limits<float>::infinity()};
  write_image(image, read.folder / "faulty.exr");
  const Texels faulty = read_texels(read.folder / "faulty.exr");
  CHECK(faulty.repaired == 2);
  CHECK(value(faulty, 0) == Value{0, 2, 3});
  CHECK(value(faulty, 1) == Value{0, 1, 3});
}

TEST_CASE("heights may be of any sign") {
  const Read read;
  Image image{2, 2, {"Y"}, {-0.5F, 0.25F, std::numeric_limits<float>::quiet_NaN(), 1.5F}, {}};
  write_image(image, read.folder / "heights.exr");
  const Texels heights = read_texels(read.folder / "heights.exr", TexelUse::heights);
  CHECK(heights.repaired == 1);
  CHECK(value(heights, 0)[0] == -0.5);
  CHECK(value(heights, 1)[0] == 0.25);
  CHECK(value(heights, 2)[0] == 0);
  CHECK(value(heights, 3)[0] == 1.5);
  CHECK(heights.format == TexelFormat::real);  // Halves are read without their sign.
  image.data = {0.5F, 0.25F, 3, 4};
  write_image(image, read.folder / "heights.exr");
  CHECK(value(read_texels(read.folder / "heights.exr", TexelUse::heights), 1)[0] == 0.25);
}

TEST_CASE("curves: linear, sRGB, a power") {
  for (const TexelFormat format : {TexelFormat::bits_8, TexelFormat::bits_16}) {
    const auto at = [&](TexelCurve::Kind kind, double share) {
      const std::vector<double> table = decoding_table(format, {kind, 2});
      return table[static_cast<std::size_t>(std::lround(share * static_cast<double>(table.size() - 1)))];
    };
    CHECK(at(TexelCurve::Kind::linear, 0.2) == Approx(0.2));
    CHECK(at(TexelCurve::Kind::srgb, 0.2) == Approx(0.0331048));
    CHECK(at(TexelCurve::Kind::power, 0.2) == Approx(0.04));
    for (const auto kind : {TexelCurve::Kind::linear, TexelCurve::Kind::srgb, TexelCurve::Kind::power}) {
      CHECK(at(kind, 0) == 0);
      CHECK(at(kind, 1) == 1);
    }
  }
}

TEST_CASE("what is brighter than 1 is cut, and counted") {
  const Clamped clamped = clamped_to_one(texels_of_floats(2, 1, 1, {0.5F, 1.5F}));
  CHECK(clamped.changed == 1);
  CHECK(value(clamped.texels, 0)[0] == 0.5);
  CHECK(value(clamped.texels, 1)[0] == 1);
  CHECK(clamped_to_one(Read()("a.hdr", hdr_file())).changed == 1);
}

TEST_CASE("images of too many texels are refused before they are unpacked") {
  const Read read;
  // A PNG whose header says 10^5 x 10^5, of 45 bytes. The length of IHDR, its CRC, and an IDAT of nothing.
  const std::string png = std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16) + be32(100000) + be32(100000) +
                          std::string("\x08\x02\0\0\0\x27\x30\x9c\x9f", 9) +
                          std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12);
  CHECK_THROWS_WITH(read("bomb.png", png), Contains("100000 x 100000 texels"));
  const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n";
  CHECK_THROWS_WITH(read("bomb.hdr", hdr), Contains("100000 x 100000 texels"));
  std::string tga = tga_file();
  tga.replace(12, 4, std::string("\xff\xff\xff\xff", 4));
  CHECK_THROWS_WITH(read("bomb.tga", tga), Contains("65535 x 65535 texels"));
  tga.replace(12, 4, std::string("\xff\x3f\xff\x3f", 4));
  CHECK_THROWS_WITH(read("bomb.tga", tga), Contains("too few for its 16383 x 16383 texels"));
  std::string bmp = bmp_file();
  bmp.replace(18, 8, std::string("\xff\x3f\0\0\xff\x3f\0\0", 8));
  CHECK_THROWS_WITH(read("bomb.bmp", bmp), Contains("too few for its 16383 x 16383 texels"));
  std::string jpeg = jpeg_file(std::vector<unsigned char>(64, 7), 8, 8);
  const std::size_t frame = jpeg.find("\xff\xc0");
  REQUIRE(frame != std::string::npos);
  jpeg.replace(frame + 5, 4, std::string("\xff\xdc\xff\xdc", 4));
  CHECK_THROWS_WITH(read("bomb.jpg", jpeg), Contains("65500 x 65500 texels"));
}

TEST_CASE("images with a side that kernels cannot tell the places of are refused") {
  constexpr int longest = 1 << 24;
  CHECK_NOTHROW(check_texel_count("a.pfm", longest, 1));
  CHECK_NOTHROW(check_texel_count("a.pfm", 1, longest));
  for (const auto& [width, height] : {std::pair(longest + 1, 1), {1, longest + 1}})
    CHECK_THROWS_WITH(check_texel_count("a.pfm", width, height), Contains("a side of an image has at most 16777216"));
  // Of a PNG libpng's own limit is a million: it must not speak first.
  const std::string png = std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16) + be32(longest + 1) + be32(1) +
                          std::string("\x08\x02\0\0\0\x4d\xe1\x8a\x5b", 9) +
                          std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12);
  CHECK_THROWS_WITH(Read()("wide.png", png), Contains("a side of an image has at most 16777216"));
}

TEST_CASE("a file of another kind says which are read") {
  CHECK_THROWS_WITH(Read()("a.png", "GIF89a and more, a good deal more than a header of a TGA"),
                    Contains("PNG, JPEG, OpenEXR, Radiance HDR, TGA, BMP and PFM"));
}

TEST_CASE("damaged files are read or refused") {
  const Read read;
  write_image(Image{8, 8, {"R", "G", "B"}, std::vector<float>(192, 0.5F), {}}, read.folder / "a.png");
  std::vector<unsigned char> grey(64, 90);
  const std::vector<std::string> files = {bmp_file(),
                                          tga_file(),
                                          hdr_file(),
                                          packed_hdr_file(),
                                          packed_tga_file(),
                                          jpeg_file(grey, 8, 8),
                                          bytes_of(read.folder / "a.png")};
  std::mt19937 engine(9);
  int refused = 0;
  for (const std::string& whole : files)
    for (int i = 0; i < 200; ++i) {
      std::string file = whole;
      if (i % 2 == 0) file.resize(engine() % file.size());
      for (unsigned changes = engine() % 4; changes > 0 && !file.empty(); --changes)
        file[engine() % file.size()] = static_cast<char>(engine());
      try {
        const Texels texels = read("damaged", file);
        CHECK(texels.count() > 0);
      } catch (const InputError& fault) {
        CHECK_THAT(fault.what(), Contains("damaged"));
        ++refused;
      }
    }
  CHECK(refused > 300);
}

TEST_CASE("a file that was cut off is refused wherever it was cut") {
  const Read read;
  write_image(Image{8, 8, {"R", "G", "B"}, std::vector<float>(192, 0.5F), {}}, read.folder / "a.png");
  write_image(Image{8, 8, {"R", "G", "B"}, std::vector<float>(192, 0.5F), {}}, read.folder / "a.exr");
  const std::string bmp = bmp_file();
  const std::size_t padding = 2;  // Behind the last row, which some programs leave out.
  for (const std::string& whole : {bmp.substr(0, bmp.size() - padding), tga_file(), packed_tga_file(), hdr_file(),
                                   packed_hdr_file(), jpeg_file(std::vector<unsigned char>(64, 90), 8, 8),
                                   bytes_of(read.folder / "a.png"), bytes_of(read.folder / "a.exr")}) {
    CHECK(read("whole", whole).count() > 0);
    for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
      CAPTURE(bytes, whole.size(), whole.substr(0, 4));
      CHECK_THROWS_AS(read("cut", whole.substr(0, bytes)), InputError);
    }
  }
}

TEST_CASE("a wide TGA that was cut off within a row is refused") {
  const int size = 128;
  const std::string whole = std::string("\0\0\x03\0\0\0\0\0\0\0\0\0", 12) + le16(size) + le16(size) +
                            std::string("\x08\x20", 2) + std::string(size * size, '\x07');
  CHECK(value(Read()("a.tga", whole), 5)[0] == Approx(7 / 255.0));
  for (const std::size_t missing : {1U, 127U, 128U, 129U, 5000U})
    CHECK_THROWS_WITH(Read()("a.tga", whole.substr(0, whole.size() - missing)), Contains("is it cut off?"));
}

TEST_CASE("a TGA may have its columns from the right, and no palette that begins behind colour 0") {
  const Read read;
  // Green, red; grey 128, blue, told as from the right and from the top.
  const std::string colours = std::string("\0\0\x02\0\0\0\0\0\0\0\0\0", 12) + le16(2) + le16(2) +
                              std::string("\x18\x30", 2) +
                              std::string("\x00\xff\x00\x00\x00\xff\x80\x80\x80\xff\x00\x00", 12);
  require_colours(read("a.tga", colours));
  // Three texels, of runs.
  const std::string row = std::string("\0\0\x0b\0\0\0\0\0\0\0\0\0", 12) + le16(3) + le16(1) +
                          std::string("\x08\x30", 2) + std::string("\x02\x07\x08\x09", 4);
  const Texels grey = read("b.tga", row);
  for (std::size_t n = 0; n < 3; ++n) CHECK(value(grey, n)[0] == (9.0 - static_cast<double>(n)) / 255);

  const auto palette = [](const std::string& first) {  // Of two colours: 2 x 1, both.
    return std::string("\0\x01\x01", 3) + first + std::string("\x02\0\x18\0\0\0\0", 7) + le16(2) + le16(1) +
           std::string("\x08\x20", 2) + std::string("\x00\x00\xff\x00\xff\x00", 6) + first.substr(0, 1) +
           static_cast<char>(first[0] + 1);
  };
  const Texels from_0 = read("c.tga", palette(le16(0)));
  CHECK(value(from_0, 0) == Value{1, 0, 0});
  CHECK(value(from_0, 1) == Value{0, 1, 0});
  CHECK_THROWS_WITH(read("d.tga", palette(le16(4))), Contains("whose palette begins with colour 4; save it"));
  CHECK_THROWS_WITH(read("d.tga", palette(le16(256))), Contains("begins with colour 256"));
}

TEST_CASE("runs of Radiance HDR") {
  const Texels texels = Read()("a.hdr", packed_hdr_file());
  REQUIRE(texels.width == 8);
  REQUIRE(texels.height == 2);
  for (std::size_t n = 0; n < texels.count(); ++n) {
    CHECK(value(texels, n)[0] == 2.0 * static_cast<double>(16 * (n % 8 + 1)) / 256);
    CHECK(value(texels, n)[1] == 2.0 * 64 / 256);
  }
}

TEST_CASE("a BMP with its rows from the top") {
  std::string bmp = bmp_file();
  bmp.replace(22, 4, le32(-2));
  const Texels texels = Read()("a.bmp", bmp);
  REQUIRE(texels.height == 2);
  // What is the lower row of the other.
  CHECK(value(texels, 0) == Value{0, 0, 1});
  CHECK(value(texels, 2) == Value{1, 0, 0});
  bmp.replace(30, 4, le32(1));
  CHECK_THROWS_WITH(Read()("a.bmp", bmp), Contains("save it without compression"));
}

TEST_CASE("a JPEG with bytes before its end") {
  std::string jpeg = jpeg_file(std::vector<unsigned char>(64, 90), 8, 8);
  jpeg.insert(jpeg.size() - 2, 40, '\x11');
  const Texels texels = Read()("a.jpg", jpeg);
  CHECK(texels.count() == 64);
  CHECK_THAT(texels.doubt, Contains("extraneous bytes"));
}

TEST_CASE("half the size has the same mean, whatever the size") {
  for (const auto& [width, height] : {std::pair{4, 2}, std::pair{5, 3}, std::pair{1, 7}, std::pair{3, 1}}) {
    std::vector<float> values;
    for (int i = 0; i < width * height; ++i) values.push_back(static_cast<float>(i % 5) / 8);
    const Texels whole = texels_of_floats(width, height, 1, values), half_size = reduced(whole, {});
    CHECK(half_size.width == std::max(width / 2, 1));
    CHECK(half_size.height == std::max(height / 2, 1));
    double before = 0, after = 0;
    for (std::size_t n = 0; n < whole.count(); ++n) before += value(whole, n)[0] / static_cast<double>(whole.count());
    for (std::size_t n = 0; n < half_size.count(); ++n)
      after += value(half_size, n)[0] / static_cast<double>(half_size.count());
    CHECK(after == Approx(before).epsilon(1e-3));
  }
}

}  // namespace

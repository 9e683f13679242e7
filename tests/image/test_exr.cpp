// SPDX-License-Identifier: MIT
// OpenEXR files: bit-exact round trips, metadata, and files of other kinds written by OpenEXR itself.
#include <ImfBoxAttribute.h>
#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfPreviewImage.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <ImfVecAttribute.h>
#include <half.h>

#include <catch2/catch.hpp>

#include "errors.h"
#include "image/damaged_files.h"
#include "image/image_io.h"
#include "image/pictures.h"
#include "image/temporary_folder.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

/// One channel of any type with data window `data` in display window `display`.
template <class T>
void put_exr(const std::string& path, Imf::PixelType type, const Imath::Box2i& display, const Imath::Box2i& data,
             std::vector<T> values, Imf::Compression compression = Imf::PIZ_COMPRESSION) {
  Imf::Header header(display, data);
  header.compression() = compression;
  header.channels().insert("Y", Imf::Channel(type));
  header.insert("owner", Imf::StringAttribute("somebody"));
  const auto width = static_cast<std::size_t>(data.max.x - data.min.x + 1);
  Imf::FrameBuffer pixels;
  pixels.insert("Y", Imf::Slice::Make(type, values.data(), data, sizeof(T), sizeof(T) * width));
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(pixels);
  file.writePixels(data.max.y - data.min.y + 1);
}

Imath::Box2i box(int left, int top, int right, int bottom) { return {{left, top}, {right, bottom}}; }

}  // namespace

TEST_CASE("names of channels that a file would cut are refused") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  const auto of = [](std::size_t size) {
    const std::string layer(size - 2, 'x');
    return picture(2, 2, {layer + ".X", layer + ".Y", layer + ".Z"}, {1, 2, 3});
  };
  for (const std::size_t size : {256, 302}) {
    CHECK_THROWS_AS(write_image(of(size), path), Error);
    CHECK_THROWS_WITH(write_image(of(size), path),
                      Contains(std::to_string(size) + " bytes, and an EXR file holds 255"));
  }
  CHECK(folder.names().empty());
  write_image(of(255), path);
  CHECK(read_image(path).channels == of(255).channels);
}

TEST_CASE("values survive bit by bit, whatever the channels") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  for (const std::vector<std::string>& channels :
       {rgb,
        {"Y"},
        {"R", "G", "B", "A"},
        {"R", "G", "B", "depth.Z", "normal.X", "normal.Y", "normal.Z", "uv.U", "uv.V"}}) {
    const Image image = picture(37, 19, channels, awkward_values());
    const WriteReport report = write_image(image, path);
    CHECK(report.clipped == 0);
    CHECK(report.invalid > 0);
    const Image back = read_image(path);
    CHECK(back.width == 37);
    CHECK(back.height == 19);
    CHECK(back.channels == channels);
    CHECK(bits(back.data) == bits(image.data));
  }
}

TEST_CASE("the file is 32-bit float and ZIP, with the names as given") {
  const TemporaryFolder folder;
  write_image(picture(3, 2, {"R", "G", "B", "a layer of a long name, longer than 31.X"}, {1}), folder / "a.exr");
  const Imf::InputFile file((folder / "a.exr").c_str());
  CHECK(file.header().compression() == Imf::ZIP_COMPRESSION);
  CHECK(file.header().dataWindow() == box(0, 0, 2, 1));
  for (const char* name : {"R", "G", "B", "a layer of a long name, longer than 31.X"}) {
    const Imf::Channel* channel = file.header().channels().findChannel(name);
    REQUIRE(channel);
    CHECK(channel->type == Imf::FLOAT);
  }
}

TEST_CASE("channels in any order land under their names") {
  const TemporaryFolder folder;
  write_image(picture(1, 1, {"B", "A", "z.Q", "R", "G", "C"}, {3, 4, 9, 1, 2, 5}), folder / "a.exr");
  const Image back = read_image(folder / "a.exr");
  CHECK(back.channels == std::vector<std::string>{"R", "G", "B", "C", "A", "z.Q"});
  CHECK(back.data == std::vector<float>{1, 2, 3, 5, 4, 9});
}

TEST_CASE("metadata survives, names with a meaning in OpenEXR included") {
  const TemporaryFolder folder;
  Image image = picture(1, 1, rgb, {0});
  image.metadata = {{"version", "0.1"},      {"type", "t"}, {"channels", "3"},
                    {"compression", "none"}, {"name", "n"}, {"command line", "strahl render"},
                    {"device", "π-Gerät"},   {"empty", ""}, {"chunkCount", "1"}};
  write_image(image, folder / "a.exr");
  CHECK(read_image(folder / "a.exr").metadata == image.metadata);
  const Imf::InputFile file((folder / "a.exr").c_str());
  CHECK(file.header().typedAttribute<Imf::StringAttribute>("strahl:device").value() == "π-Gerät");
}

TEST_CASE("half and unsigned channels, and every lossless compression") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  const Imath::Box2i window = box(0, 0, 1, 1);
  for (const Imf::Compression compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                             Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
    put_exr<half>(path, Imf::HALF, window, window, {half(0.5F), half(-65504.F), half(6e-8F), half::posInf()},
                  compression);
    const Image image = read_image(path);
    CHECK(image.data == std::vector<float>{0.5F, -65504, 5.9604645e-8F, std::numeric_limits<float>::infinity()});
    CHECK(image.channels == std::vector<std::string>{"Y"});
    CHECK(image.metadata.at("owner") == "somebody");
    put_exr<unsigned>(path, Imf::UINT, window, window, {0, 7, 16777216, 4000000000U}, compression);
    CHECK(read_image(path).data == std::vector<float>{0, 7, 16777216, 4e9F});
  }
}

TEST_CASE("the display window is the picture, 0 where there are no data") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  const std::vector<float> four{1, 2, 3, 4};
  put_exr<float>(path, Imf::FLOAT, box(0, 0, 2, 2), box(1, 0, 2, 1), four);
  CHECK(read_image(path).data == std::vector<float>{0, 1, 2, 0, 3, 4, 0, 0, 0});
  put_exr<float>(path, Imf::FLOAT, box(10, 10, 12, 11), box(9, 9, 10, 10), four);
  CHECK(read_image(path).data == std::vector<float>{4, 0, 0, 0, 0, 0});
  put_exr<float>(path, Imf::FLOAT, box(-1, -1, -1, -1), box(-2, -2, -1, -1), four);
  CHECK(read_image(path).data == std::vector<float>{4});
  put_exr<float>(path, Imf::FLOAT, box(0, 0, 1, 0), box(5, 5, 6, 6), four);
  CHECK(read_image(path).data == std::vector<float>{0, 0});
}

TEST_CASE("a display window that the file's bytes do not account for") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  std::vector<float> values(64 * 64);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i * i);
  put_exr<float>(path, Imf::FLOAT, box(0, 0, 3999, 3999), box(8, 8, 71, 71), values);
  CHECK(read_image(path).width == 4000);  // Part of a picture.
  put_exr<float>(path, Imf::FLOAT, box(0, 0, 0, (1 << 25) - 1), box(0, 0, 63, 63), values);
  CHECK_THROWS_WITH(read_image(path), Contains("1 x 33554432 pixels with 1 channels in"));
  const std::vector<float> black(std::size_t{1} << 23);
  put_exr<float>(path, Imf::FLOAT, box(0, 0, 4095, 4095), box(0, 0, 4095, 2047), black, Imf::DWAB_COMPRESSION);
  CHECK(bytes_of(path).size() < 20000);
  CHECK(read_image(path).height == 4096);
}

TEST_CASE("rows in blocks and tiles of any height") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  const int height = GENERATE(5, 256, 700), tile = GENERATE(4, 200);
  std::vector<float> values(7 * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  {
    Imf::Header header(7, height);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(4, static_cast<unsigned>(tile)));
    Imf::TiledOutputFile file(path.c_str(), header);
    Imf::FrameBuffer pixels;
    pixels.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 28));
    file.setFrameBuffer(pixels);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  CHECK(read_image(path).data == values);
  const Imath::Box2i window = box(0, -3, 6, height - 4);
  put_exr<float>(path, Imf::FLOAT, window, window, values, Imf::DWAB_COMPRESSION);
  CHECK(read_image(path).height == height);
  put_exr<float>(path, Imf::FLOAT, window, window, values, Imf::ZIP_COMPRESSION);
  CHECK(read_image(path).data == values);
}

TEST_CASE("kinds that are not read say so") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  Imf::Header header(2, 2);
  SECTION("several parts") {
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setType(Imf::SCANLINEIMAGE);
    std::vector<Imf::Header> headers{header, header};
    headers[0].setName("left");
    headers[1].setName("right");
    { const Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2); }
    CHECK_THROWS_WITH(read_image(path), Contains("2 parts"));
  }
  SECTION("deep") {
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    { const Imf::DeepScanLineOutputFile file(path.c_str(), header); }
    CHECK_THROWS_WITH(read_image(path), Contains("deep"));
  }
  SECTION("subsampled") {
    header.channels().insert("BY", Imf::Channel(Imf::FLOAT, 2, 2));
    { const Imf::OutputFile file(path.c_str(), header); }
    CHECK_THROWS_WITH(read_image(path), Contains("\"BY\" is subsampled"));
  }
  SECTION("left by a writer that stopped") {
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    { const Imf::OutputFile file(path.c_str(), header); }
    CHECK_THROWS_WITH(read_image(path), Contains("incomplete OpenEXR file"));
  }
  CHECK_THROWS_AS(read_image(path), InputError);
}

TEST_CASE("attributes of many types are none of its business") {
  const TemporaryFolder folder;
  Imf::Header header(2, 2);
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  header.setPreviewImage(Imf::PreviewImage(3, 2));
  Imf::addChromaticities(header, Imf::Chromaticities());
  Imf::addKeyCode(header, Imf::KeyCode());
  Imf::addTimeCode(header, Imf::TimeCode());
  Imf::addFramesPerSecond(header, Imf::Rational(24, 1));
  Imf::addEnvmap(header, Imf::ENVMAP_LATLONG);
  Imf::addWorldToCamera(header, Imath::M44f());
  Imf::addMultiView(header, {"left", "", "right"});
  header.insert("v2d", Imf::V2dAttribute({1, 2}));
  header.insert("v3i", Imf::V3iAttribute({1, 2, 3}));
  header.insert("box", Imf::Box2fAttribute());
  header.insert("matrix", Imf::M33dAttribute());
  header.insert("numbers", Imf::FloatVectorAttribute({1, 2, 3}));
  {
    std::vector<float> values{1, 2, 3, 4};
    Imf::FrameBuffer pixels;
    pixels.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow(), 4, 8));
    Imf::OutputFile file((folder / "a.exr").c_str(), header);
    file.setFrameBuffer(pixels);
    file.writePixels(2);
  }
  CHECK(read_image(folder / "a.exr").data == std::vector<float>{1, 2, 3, 4});
}

TEST_CASE("damaged EXR files") {
  const TemporaryFolder folder;
  const auto read = [](const std::string& name) { return read_image(name); };
  Image image = picture(31, 40, rgb, awkward_values());
  image.metadata = {{"device", "a device"}};
  write_image(image, folder / "good.exr");
  check_truncations(bytes_of(folder / "good.exr"), folder / "a.exr", read);
  CHECK(check_mutations(bytes_of(folder / "good.exr"), folder / "a.exr", 400, read) > 40);
  const Imath::Box2i window = box(0, 0, 30, 39);
  std::vector<float> values(31 * 40);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 97);
  put_exr<float>(folder / "piz.exr", Imf::FLOAT, window, window, values);
  check_truncations(bytes_of(folder / "piz.exr"), folder / "a.exr", read);
  CHECK(check_mutations(bytes_of(folder / "piz.exr"), folder / "a.exr", 400, read) > 40);
  // The library makes room for an attribute before it reads it.
  std::string greedy = bytes_of(folder / "good.exr");
  const std::string text("strahl:device\0string\0", 21);
  greedy.replace(greedy.find(text) + text.size(), 4, "\xff\xff\xff\x75");
  put_bytes(folder / "a.exr", greedy);
  CHECK_THROWS_WITH(read_image(folder / "a.exr"), Contains("\"strahl:device\" is to have 1979711487 bytes, and"));
  // Or reads on at another place than the attribute's length says, and finds one there.
  const auto refused = [&](const std::string& attribute, const std::string& why) {
    std::string bytes = bytes_of(folder / "good.exr");
    bytes.insert(8, attribute);
    put_bytes(folder / "a.exr", bytes);
    INFO(why);
    CHECK_THROWS_WITH(read_image(folder / "a.exr"), Contains(why));
  };
  const auto attribute = [](const std::string& type, const std::string& value) {
    std::string bytes = "x" + std::string(1, '\0') + type + std::string(1, '\0');
    for (std::size_t i = 0; i < 4; ++i) bytes += static_cast<char>(value.size() >> 8 * i & 255U);
    return bytes + value;
  };
  refused(attribute("float", "12345"), "attribute \"x\" of type float and 5 bytes is to have 4 bytes");
  refused(attribute("chlist", std::string("Y\0", 2) + std::string(20, '\0')), "is no list of channels");
  refused(attribute("chlist", std::string("Y\0", 2) + std::string(16, '\0')), "is no list of channels");
  refused(attribute("stringvector", std::string("\x7f\0\0\0ab", 6)), "is no list of texts");
  refused(attribute("preview", std::string("\0\0\1\0\0\0\1\0abcd", 12)), "is no picture");
  put_bytes(folder / "a.exr", "not an OpenEXR file at all");
  CHECK_THROWS_WITH(read_image(folder / "a.exr"), Contains("a.exr\": not a readable OpenEXR file"));
}

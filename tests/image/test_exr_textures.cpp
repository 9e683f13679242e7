// SPDX-License-Identifier: MIT
// OpenEXR files as textures: the data window is the image, and colours become those of Rec. 709, as in Mitsuba 3.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>

#include <array>
#include <catch2/catch.hpp>
#include <optional>
#include <vector>

#include "image/image_io.h"
#include "image/temporary_folder.h"
#include "image/texels.h"

using namespace strahl;
using namespace strahl::test;

namespace {

using Value = std::array<double, 3>;

/// One pixel at (3, 5) of a larger display window.
Value read_back(const std::vector<const char*>& names, std::vector<float> values,
                const std::optional<Imf::Chromaticities>& primaries = {}) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  const Imath::Box2i data({3, 5}, {3, 5});
  Imf::Header header(Imath::Box2i({0, 0}, {9, 9}), data);
  if (primaries) Imf::addChromaticities(header, *primaries);
  Imf::FrameBuffer pixels;
  for (std::size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names.at(c), Imf::Channel(Imf::FLOAT));
    pixels.insert(names.at(c), Imf::Slice::Make(Imf::FLOAT, &values.at(c), data));
  }
  {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(pixels);
    file.writePixels(1);
  }
  const Texels texels = read_texels(path);
  REQUIRE(texels.width == 1);
  REQUIRE(texels.height == 1);
  return TexelDecoder(texels, {})(0);
}

void require_close(const Value& found, const Value& expected) {
  for (std::size_t c = 0; c < 3; ++c) {
    CAPTURE(c, found[c]);
    CHECK(found[c] == Approx(expected[c]).margin(1e-4));
  }
}

}  // namespace

TEST_CASE("the data window of an OpenEXR texture is the image") {
  require_close(read_back({"R", "G", "B"}, {0.5F, 0.25F, 2}), {0.5, 0.25, 2});
}

TEST_CASE("names of channels in lower case are the same channels, as in Mitsuba") {
  require_close(read_back({"r", "g", "b"}, {0.5F, 0.25F, 2}), {0.5, 0.25, 2});
  require_close(read_back({"l.r", "l.g", "l.b"}, {0.5F, 0.25F, 2}), {0.5, 0.25, 2});
  require_close(read_back({"x", "y", "z"}, {0.41239F, 0.21264F, 0.01933F}), {1, 0, 0});
  require_close(read_back({"y", "a", "depth"}, {0.5F, 1, 7}), {0.5, 0.5, 0.5});
}

TEST_CASE("of several parts the first is the image, which is told") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  std::array<float, 2> values{0.25F, 0.75F};
  std::vector<Imf::Header> headers;
  for (const char* name : {"first", "second"}) {
    Imf::Header header(1, 1);
    header.setName(name);
    header.setType(Imf::SCANLINEIMAGE);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    headers.push_back(header);
  }
  {
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2);
    for (int k = 0; k < 2; ++k) {
      Imf::FrameBuffer pixels;
      pixels.insert("Y",
                    Imf::Slice::Make(Imf::FLOAT, &values.at(static_cast<std::size_t>(k)), headers[0].dataWindow()));
      Imf::OutputPart part(file, k);
      part.setFrameBuffer(pixels);
      part.writePixels(1);
    }
  }
  const Texels texels = read_texels(path);
  CHECK(TexelDecoder(texels, {})(0)[0] == 0.25);
  CHECK(texels.left_out == "it has 2 parts, of which the first is read");
  CHECK_THROWS_WITH(read_image(path), Catch::Contains("2 parts; extract one"));
}

TEST_CASE("X, Y and Z are colours") {
  // White and red of Rec. 709: the columns of its matrix (ITU-R BT.709; D65 is 0.3127, 0.3290).
  require_close(read_back({"X", "Y", "Z"}, {0.95046F, 1, 1.08906F}), {1, 1, 1});
  require_close(read_back({"X", "Y", "Z"}, {0.41239F, 0.21264F, 0.01933F}), {1, 0, 0});
}

TEST_CASE("other primaries are converted, those of Rec. 709 kept to the bit") {
  CHECK(read_back({"R", "G", "B"}, {0.3F, 0.7F, 0.1F}, Imf::Chromaticities()) ==
        Value{static_cast<double>(0.3F), static_cast<double>(0.7F), static_cast<double>(0.1F)});
  // Rec. 2020 (ITU-R BT.2087 gives the matrix to Rec. 709): inside the smaller gamut.
  const Imf::Chromaticities wide({0.708F, 0.292F}, {0.170F, 0.797F}, {0.131F, 0.046F}, {0.3127F, 0.3290F});
  require_close(read_back({"R", "G", "B"}, {0.5F, 0.4F, 0.3F}, wide),
                {1.6605 * 0.5 - 0.5876 * 0.4 - 0.0728 * 0.3, -0.1246 * 0.5 + 1.1329 * 0.4 - 0.0083 * 0.3,
                 -0.0182 * 0.5 - 0.1006 * 0.4 + 1.1187 * 0.3});
}

TEST_CASE("colours of a layer are converted as those of the file are") {
  const Imf::Chromaticities wide({0.708F, 0.292F}, {0.170F, 0.797F}, {0.131F, 0.046F}, {0.3127F, 0.3290F});
  const Value expected = read_back({"R", "G", "B"}, {0.5F, 0.4F, 0.3F}, wide);
  require_close(expected, {0.5734, 0.3884, 0.2863});
  CHECK(read_back({"L.R", "L.G", "L.B"}, {0.5F, 0.4F, 0.3F}, wide) == expected);
  CHECK(read_back({"l.r", "l.g", "l.b"}, {0.5F, 0.4F, 0.3F}, wide) == expected);
  require_close(read_back({"L.X", "L.Y", "L.Z"}, {0.41239F, 0.21264F, 0.01933F}), {1, 0, 0});
  require_close(read_back({"L.X", "L.Y", "L.Z"}, {0.41239F, 0.21264F, 0.01933F}, wide), {1, 0, 0});
}

TEST_CASE("of several layers the first with all three colours is the image, but for colours of the file itself") {
  const Value found{0.5, 0.25, 0.75};
  CHECK(read_back({"AO.R", "D.R", "D.G", "D.B"}, {9, 0.5F, 0.25F, 0.75F}) == found);
  CHECK(read_back({"C.R", "C.G", "C.B", "D.R", "D.G", "D.B"}, {0.5F, 0.25F, 0.75F, 9, 9, 9}) == found);
  CHECK(read_back({"A.R", "A.G", "A.B", "R", "G", "B"}, {9, 9, 9, 0.5F, 0.25F, 0.75F}) == found);
  CHECK(read_back({"A.R", "A.G", "A.B", "R"}, {0.5F, 0.25F, 0.75F, 9}) == found);
  CHECK(read_back({"N.X", "N.Y", "N.Z", "Z.R", "Z.G", "Z.B"}, {9, 9, 9, 0.5F, 0.25F, 0.75F}) == found);
  CHECK(read_back({"N.X", "N.Y", "N.Z", "Y"}, {9, 9, 9, 0.5F}) == Value{0.5, 0.5, 0.5});
  CHECK(read_back({"A.X", "A.Y", "A.Z", "A.R", "A.G", "A.B"}, {9, 9, 9, 0.5F, 0.25F, 0.75F}) == found);
  CHECK_THROWS_WITH(read_back({"A.R", "B.G"}, {1, 1}), Catch::Contains("an image has R, G and B, or X, Y and Z, or Y"));
}

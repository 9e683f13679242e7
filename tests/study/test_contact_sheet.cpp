// SPDX-License-Identifier: MIT
// Contact sheets: every tile where it belongs, every label written.
#include <catch2/catch.hpp>
#include <stdexcept>

#include "study/contact_sheet.h"

using namespace strahl;

namespace {

Image tile(float value) {
  Image image;
  image.width = 40;
  image.height = 20;
  image.data.assign(40 * 20 * 3, value);
  return image;
}

int pixels_of(const Image& image, float value) {
  int count = 0;
  for (std::size_t i = 0; i < image.data.size(); i += 3) count += image.data[i] == value;
  return count;
}

}  // namespace

TEST_CASE("tiles in rows and columns") {
  const Image sheet = contact_sheet(
      {"", ""}, {{"", {{tile(0.25F), ""}, {tile(0.5F), ""}}}, {"", {{tile(0.125F), ""}, {tile(1.0F), ""}}}});
  for (const float value : {0.25F, 0.5F, 0.125F, 1.0F}) CHECK(pixels_of(sheet, value) == 40 * 20);
  const auto at = [&sheet](int x, int y) { return sheet.at(x, y, 0); };
  CHECK(at(8 + 20, 16 + 10) == 0.25F);
  CHECK(at(8 + 44 + 20, 16 + 10) == 0.5F);
  CHECK(at(8 + 20, 16 + 36 + 10) == 0.125F);
}

TEST_CASE("labels and captions, in letters that there are") {
  const auto ink_of = [](const std::string& column, const std::string& row, const std::string& caption) {
    return pixels_of(contact_sheet({column}, {{row, {{tile(0.25F), caption}}}}), 0.9F);
  };
  CHECK(ink_of("", "", "") == 0);
  CHECK(ink_of("1", "", "") == 4 * 8);  // Eight dots of the letter, four pixels each.
  CHECK(ink_of("", "1", "") == 4 * 8);
  CHECK(ink_of("", "", "1") == 4 * 8);
  CHECK(ink_of("a", "", "") == ink_of("A", "", ""));
  CHECK(ink_of("%", "", "") == 0);
  CHECK(ink_of("", "", "1111111111111111") == 16 * 4 * 8);
}

TEST_CASE("labels and captions wider than the pictures meet no neighbour") {
  const std::vector<std::string> columns{"offset 100000", "offset 1e+07"};
  const auto ink = [&](const std::string& left, const std::string& right, const std::string& caption) {
    return pixels_of(contact_sheet({left, right}, {{"", {{tile(0.25F), caption}, {tile(0.5F), ""}}}}), 0.9F);
  };
  // Letters drawn over each other would share pixels, one cut off at the sheet's edge would lack some.
  CHECK(ink(columns[0], columns[1], "") == ink(columns[0], "", "") + ink("", columns[1], ""));
  CHECK(ink("", "", "0.000123456789") == ink("0.000123456789", "", ""));
  const Image sheet = contact_sheet(columns, {{"", {{tile(0.25F), ""}, {tile(0.5F), ""}}}});
  // A dark column of pixels between the two labels: row 4 to 13 is where they are written.
  const int second = 8 + 8 * static_cast<int>(columns[0].size()) + 4;
  for (int y = 4; y < 14; ++y) CHECK(sheet.at(second - 2, y, 0) != 0.9F);
  CHECK(sheet.at(second, 16 + 10, 0) == 0.5F);
}

TEST_CASE("a sheet with gaps is refused") {
  CHECK_THROWS_AS(contact_sheet({"a", "b"}, {{"", {{tile(0), ""}}}}), std::logic_error);
  CHECK_THROWS_AS(contact_sheet({}, {}), std::logic_error);
}

// SPDX-License-Identifier: MIT
// The letters are three pixels wide and five high, drawn at twice the size; each is five octal digits, a row each.
#include "study/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string_view>

namespace strahl {
namespace {

constexpr int zoom = 2, advance = 4 * zoom, line = 8 * zoom, gap = 4;
constexpr float paper = 0.02F, ink = 0.9F;

constexpr std::string_view letters = "0123456789-+.ABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::array<int, 39> glyphs{075557, 026227, 071747, 071717, 055711, 074717, 074757, 071111, 075757, 075717,
                                     000700, 002720, 000002, 025755, 065656, 034443, 065556, 074647, 074644, 034553,
                                     055755, 072227, 011152, 055655, 044447, 057755, 065555, 025552, 065644, 025573,
                                     065655, 034216, 072222, 055557, 055552, 055775, 055255, 055222, 071247};
static_assert(letters.size() == glyphs.size());

void set(Image& sheet, int x, int y, float value) {
  for (int c = 0; c < 3; ++c) sheet.at(x, y, c) = value;
}

void write(Image& sheet, int x, int y, const std::string& text) {
  for (const char letter : text) {
    const auto found = letters.find(static_cast<char>(std::toupper(static_cast<unsigned char>(letter))));
    const int glyph = found == std::string_view::npos ? 0 : glyphs[found];
    for (int row = 0; row < 5 * zoom; ++row)
      for (int column = 0; column < 3 * zoom; ++column)
        if ((glyph >> (3 * (4 - row / zoom) + 2 - column / zoom)) & 1 && x + column < sheet.width)
          set(sheet, x + column, y + row, ink);
    x += advance;
  }
}

/// Of a text, with the space after it.
int written_width(const std::string& text) { return advance * static_cast<int>(text.size()); }

/// A column holds its pictures and what is written above and below them, so that no text meets its neighbour's.
int column_width(const std::vector<std::string>& columns, const std::vector<SheetRow>& rows) {
  int width = rows.front().tiles.front().picture.width;
  for (const std::string& column : columns) width = std::max(width, written_width(column));
  for (const SheetRow& row : rows)
    for (const SheetTile& tile : row.tiles) width = std::max(width, written_width(tile.caption));
  return width;
}

void place(Image& sheet, int x, int y, const Image& tile) {
  for (int row = 0; row < tile.height; ++row)
    for (int column = 0; column < tile.width; ++column)
      for (int c = 0; c < 3; ++c) sheet.at(x + column, y + row, c) = tile.at(column, row, c);
}

}  // namespace

Image contact_sheet(const std::vector<std::string>& columns, const std::vector<SheetRow>& rows) {
  if (rows.empty() || columns.empty() || rows.front().tiles.empty())
    throw std::logic_error("a contact sheet without pictures");
  const int width = rows.front().tiles.front().picture.width, height = rows.front().tiles.front().picture.height;
  std::size_t longest = 0;
  for (const SheetRow& row : rows) longest = std::max(longest, row.label.size());
  const int left = advance * static_cast<int>(longest) + 2 * gap;
  const int pitch = column_width(columns, rows) + gap;
  Image sheet;
  sheet.width = left + static_cast<int>(columns.size()) * pitch;
  sheet.height = line + gap + static_cast<int>(rows.size()) * (height + line);
  sheet.data.assign(static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height) * 3, paper);

  for (std::size_t column = 0; column < columns.size(); ++column)
    write(sheet, left + static_cast<int>(column) * pitch, gap, columns[column]);
  int y = line;
  for (const SheetRow& row : rows) {
    if (row.tiles.size() != columns.size()) throw std::logic_error("a row of a contact sheet with a gap");
    write(sheet, gap, y + (height - 5 * zoom) / 2, row.label);
    int x = left;
    for (const SheetTile& tile : row.tiles) {
      if (tile.picture.width != width || tile.picture.height != height)
        throw std::logic_error("tiles of a contact sheet differ in size");
      place(sheet, x, y, tile.picture);
      write(sheet, x, y + height + zoom, tile.caption);
      x += pitch;
    }
    y += height + line;
  }
  return sheet;
}

}  // namespace strahl

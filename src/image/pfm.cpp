// SPDX-License-Identifier: MIT
// Portable float maps: "PF" (colour) or "Pf" (grey), width, height, a scale whose sign gives the byte order, one white
// space, then 32-bit floats, bottom row first. Format: Debevec, "PFM Portable FloatMap Image Format", 2001.
#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "errors.h"
#include "image/atomic_file.h"
#include "image/byte_order.h"
#include "image/codecs.h"
#include "image/colour_channels.h"

namespace strahl {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Takes the next token and the one white space after it.
std::string_view take_token(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_space(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !is_space(text[end])) ++end;
  const std::string_view token = text.substr(begin, end - begin);
  text.remove_prefix(std::min(end + 1, text.size()));
  return token;
}

template <class T>
bool parse(std::string_view token, T& value) {
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc() && end == token.data() + token.size();
}

}  // namespace

WriteReport write_pfm(const Image& image, const std::string& path) {
  std::vector<int> colours = colour_channels(image);
  const bool grey = colours.size() == 1;
  WriteReport report;
  std::vector<float> values;
  values.reserve(image.data.size());
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      for (std::size_t c = 0; c < (grey ? 1 : 3); ++c) {
        const float value = c < colours.size() ? image.at(x, y, colours[c]) : 0.0F;
        if (!std::isfinite(value)) ++report.invalid;
        values.push_back(value);
      }
    }
  }
  AtomicFile file(path);
  file.write(fmt::format("{}\n{} {}\n-1.0\n", grey ? "Pf" : "PF", image.width, image.height));
  file.write(little_endian_bytes(values));
  file.commit();
  return report;
}

Image read_pfm(const std::string& path, const std::string& bytes) {
  std::string_view rest = bytes;
  const std::string_view magic = take_token(rest);
  if (magic != "PF" && magic != "Pf") {
    throw InputError(fmt::format("\"{}\": not a PFM file (it does not begin with PF or Pf)", path));
  }
  Image image;
  if (magic == "Pf") image.channels = {"Y"};
  double scale = 0;
  if (!parse(take_token(rest), image.width) || !parse(take_token(rest), image.height) ||
      !parse(take_token(rest), scale) || scale == 0 || !std::isfinite(scale)) {
    throw InputError(fmt::format("\"{}\": damaged PFM header (width, height and a scale other than 0 expected)", path));
  }
  check_picture_size(path, image.width, image.height, image.channels.size(), bytes.size());

  const std::size_t count = image.index(0, image.height, 0);
  if (rest.size() != count * sizeof(float)) {
    throw InputError(fmt::format("\"{}\": {} x {} pixels need {} bytes of data, the file has {}", path, image.width,
                                 image.height, count * sizeof(float), rest.size()));
  }
  const std::endian order = scale < 0 ? std::endian::little : std::endian::big;
  const float factor = static_cast<float>(std::fabs(scale));
  image.data.resize(count);
  const std::size_t row = image.index(0, 1, 0);
  for (int y = 0; y < image.height; ++y) {
    const char* source = rest.data() + static_cast<std::size_t>(image.height - 1 - y) * row * sizeof(float);
    for (std::size_t i = 0; i < row; ++i) {
      const float value = load<float>(source + i * sizeof(float), order);
      image.data[image.index(0, y, 0) + i] = factor == 1.0F ? value : value * factor;
    }
  }
  return image;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// The checks before any comparison. Pictures that cannot be compared must not give a number.
#include "image/comparable.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "errors.h"
#include "image/colour_channels.h"

namespace strahl {
namespace {

std::vector<std::string> names(const Image& image, const std::vector<int>& channels) {
  std::vector<std::string> result;
  for (const int c : channels) result.push_back(image.channels[static_cast<std::size_t>(c)]);
  return result;
}

void check_values(const Image& image, const char* which) {
  if (image.width < 1 || image.height < 1)
    throw InputError(fmt::format("{} has {} x {} pixels: nothing to compare", which, image.width, image.height));
  if (image.data.size() != image.index(0, image.height, 0))
    throw InputError(fmt::format("{} has {} x {} pixels with {} channels, which are {} values, and holds {}", which,
                                 image.width, image.height, image.channels.size(), image.index(0, image.height, 0),
                                 image.data.size()));
}

void check_colours(const Image& image, const std::vector<int>& colours, const char* which) {
  if (!colours.empty()) return;
  throw InputError(
      fmt::format("{} has no colour channels to compare: {}", which,
                  image.channels.empty() ? "no channels at all" : fmt::format("{}", fmt::join(image.channels, " "))));
}

void check_finite(const Image& image, const std::vector<int>& channels, const char* which) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (const int c : channels) {
        if (std::isfinite(image.at(x, y, c))) continue;
        throw InputError(fmt::format("{} holds {} at pixel {},{} in channel {}: nothing to compare", which,
                                     image.at(x, y, c), x, y, image.channels[static_cast<std::size_t>(c)]));
      }
    }
  }
}

}  // namespace

ComparedChannels comparable_channels(const Image& a, const Image& reference) {
  check_values(a, "the picture");
  check_values(reference, "the reference");
  if (a.width != reference.width || a.height != reference.height) {
    throw InputError(fmt::format("sizes differ: the picture has {} x {} pixels, the reference {} x {}", a.width,
                                 a.height, reference.width, reference.height));
  }
  ComparedChannels channels{colour_channels(a), colour_channels(reference)};
  check_colours(a, channels.a, "the picture");
  check_colours(reference, channels.reference, "the reference");
  const std::vector<std::string> ours = names(a, channels.a);
  const std::vector<std::string> theirs = names(reference, channels.reference);
  if (ours != theirs) {
    throw InputError(fmt::format("colour channels differ: the picture has {}, the reference {}", fmt::join(ours, " "),
                                 fmt::join(theirs, " ")));
  }
  check_finite(a, channels.a, "the picture");
  check_finite(reference, channels.reference, "the reference");
  return channels;
}

}  // namespace strahl

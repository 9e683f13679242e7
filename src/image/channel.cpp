// SPDX-License-Identifier: MIT
#include "image/channel.h"

#include <numeric>

namespace strahl {

double Channel::mean() const {
  double sum = 0;
  for (int y = 0; y < height; ++y) sum += std::accumulate(row(y), row(y) + width, 0.0);
  return sum / static_cast<double>(values.size());
}

Channel channel_of(const Image& image, int index) {
  Channel channel(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    double* row = channel.row(y);
    for (int x = 0; x < image.width; ++x) row[x] = static_cast<double>(image.at(x, y, index));
  }
  return channel;
}

}  // namespace strahl

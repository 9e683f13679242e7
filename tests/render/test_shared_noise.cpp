// SPDX-License-Identifier: MIT
// How much of their noise neighbouring pixels have in common, from products of theirs.
#include <catch2/catch.hpp>

#include "render/shared_noise.h"

using namespace strahl;

TEST_CASE("noise is shared along two axes, as far as the filter allows") {
  SharedNoise noise;
  CHECK(noise.overlap(1.6) == 1.6);  // Nothing says that it is less.
  noise.own = 10;
  CHECK(noise.overlap(1.6) == 1);
  noise.left = 1;
  CHECK(noise.overlap(2) == Approx(1.2));
  noise.above = 0.5;
  CHECK(noise.overlap(2) == Approx(1.2 * 1.1));
  CHECK(noise.overlap(1.21) == Approx(1.1 * 1.1));
  noise.above = -3;
  CHECK(noise.overlap(2) == Approx(1.2));
  noise.left = noise.above = 9;
  CHECK(noise.overlap(1.6) == Approx(1.6));
}

TEST_CASE("products of neighbours, row by row") {
  SharedNoiseRows<2> rows(3);
  const SharedNoiseRows<2>::Products pixels[2][3] = {{{1, 2}, {3, 4}, {5, 6}}, {{7, 8}, {9, 10}, {11, 12}}};
  SharedNoise sum;
  for (const auto& row : pixels)
    for (std::size_t x = 0; x < 3; ++x) sum += rows.add(x, row[x]);
  CHECK(sum.own == 650);
  CHECK(sum.left == (3 + 8) + (15 + 24) + (63 + 80) + (99 + 120));
  CHECK(sum.above == (7 + 16) + (27 + 40) + (55 + 72));
}

// SPDX-License-Identifier: MIT
#include "image/inferno.h"

#include "image/colour_table.h"

namespace strahl {
namespace {

constexpr ColourTable<10> inferno_entries{{{0x00, 0x00, 0x04},
                                           {0x1b, 0x0c, 0x42},
                                           {0x4b, 0x0c, 0x6b},
                                           {0x78, 0x1c, 0x6d},
                                           {0xa5, 0x2c, 0x60},
                                           {0xcf, 0x44, 0x46},
                                           {0xed, 0x69, 0x25},
                                           {0xfb, 0x9a, 0x06},
                                           {0xf7, 0xd0, 0x3c},
                                           {0xfc, 0xff, 0xa4}}};

}  // namespace

std::array<float, 3> inferno(double t) { return table_colour(inferno_entries, t); }

}  // namespace strahl

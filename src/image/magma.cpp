// SPDX-License-Identifier: MIT
#include "image/magma.h"

#include "image/colour_table.h"

namespace strahl {
namespace {

constexpr ColourTable<16> magma_entries{{{0x00, 0x00, 0x04},
                                         {0x0b, 0x09, 0x24},
                                         {0x20, 0x11, 0x4b},
                                         {0x3b, 0x0f, 0x70},
                                         {0x57, 0x15, 0x7e},
                                         {0x72, 0x1f, 0x81},
                                         {0x8c, 0x29, 0x81},
                                         {0xa8, 0x32, 0x7d},
                                         {0xc4, 0x3c, 0x75},
                                         {0xde, 0x49, 0x68},
                                         {0xf1, 0x60, 0x5d},
                                         {0xfa, 0x7f, 0x5e},
                                         {0xfe, 0x9f, 0x6d},
                                         {0xfe, 0xbf, 0x84},
                                         {0xfd, 0xde, 0xa0},
                                         {0xfc, 0xfd, 0xbf}}};

}  // namespace

std::array<float, 3> magma(double t) { return table_colour(magma_entries, t); }

}  // namespace strahl

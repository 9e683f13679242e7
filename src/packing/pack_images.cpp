// SPDX-License-Identifier: MIT
#include "packing/pack_images.h"

#include <vector>

#include "packing/cl_layout.h"

namespace strahl {
namespace {

int layout_of(const Texels& texels) {
  switch (texels.format) {
    case TexelFormat::bits_8:
      return texels.is_grey ? layout::TEXELS_GREY_8 : layout::TEXELS_RGB_8;
    case TexelFormat::bits_16:
      return texels.is_grey ? layout::TEXELS_GREY_16 : layout::TEXELS_RGB_16;
    case TexelFormat::half:
      return texels.is_grey ? layout::TEXELS_GREY_HALF : layout::TEXELS_RGB_HALF;
    case TexelFormat::rgbe:
      return layout::TEXELS_RGBE;
    case TexelFormat::real:
      break;
  }
  return texels.is_grey ? layout::TEXELS_GREY_REAL : layout::TEXELS_RGB_REAL;
}

bool has_curve(TexelFormat format) { return format == TexelFormat::bits_8 || format == TexelFormat::bits_16; }

}  // namespace

template <typename Real>
std::array<std::int32_t, layout::IMAGE_INTS> PackedImages<Real>::put(const Texels& texels, const TexelCurve& curve) {
  const auto [texels_at, is_new] = texels_.try_emplace(&texels, 0);
  if (is_new && texels.format == TexelFormat::real) {
    texels_at->second = packed_.put_floats(texels.reals);
    packed_.put_shading({0});  // The last texel's three are read as four.
  } else if (is_new) {
    texels_at->second = packed_.put_index(texels.words);
  }
  int table = 0;
  if (has_curve(texels.format)) {
    const auto [table_at, is_new_table] = tables_.try_emplace({texels.format, curve.kind, curve.gamma}, 0);
    if (is_new_table) table_at->second = packed_.put_shading(decoding_table(texels.format, curve));
    table = table_at->second;
  }
  return {texels.width, texels.height, layout_of(texels), texels_at->second, table};
}

template <typename Real>
int PackedImages<Real>::row(const Texels& texels, const TexelCurve& curve) {
  const auto image = put(texels, curve);
  const auto [row_at, is_new] = rows_.try_emplace({&texels, image[layout::IMAGE_TABLE]}, 0);
  if (is_new) row_at->second = packed_.put_index(image);
  return row_at->second;
}

template <typename Real>
typename PackedImages<Real>::Levels PackedImages<Real>::levels(const Texels& texels, const TexelCurve& curve) {
  const auto first = put(texels, curve);
  const auto [known, is_new] = levels_.try_emplace({&texels, first[layout::IMAGE_TABLE]}, Levels{});
  if (!is_new) return known->second;
  std::vector<std::int32_t> rows(first.begin(), first.end());
  const Texels* last = &texels;
  while (last->width > 1 || last->height > 1) {
    reduced_.push_back(reduced(*last, last == &texels ? curve : TexelCurve{}));
    last = &reduced_.back();
    const auto next = put(*last, {});
    rows.insert(rows.end(), next.begin(), next.end());
  }
  known->second = {packed_.put_index(rows), static_cast<int>(rows.size()) / layout::IMAGE_INTS};
  return known->second;
}

template class PackedImages<float>;
template class PackedImages<double>;

}  // namespace strahl

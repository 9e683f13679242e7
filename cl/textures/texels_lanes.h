// SPDX-License-Identifier: MIT
// Texels of images (scene/layout.h, IMAGE_...). Codes of 8 and 16 bits lie in the index as the file had them: a table
// says what integers mean, and halves and RGBE are computed, which takes less time than to gather. Floats lie in the
// shading data. Textures and lights include this file: once per width.
#if !((LANES == 1 && defined(STRAHL_TEXELS_1)) || (LANES == 8 && defined(STRAHL_TEXELS_8)) || \
      (LANES == 16 && defined(STRAHL_TEXELS_16)))
#if LANES == 1
#define STRAHL_TEXELS_1
#elif LANES == 8
#define STRAHL_TEXELS_8
#else
#define STRAHL_TEXELS_16
#endif

FN uintw texel_word_w(const Scene* scene, GLOBAL const int* image, intw word) {
  return uint_of_int_w(gather_int_w(scene->index + image[IMAGE_TEXELS], word));
}

/// The value of each lane's code, by the image's table.
FN realw decoded_w(const Scene* scene, GLOBAL const int* image, uintw code) {
  return gather_w(scene->shading + image[IMAGE_TABLE], int_of_uint_w(code));
}

/// Of half precision, not negative, infinite or NaN.
FN realw value_of_half_w(uintw code) {
  uintw exponent = (code >> 10u) & splat_uint_w(31u), mantissa = code & splat_uint_w(1023u);
  maskw is_normal = lt_uint_w(splat_uint_w(0u), exponent);
  realw digits = real_of_uint_w(mantissa) + sel_w(is_normal, splat_w(R(1024.0)), splat_w(R(0.0)));
  intw one = splat_int_w(1), up = sel_int_w(is_normal, int_of_uint_w(exponent), one);
  return digits * power_of_half_w(splat_int_w(25) - up);
}

/// 2^(exponent - 136), or 0 where it is 0: what the mantissas of RGBE, integers of 8 bits, are multiplied by.
FN realw rgbe_unit_w(uintw exponent) {
  intw halvings = splat_int_w(136) - int_of_uint_w(exponent);
  // In float the smallest are denormal.
  maskw is_tiny = lt_int_w(splat_int_w(126), halvings);
  realw unit = power_of_half_w(sel_int_w(is_tiny, halvings - splat_int_w(10), halvings));
  unit = unit * sel_w(is_tiny, splat_w(R(0x1p-10)), splat_w(R(1.0)));
  return sel_w(lt_uint_w(splat_uint_w(0u), exponent), unit, splat_w(R(0.0)));
}

FN real3w grey_w(realw value) { return vec3_w(value, value, value); }

/// number: row * width + column, of the image.
FN real3w texel_w(const Scene* scene, GLOBAL const int* image, intw number) {
  uintw n = uint_of_int_w(number), byte = splat_uint_w(0xffu), two_bytes = splat_uint_w(0xffffu), word = n;
  int format = image[IMAGE_FORMAT];
  switch (format) {
    case TEXELS_GREY_8:
      word = texel_word_w(scene, image, int_of_uint_w(n >> 2u)) >> ((n & splat_uint_w(3u)) << 3u);
      return grey_w(decoded_w(scene, image, word & byte));
    case TEXELS_GREY_16:
    case TEXELS_GREY_HALF:
      word = texel_word_w(scene, image, int_of_uint_w(n >> 1u)) >> ((n & splat_uint_w(1u)) << 4u);
      word = word & two_bytes;
      return grey_w(format == TEXELS_GREY_HALF ? value_of_half_w(word) : decoded_w(scene, image, word));
    case TEXELS_GREY_REAL:
      return grey_w(gather_w(scene->shading + image[IMAGE_TEXELS], number));
    case TEXELS_RGB_8:
      word = texel_word_w(scene, image, number);
      return vec3_w(decoded_w(scene, image, word & byte), decoded_w(scene, image, (word >> 8u) & byte),
                    decoded_w(scene, image, (word >> 16u) & byte));
    case TEXELS_RGB_16:
    case TEXELS_RGB_HALF: {
      uintw blue = texel_word_w(scene, image, number * splat_int_w(2) + splat_int_w(1));
      word = texel_word_w(scene, image, number * splat_int_w(2));
      uintw red = word & two_bytes, green = word >> 16u;
      if (format == TEXELS_RGB_HALF) return vec3_w(value_of_half_w(red), value_of_half_w(green), value_of_half_w(blue));
      return vec3_w(decoded_w(scene, image, red), decoded_w(scene, image, green), decoded_w(scene, image, blue));
    }
    case TEXELS_RGB_REAL: {
      realw row[4];  // The fourth is another texel's, or the image's last real.
      gather_row_w(scene->shading + image[IMAGE_TEXELS], number * splat_int_w(3), 4, row);
      return real3_at_w(row);
    }
    default: {
      // TEXELS_RGBE.
      word = texel_word_w(scene, image, number);
      return scale3_w(rgbe_unit_w(word >> 24u), vec3_w(real_of_uint_w(word & byte), real_of_uint_w((word >> 8u) & byte),
                                                       real_of_uint_w((word >> 16u) & byte)));
    }
  }
}

/// Between a and b, which have weights 1 - weight and weight.
FN real3w mean3_w(realw weight, real3w a, real3w b) { return fma3_w(weight, b, scale3_w(splat_w(R(1.0)) - weight, a)); }
#endif

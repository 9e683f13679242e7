// SPDX-License-Identifier: MIT
// Texels of images (scene/layout.h, IMAGE_...). Codes of 8 and 16 bits lie in the index as the file had them, and a
// table says what each of them means; floats lie in the shading data. Textures and lights include this file: once per
// width.
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

/// The value of each lane's code.
FN realw decoded_w(const Scene* scene, GLOBAL const int* image, uintw code) {
  return gather_w(scene->shading + image[IMAGE_TABLE], int_of_uint_w(code));
}

/// 2^(exponent - 136), 0 where it is 0: of RGBE, whose mantissas are integers of 8 bits.
FN realw rgbe_unit_w(intw exponent) {
  // What is below the normal numbers in float is not below a product.
  intw halvings = splat_int_w(136) - exponent;
  maskw is_tiny = lt_int_w(splat_int_w(126), halvings);
  realw unit = power_of_half_w(sel_int_w(is_tiny, halvings - splat_int_w(10), halvings));
  unit = unit * sel_w(is_tiny, splat_w(R(0x1p-10)), splat_w(R(1.0)));
  return sel_w(nonzero_w(exponent), unit, splat_w(R(0.0)));
}

FN real3w grey_w(realw value) { return vec3_w(value, value, value); }

/// number: row * width + column, of the image.
FN real3w texel_w(const Scene* scene, GLOBAL const int* image, intw number) {
  uintw n = uint_of_int_w(number), byte = splat_uint_w(0xffu), word = n;
  switch (image[IMAGE_FORMAT]) {
    case TEXELS_GREY_8:
      word = texel_word_w(scene, image, int_of_uint_w(n >> 2u)) >> ((n & splat_uint_w(3u)) << 3u);
      return grey_w(decoded_w(scene, image, word & byte));
    case TEXELS_GREY_16:
      word = texel_word_w(scene, image, int_of_uint_w(n >> 1u)) >> ((n & splat_uint_w(1u)) << 4u);
      return grey_w(decoded_w(scene, image, word & splat_uint_w(0xffffu)));
    case TEXELS_GREY_REAL:
      return grey_w(gather_w(scene->shading + image[IMAGE_TEXELS], number));
    case TEXELS_RGB_8:
      word = texel_word_w(scene, image, number);
      return vec3_w(decoded_w(scene, image, word & byte), decoded_w(scene, image, (word >> 8u) & byte),
                    decoded_w(scene, image, (word >> 16u) & byte));
    case TEXELS_RGB_16: {
      uintw blue = texel_word_w(scene, image, number * splat_int_w(2) + splat_int_w(1));
      word = texel_word_w(scene, image, number * splat_int_w(2));
      return vec3_w(decoded_w(scene, image, word & splat_uint_w(0xffffu)), decoded_w(scene, image, word >> 16u),
                    decoded_w(scene, image, blue));
    }
    case TEXELS_RGB_REAL:
      return gather3_w(scene->shading + image[IMAGE_TEXELS], number * splat_int_w(3));
    default: {
      // TEXELS_RGBE: the table holds the exponent's power of two.
      word = texel_word_w(scene, image, number);
      realw power = rgbe_unit_w(int_of_uint_w(word >> 24u));
      return scale3_w(power, vec3_w(real_of_uint_w(word & byte), real_of_uint_w((word >> 8u) & byte),
                                    real_of_uint_w((word >> 16u) & byte)));
    }
  }
}

/// Between a and b, which have weights 1 - weight and weight.
FN real3w mean3_w(realw weight, real3w a, real3w b) { return fma3_w(weight, b, scale3_w(splat_w(R(1.0)) - weight, a)); }
#endif

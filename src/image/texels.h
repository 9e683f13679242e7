// SPDX-License-Identifier: MIT
// Images as textures and environments use them: texels with the bits of the file, in the layout of the kernels
// (cl/scene/layout.h, TEXELS_...), and what their codes mean.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace strahl {

/// bits_8, bits_16: integers. half: 16 bits of a float. rgbe: three mantissas of 8 bits and an exponent (Radiance).
enum class TexelFormat { bits_8, bits_16, half, rgbe, real };

/// What integers mean. Of the other formats it says nothing: they are linear.
struct TexelCurve {
  enum class Kind { linear, srgb, power } kind = Kind::srgb;
  double gamma = 1;  ///< Of power: light = code to the power gamma.
  friend bool operator==(const TexelCurve&, const TexelCurve&) = default;
};

/// What the values of a file of floats are: light is never negative, heights may be.
enum class TexelUse { light, heights };

/// Rows from the top.
struct Texels {
  std::string file;
  int width = 0, height = 0;
  bool is_grey = false;
  TexelFormat format = TexelFormat::bits_8;
  std::vector<std::int32_t> words;  ///< Empty of `real`.
  std::vector<float> reals;         ///< Of `real`: 1 or 3 a texel.
  std::string doubt;                ///< What the file's decoder warned of, though there is a picture; else empty.
  std::string left_out;             ///< What of the file the image has not; else empty.
  std::size_t repaired = 0;         ///< Texels that were negative or no number (now 0) or infinite (now the largest);
                                    ///< of heights those that were not finite alone.

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// The most texels that an image may have; larger ones are refused before they are unpacked.
constexpr std::int64_t most_texels = std::int64_t{1} << 28;
/// The most along a side of an image or of a grid: kernels find places along it as a float, which has 24 bits.
constexpr std::int64_t longest_side = std::int64_t{1} << 24;

/// Light by code: 256 or 65536 values; of rgbe what the exponent multiplies by; of `real` none.
[[nodiscard]] std::vector<double> decoding_table(TexelFormat format, const TexelCurve& curve);

/// Linear light of texels, one after the other.
class TexelDecoder {
 public:
  /// texels: must outlive this.
  TexelDecoder(const Texels& texels, const TexelCurve& curve)
      : texels_(texels), table_(decoding_table(texels.format, curve)) {}
  [[nodiscard]] std::array<double, 3> operator()(std::size_t number) const;

 private:
  const Texels& texels_;
  std::vector<double> table_;
};

/// channels: 1 or 3; values.size() = channels * width * height. Halves where they hold every value exactly.
[[nodiscard]] Texels texels_of_floats(int width, int height, int channels, std::vector<float> values);
/// As texels_of_floats; values that no light has, or no height, are repaired first (Texels::repaired).
[[nodiscard]] Texels repaired_texels(int width, int height, int channels, std::vector<float> values,
                                     TexelUse use = TexelUse::light);
/// codes: bytes, of rgb or grey.
[[nodiscard]] Texels texels_of_bytes(int width, int height, int channels, const std::uint8_t* codes);
/// codes: integers of 16 bits, or halves.
[[nodiscard]] Texels texels_of_words(int width, int height, int channels, const std::uint16_t* codes,
                                     TexelFormat format);
/// values that an RGBE file has held, three a texel: the same bits again.
[[nodiscard]] Texels texels_of_rgbe(int width, int height, const float* values);

/// The image of half the width and height, rounded down but at least 1, in halves: each texel the mean over its area.
[[nodiscard]] Texels reduced(const Texels& texels, const TexelCurve& curve);

/// The same image with values of at most 1, and how many texels had more.
struct Clamped {
  Texels texels;
  std::size_t changed = 0;
};
[[nodiscard]] Clamped clamped_to_one(const Texels& texels);

/// PNG, JPEG, OpenEXR, Radiance HDR, TGA, BMP or PFM, told by the first bytes; alpha is left out. Throws InputError.
[[nodiscard]] Texels read_texels(const std::string& path, TexelUse use = TexelUse::light);

/// Throws InputError where an image is too large to be unpacked, or a side of it too long, with its numbers.
void check_texel_count(const std::string& path, std::int64_t width, std::int64_t height);

}  // namespace strahl

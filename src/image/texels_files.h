// SPDX-License-Identifier: MIT
// What read_texels() promises, one function a kind of file; texels_read.cpp alone calls these.
#pragma once

#include <string>

#include "image/texels.h"

namespace strahl {

[[nodiscard]] Texels read_jpeg_texels(const std::string& path, const std::string& bytes);
/// Radiance HDR, TGA or BMP.
[[nodiscard]] Texels read_stb_texels(const std::string& path, const std::string& bytes);
[[nodiscard]] bool is_stb_image(const std::string& bytes);

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Colours of OpenEXR files: their primaries, or X, Y and Z.
#pragma once

#include <ImfHeader.h>

#include "image/image.h"

namespace strahl {

/// Colours by the primaries of Rec. 709, as Mitsuba 3 converts those of textures: of X, Y and Z, and of R, G and B
/// whose header states other `chromaticities`. Whites are not adapted. Other channels stay.
void convert_to_rec_709(Image& image, const Imf::Header& header);

}  // namespace strahl

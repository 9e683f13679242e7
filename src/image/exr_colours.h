// SPDX-License-Identifier: MIT
// Colours of OpenEXR files: their primaries, or X, Y and Z.
#pragma once

#include <ImfHeader.h>

#include "image/image.h"

namespace strahl {

/// The colours that named_colours() finds, by the primaries of Rec. 709, as Mitsuba 3 converts those of textures: of X,
/// Y and Z, and of R, G and B whose header states other `chromaticities`. Whites are not adapted. Names and other
/// channels stay.
void convert_to_rec_709(Image& image, const Imf::Header& header);

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Where media stand in the buffers of a scene, as scene/layout.h has it for all else; only in programs with MEDIA.
#ifndef STRAHL_MEDIA_MEDIA_LAYOUT_H
#define STRAHL_MEDIA_MEDIA_LAYOUT_H

// Behind the rows of the kinds of shapes, and of instances. MEDIA_ROWS: -> index, MEDIUM_INTS a medium; MEDIA_PARTS: ->
// index, BOUNDARY_INTS a part; MEDIA_CAMERA: the medium around the camera. A medium is a number from 0 on.
enum { MEDIA_ROWS, MEDIA_PARTS, MEDIA_CAMERA, MEDIA_INTS };

// The media behind a surface and before it, where its normal points to.
enum { BOUNDARY_INSIDE, BOUNDARY_OUTSIDE, BOUNDARY_INTS };
enum { MEDIUM_NONE = -1, MEDIUM_SAME = -2 };  // MEDIUM_SAME, of both: the surface is no boundary of media.

// MEDIUM_IS_GREY: 1: all channels have the same sigma_t. MEDIUM_PHASES: -> index, PHASE_INTS each.
enum { MEDIUM_KIND, MEDIUM_REALS, MEDIUM_IS_GREY, MEDIUM_PHASES, MEDIUM_PHASE_COUNT, MEDIUM_INTS };
// Reals: r g b each. MEDIUM_SIGMA_T: per unit of length. MEDIUM_EMISSION: the radiance
// that the medium has where it is infinitely thick and scatters nothing.
enum { MEDIUM_SIGMA_T = 0, MEDIUM_ALBEDO = 3, MEDIUM_EMISSION = 6, MEDIUM_REAL_COUNT = 9 };

// A phase function: PHASE_..., then -> shading, its share among those of the medium, and g.
enum { PHASE_KIND, PHASE_REALS, PHASE_INTS };
enum { PHASE_SHARE, PHASE_G };

#endif

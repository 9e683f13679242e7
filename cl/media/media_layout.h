// SPDX-License-Identifier: MIT
// Where media stand in the buffers of a scene, as scene/layout.h has it for all else; only in programs with MEDIA.
#ifndef STRAHL_MEDIA_MEDIA_LAYOUT_H
#define STRAHL_MEDIA_MEDIA_LAYOUT_H

// Behind the rows of the kinds of shapes, and of instances. MEDIA_ROWS: -> index, MEDIUM_INTS a medium; MEDIA_PARTS: ->
// index, BOUNDARY_INTS a part; MEDIA_CAMERA: the medium around the camera. A medium is a number from 0 on.
// MEDIA_BOUNDARIES: -> index, a row as of a group: shapes that are seen by nothing and stand apart; 0: there are none.
// MEDIA_IS_CONVEX: 1: they are one convex body. MEDIA_VEILS: 1: other surfaces may let a share of light pass as it
// came. MEDIA_BALL: -> shading, BALL_REALS: the ball around the box around everything bounded.
enum { MEDIA_ROWS, MEDIA_PARTS, MEDIA_CAMERA, MEDIA_BOUNDARIES, MEDIA_IS_CONVEX, MEDIA_VEILS, MEDIA_BALL, MEDIA_INTS };

// Its centre x y z, and
enum { BALL_RADIUS = 3, BALL_REALS };

// The media behind a surface and before it, where its normal points to.
enum { BOUNDARY_INSIDE, BOUNDARY_OUTSIDE, BOUNDARY_INTS };
enum { MEDIUM_NONE = -1, MEDIUM_SAME = -2 };  // MEDIUM_SAME, of both: the surface is no boundary of media.

// MEDIUM_IS_GREY: 1: all channels have the same sigma_t. MEDIUM_PHASES: -> index, PHASE_INTS each. MEDIUM_IS_LIT: 1:
// lights are drawn where paths scatter.
enum {
  MEDIUM_KIND,
  MEDIUM_REALS,
  MEDIUM_IS_GREY,
  MEDIUM_PHASES,
  MEDIUM_PHASE_COUNT,
  MEDIUM_IS_LIT,
  // Of a medium that varies: -> index, VOLUME_INTS each of VOLUME_SIGMA_T ...; -> index, MAJORANT_INTS; 0 or 1.
  MEDIUM_VOLUMES,
  MEDIUM_MAJORANTS,
  MEDIUM_SCATTERS,
  MEDIUM_EMITS,
  MEDIUM_INTS
};
// Reals: r g b each. MEDIUM_SIGMA_T: per unit of length. MEDIUM_EMISSION: the radiance
// that the medium has where it is infinitely thick and scatters nothing.
enum { MEDIUM_SIGMA_T = 0, MEDIUM_ALBEDO = 3, MEDIUM_EMISSION = 6, MEDIUM_REAL_COUNT = 9 };

// Values over a box. VOLUME_REALS: -> shading: the box's centre and the three rows that take a place's distance from
// it to the box's own frame, where its sides are 1 long; then what multiplies the texels, r g b. VOLUME_IMAGE: ->
// index, IMAGE_INTS, the layers of the box one below the other; -1: alike everywhere.
enum { VOLUME_REALS, VOLUME_IMAGE, VOLUME_HEIGHT, VOLUME_DEPTH, VOLUME_FILTER, VOLUME_WRAP, VOLUME_INTS };
enum { VOLUME_SCALE = 12, VOLUME_REAL_COUNT = 15 };
enum { VOLUME_SIGMA_T, VOLUME_ALBEDO, VOLUME_EMISSION, VOLUMES_A_MEDIUM };

// The cells of a medium that varies. MAJORANT_REALS: -> shading: as of a volume, but cells are 1 long; then the box
// along the axes that the medium fills. MAJORANT_MOST: -> shading, the largest sigma_t of each cell, x first.
enum { MAJORANT_REALS, MAJORANT_MOST, MAJORANT_WIDTH, MAJORANT_HEIGHT, MAJORANT_DEPTH, MAJORANT_INTS };
enum { MAJORANT_LOW = 12, MAJORANT_HIGH = 15, MAJORANT_REAL_COUNT = 18 };

// A phase function: PHASE_..., then -> shading, its share among those of the medium, and g.
enum { PHASE_KIND, PHASE_REALS, PHASE_INTS };
enum { PHASE_SHARE, PHASE_G };

#endif

// SPDX-License-Identifier: MIT
// Every use of random numbers, stated once. A number is used for one thing only, but that the two branches that leave
// one surface of glass in whitted share theirs, and light tracing draws parts of blends for light that masks let
// through to the sensor by those of the path's next vertex: of what is added up, no factor of one product has
// another's. Numbers come in pairs that are spread evenly over the unit square together; pairs are independent of each
// other. A vertex of a path has the same pairs regardless of what happened before it, so that a sample can be drawn in
// any order.
//
// The counts below leave room: a new use takes a free number, and every picture keeps its bits
// (docs/decisions/0019-numbers-and-lights.md). Changing a number or a count changes every picture.
#ifndef STRAHL_SAMPLERS_USES_H
#define STRAHL_SAMPLERS_USES_H

/// Numbers of the sample as a whole. A use that sample_pair draws takes two numbers, the first of them even.
enum {
  USE_PIXEL = 0,    ///< The place within the pixel.
  USE_LENS = 2,     ///< The place on the lens.
  USE_CHANNEL = 4,  ///< The channel that distances within media are drawn for.
  USE_SEEN = 6,     ///< The pixel through which a light path's sample sees the background.
  PAIRS_A_SAMPLE = 4
};

/// Numbers of each vertex.
enum {
  USE_LIGHT = 0,     ///< Which light.
  USE_ITEM = 1,      ///< Which of its items.
  USE_PLACE = 2,     ///< The place on it, or the direction to it.
  USE_WAY = 4,       ///< The direction that the material draws.
  USE_LOBE = 6,      ///< Which of the material's lobes.
  USE_ROULETTE = 7,  ///< Whether the path goes on.
  USE_DISTANCE = 8,  ///< How far the path comes within a medium; both numbers.
  USE_TEXEL = 12,    ///< Which row and column of an environment.
  USE_MASK = 14,     ///< Whether a mask lets the path pass.
  USE_BLEND = 15,    ///< Which of the materials of a blend.
  PAIRS_A_VERTEX = 8
};

/// Numbers of the way from each vertex of a light path to the sensor, from pair FIRST_OF_SENSOR on. Vertex 0 is on the
/// light, and there USE_WAY is the direction in which the path sets out, or the place where it enters the scene.
enum {
  USE_SENSOR_LENS = 0,   ///< The place on the lens.
  USE_SENSOR_PIXEL = 2,  ///< Which of the pixels whose filters reach there.
  PAIRS_A_SENSOR_WAY = 2
};

/// What has no bound, masks and blends in a row and places where a medium may scatter, draws from a stream of each
/// sample's own, beyond the sets of all vertices. Those of shadow rays begin so far behind that of the path, and so far
/// apart from vertex to vertex; those of blends lie beside that of the path, so far behind its next number, and as far
/// apart from vertex to vertex. Of masks and blends behind surfaces that are ignored, which have no depth of their own,
/// the vertex stands so far behind that one for each of them.
///
/// The places where these and FIRST_OF_SENSOR begin have ones among their low bits: two numbers of the hash
/// (math/rng_lanes.h) whose dimensions differ in the highest bits alone depend on each other (cl_test_math).
#define STREAM_BEGIN 0x9e3779b9u
#define STREAM_SHADOWS 0x7f4a7c15u
#define STREAM_SHADOWS_STEP 0x85ebca6bu
#define STREAM_BLENDS 0x27d4eb2fu
#define IGNORED_STEP 0xc2b2ae35u
#define FIRST_OF_SENSOR 0xb5297a4du

#endif

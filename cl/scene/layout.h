// SPDX-License-Identifier: MIT
// Where things stand in the three buffers of a scene. The host packs by this file and the kernels read by it.
//
//   geometry  reals: per kind of shape, blocks of planes x LANES; the tree's boxes
//   shading   reals: camera, filter table, frames, vertex attributes, radiances, material and light parameters
//   index     ints:  header, one row a kind of shape, ids, tables. Offsets count elements of the buffer they point
//   into.
#ifndef STRAHL_SCENE_LAYOUT_H
#define STRAHL_SCENE_LAYOUT_H

enum {
  HEADER_WIDTH,  // pixels of a row of the whole picture
  HEADER_SEED,
  HEADER_SUMS,        // The film's sums of a pixel, FILM_SUBSUMS or 1, ...
  HEADER_SEQUENCES,   // ... the number of sample sequences, ...
  HEADER_TURN_BITS,   // ... and log2 of the run of a sequence's points that go into one sum (film/sub_sums.h).
  HEADER_FILM_ROWS,   // Rows of the film, of which a launch renders a part.
  HEADER_INTEGRATOR,  // INTEGRATOR_direct, ...
  HEADER_MAX_DEPTH,   // -1: no limit
  HEADER_LAST_DEPTH,  // Rays with so many surfaces before them only look for emission, ...
  HEADER_GLOWING,     // ... which is in boxes -> shading, lo x y z, hi x y z each, ...
  HEADER_GLOWING_COUNT,
  HEADER_RR_DEPTH,  // Surfaces after which Russian roulette begins.
  HEADER_HIDE_EMITTERS,
  HEADER_STRICT_NORMALS,
  HEADER_SAMPLER,       // SAMPLER_independent, ...
  HEADER_CAMERA,        // -> shading
  HEADER_SENSOR,        // -> shading, SENSOR_REALS and a table, where light paths end on the sensor; else -1
  HEADER_FILTER,        // -> shading, FILTER_CELLS + 1 quantiles: |offset| beyond which (i / FILTER_CELLS)^2 lies
  HEADER_TAPS,          // -> shading, TAP_TERMS reals for each tap from -HEADER_TAP_REACH to HEADER_TAP_REACH, ...
  HEADER_TAP_SIDES,     // ... 1: of any offset; 2: of those below 0, and behind them of the others.
  HEADER_TAP_REACH,     // Pixels between one and the farthest whose samples count in it; 0: only its own do.
  HEADER_PARTS,         // -> index, PART_INTS a part
  HEADER_MATERIALS,     // -> index, MATERIAL_INTS a material
  HEADER_TEXTURES,      // -> index, TEXTURE_INTS a texture
  HEADER_LIGHTS,        // -> index, LIGHT_INTS a light
  HEADER_LIGHT_COUNT,   // Of those that are taken or drawn; behind them come those that rays only find.
  HEADER_LIGHTS_TAKEN,  // Number of lights that every surface takes; one of the others is drawn.
  HEADER_CHOOSER,       // CHOOSER_uniform, ...: how that one is chosen, ...
  HEADER_CHOICES,       // ... -> index, and ...
  HEADER_CHANCES,       // ... -> shading: what it reads, as its file says.
  HEADER_MOST_ITEMS,    // The most items of any light; 0: no area lights.
  HEADER_BACKGROUND,    // The light that is seen by rays that leave the scene; -1: none.
  HEADER_SUN,           // The sun before it; -1: none.
  HEADER_GLOWS,         // 1: rays may hit emission, of a surface or the background.
  HEADER_REACH,         // -> shading, 1 real: how far ambient occlusion looks.
  HEADER_ROOT,          // reference (below); NO_REFERENCE: no tree
  HEADER_NODES,         // -> geometry, NODE_PLANES x TREE_WIDTH reals a node
  HEADER_CHILDREN,      // -> index, TREE_WIDTH references a node
  HEADER_BOUNDS,        // -> geometry, centre x y z and half the size x y z of a box around everything bounded
  HEADER_INTS
};

// Row of a kind of shape, at HEADER_INTS + SHAPE_x * SHAPE_INTS. The ids are followed by the part of every slot.
// SHAPE_LISTED: blocks that every ray is tested against, all or none; the others are leaves of the tree.
// Programs with instances have one row more, at SHAPE_COUNT: a block is an instance of INSTANCE_REALS, in the scene's
// order; its "ids" -> index, the row of its group.
enum { SHAPE_BLOCKS, SHAPE_GEOMETRY, SHAPE_IDS, SHAPE_LISTED, SHAPE_INTS };

// A reference is a node (>= 0) or ~(block << REFERENCE_BLOCK | count << REFERENCE_COUNT | kind), a leaf of `count`
// blocks of a kind from `block` on. count 0: all that the kind lists, of instances from `block` on. Kind SHAPE_COUNT:
// an instance.
enum { REFERENCE_COUNT = 4, REFERENCE_BLOCK = 7, REFERENCE_MOST_KINDS = 16, REFERENCE_MOST_BLOCKS = 7 };
#define NO_REFERENCE (-0x7fffffff - 1)

// Planes of a node: lo_x, hi_x, lo_y, hi_y, lo_z, hi_z of its children.
enum { NODE_PLANES = 6 };

// A placed group: the box around it, as a node has its planes; p in the group's frame = TO_GROUP (p - PIVOT) + OFFSET,
// with TO_WORLD the inverse; what mapping rounds, in units of the roundoff and of the world's length
// (docs/decisions/0009-instances.md); lengths in the group's frame per length in the world, at the least.
enum {
  INSTANCE_BOX = 0,
  INSTANCE_PIVOT = 6,
  INSTANCE_TO_GROUP = 9,
  INSTANCE_OFFSET = 18,
  INSTANCE_TO_WORLD = 21,
  INSTANCE_ERROR = 30,
  INSTANCE_SHRINK = 31,
  INSTANCE_REALS = 32
};

// Row of a group: the reference of its tree or NO_REFERENCE; -> geometry, its bounds as at HEADER_BOUNDS, in its frame;
// then for every kind of shape the first block that the group lists, and the number of blocks.
enum { GROUP_ROOT, GROUP_BOUNDS, GROUP_LISTED };

// Entries of the stack that a traversal keeps, per width of the tree; the host builds trees that need no more.
enum { STACK_2 = 64, STACK_4 = 96, STACK_8 = 128, STACK_16 = 192 };

enum {
  PART_SHAPE,       // number in file order, behind the scene's own those of its groups
  PART_FIRST_ID,    // scene-wide id of the shape's primitive 0
  PART_MATERIAL,    // row of the material table
  PART_RADIANCE,    // -> shading, r g b; -1: does not emit
  PART_GLOW,        // The row of the table of textures that multiplies it; -1: none.
  PART_LIGHT,       // Its row in the table of lights; -1: no light that could be drawn.
  PART_FLIP,        // 1: the normal is reversed
  PART_AXES,        // -> shading, 9 reals, meaning by kind; -1: none
  PART_NORMALS,     // -> shading, 9 reals a primitive of the shape; -1: none
  PART_UVS,         // -> shading, 6 reals a primitive of the shape; -1: none
  PART_ATTRIBUTES,  // -> index, what textures/mesh_attribute_lanes.h reads; -1: none
  PART_UV_RATES,    // -> shading, 2 reals: change of tex_u and tex_v per unit of length; -1: no textures
  PART_RANK,        // Rank among the shapes with a priority, the lowest 0; -1: it has no priority.
  PART_INTS
};

// From MATERIAL_SLOTS on a slot a parameter: >= 0: -> shading, 3 reals; else ~ row of the texture table. Those that the
// material does not have are 0, which may be read. MATERIAL_BACK: the row of what is seen from behind; -1: nothing.
// MATERIAL_ALONG: 1: its frame has x where u grows. MATERIAL_OPACITY: a slot, defined only in programs with MASK.
// MATERIAL_FIRST, MATERIAL_SECOND: rows that a blend draws from, its weight in the first slot; of a relief
// (materials/relief_lanes.h) the row inside it, and -1; of a coat (materials/coat_lanes.h) that and -2; else both -1.
// MATERIAL_INDICES: INDICES_OF_METAL: its second and third slot are eta and k; INDICES_OF_GLASS: its third slot holds
// the ratio of the indices inside and outside, and the two.
enum { MATERIAL_MOST_SLOTS = 13 };
enum { INDICES_OF_METAL = 1, INDICES_OF_GLASS = 2 };
enum {
  MATERIAL_KIND,
  MATERIAL_BACK,
  MATERIAL_ALONG,
  MATERIAL_OPACITY,
  MATERIAL_FIRST,
  MATERIAL_SECOND,
  MATERIAL_INDICES,
  MATERIAL_SLOTS,
  MATERIAL_INTS = MATERIAL_SLOTS + MATERIAL_MOST_SLOTS
};
// TEXTURE_IMAGE of a mesh_attribute: which one (textures/mesh_attribute_lanes.h).
// TEXTURE_IMAGE to TEXTURE_LEVELS are a bitmap's: -> index, IMAGE_INTS a level; FILTER_...; WRAP_...; the number of
// levels, each half as wide and high as the one before. TEXTURE_FILTER of a checkerboard: by how much its filter is
// narrower than a pixel; INT_MAX: it has none.
enum { TEXTURE_KIND, TEXTURE_REALS, TEXTURE_IMAGE, TEXTURE_FILTER, TEXTURE_WRAP, TEXTURE_LEVELS, TEXTURE_INTS };
enum { FILTER_BILINEAR, FILTER_NEAREST };
enum { WRAP_REPEAT, WRAP_MIRROR, WRAP_CLAMP };
// An image: TEXELS_...; its texels, -> index, of TEXELS_..._REAL -> shading, and after those one real more; what codes
// of 8 and 16 bits mean, -> shading, 256 or 65536 reals. Rows from the top.
enum { IMAGE_WIDTH, IMAGE_HEIGHT, IMAGE_FORMAT, IMAGE_TEXELS, IMAGE_TABLE, IMAGE_INTS };
// Codes from the low bits of an int on: GREY_8 four texels an int, GREY_16 and GREY_HALF two; RGB_8 and RGBE (whose
// last byte is an exponent) an int a texel, RGB_16 and RGB_HALF two, with blue alone in the second.
enum {
  TEXELS_GREY_8,
  TEXELS_GREY_16,
  TEXELS_GREY_HALF,
  TEXELS_GREY_REAL,
  TEXELS_RGB_8,
  TEXELS_RGB_16,
  TEXELS_RGB_HALF,
  TEXELS_RGB_REAL,
  TEXELS_RGBE
};
// LIGHT_AREA to LIGHT_FIRST_ID are an area light's: AREA_sphere, ...; number of items; -> index, CHOICE_INTS an item;
// scene-wide id of item 0 where the items are primitives in order, else -1. LIGHT_TEXTURE: the row of the table of
// textures that multiplies its colour; -1: none. LIGHT_UVS: of an area light with a texture, -> shading, what texture
// coordinates of its places follow from (the area's file says how). LIGHT_PART: an area light's row of the part table.
// LIGHT_ALIKE: the first light whose parameters lie as this one's do: with the same kind and area, of one item, without
// a texture; this one where there is none.
enum {
  LIGHT_KIND,
  LIGHT_REALS,
  LIGHT_AREA,
  LIGHT_ITEMS,
  LIGHT_CHOICE,
  LIGHT_FIRST_ID,
  LIGHT_TEXTURE,
  LIGHT_UVS,
  LIGHT_PART,
  LIGHT_ALIKE,
  LIGHT_INTS
};
// Of an environment: -> index, IMAGE_INTS; LIGHT_CHOICE leads to a table of the rows of cells, and from there on one of
// the cells of each row.
enum { LIGHT_IMAGE = LIGHT_AREA };
// One of n items by a number of 32 bits (lights/choice_lanes.h). Item i: the last number that leads to it or to an item
// before it. Part i of the numbers, which are in n equal parts: the item that its first number leads to.
enum { CHOICE_LAST, CHOICE_GUIDE, CHOICE_INTS };
// A child of the tree of lights: the middle of the ball around its lights, x y z; the axis of the cone of their own
// axes; their greatest intensities in sum (of lights infinitely far away the irradiances); the ball's radius, squared
// (-1: infinitely far away); cosines of the cone's half angle and of the greatest angle from a light's axis at which
// it shines. A node has two children, the root first. Ints: each light's way from the root, from the low bit on (1: the
// right child); then two links a node: a node, or -1 less a light.
enum {
  LIGHT_CHILD_MIDDLE = 0,
  LIGHT_CHILD_AXIS = 3,
  LIGHT_CHILD_STRENGTH = 6,
  LIGHT_CHILD_RADIUS2 = 7,
  LIGHT_CHILD_COS_SPREAD = 8,
  LIGHT_CHILD_COS_CUTOFF = 9,
  LIGHT_CHILD_REALS = 10,
  LIGHT_TREE_DEPTH = 32  // Nodes on a way, at most.
};
// Reals of an area light: radiance r g b, one over its area, +1 or -1 (emits outwards, inwards), then its items.
enum { AREA_RADIANCE = 0, AREA_INVERSE = 3, AREA_SIDE = 4, AREA_ITEMS = 5 };
// Reals of an environment: its axes in the world, x y z each; what its texels are multiplied by, r g b; the luminance
// that is not drawn; of each row of cells the density of a direction per luminance, times the sine of its angle from
// the pole.
enum { ENVMAP_AXES = 0, ENVMAP_SCALE = 9, ENVMAP_FLOOR = 12, ENVMAP_ROWS = 13 };

// Camera: origin = O + sx OX + sy OY, direction = D + sx DX + sy DY with sx, sy in [-1, 1] across the picture, y down.
enum {
  CAMERA_O = 0,
  CAMERA_OX = 3,
  CAMERA_OY = 6,
  CAMERA_D = 9,
  CAMERA_DX = 12,
  CAMERA_DY = 15,
  CAMERA_NEAR = 18,  // t range in units of that direction
  CAMERA_FAR = 19,
  CAMERA_LENS_U = 20,  // the lens: two of its radii, at right angles
  CAMERA_LENS_V = 23,
  CAMERA_FOCUS = 26,  // one over t where the rays of a place on the picture meet
  CAMERA_REALS = 27
};

enum { FILTER_CELLS = 1024 };

// The pixel filter's weight along an axis of a sample that lies an offset in [-1/2, 1/2] from the middle of the pixel
// that is `tap` pixels further on, in units of 2^-(WEIGHT_BITS / 2): a polynomial, the highest power first.
enum { TAP_TERMS = 8 };

// A sample on its way into the pixels around it (film/sample_ring.h): a plane each.
enum { RING_R, RING_G, RING_B, RING_X, RING_Y, RING_PLANES };

// Weights in the film are integers, in units of 2^-WEIGHT_BITS.
enum { WEIGHT_BITS = 12 };

// The camera the other way round: of a vector v from its origin, SENSOR_T v is t on the ray that leads there, and
// SENSOR_X v and SENSOR_Y v are sx and sy of that ray, times t where rays spread from a point. SENSOR_GAIN: one over
// the volume that the picture's two edges and D span at t = 1 (camera/projection_lanes.h). SENSOR_SPREADS: 1, or 0
// where rays are parallel. SENSOR_HEIGHT: rows of the picture. Then half the width of the pixel filter, and its density
// at FILTER_CELLS + 1 places from one end to the other.
enum {
  SENSOR_T = 0,
  SENSOR_X = 3,
  SENSOR_Y = 6,
  SENSOR_GAIN = 9,
  SENSOR_SPREADS = 10,
  SENSOR_HEIGHT = 11,
  SENSOR_FILTER_HALF = 12,
  SENSOR_REALS = 13
};

// Number of mirrors after which a path ends if HEADER_MAX_DEPTH is -1.
enum { WHITTED_LONGEST = 1024 };
// Number of surfaces of mirrors and glass after which the rays of one sample of whitted no longer split.
enum { WHITTED_MOST_RAYS = 1 << 14 };
// Number of surfaces after which a path ends that only Russian roulette limits. A path survives roulette with
// probability 0.95 at most, so the share of paths that come so far is below 0.95^512 = 4e-12. Roulette divides by that
// probability: the light that is left out is what is reflected more often, much of it where surfaces absorb hardly any.
enum { ROULETTE_LONGEST = 512 };

// Film: FILM_SUBSUMS x 3 sums a pixel (film/sub_sums.h), or 1 x 3, each of FILM_SUM_WORDS words of 64 bits
// (film/film_sum.h), docs/decisions/0002-film.md.
enum { FILM_SUBSUMS = 4, FILM_CHANNELS = 3, FILM_SUM_WORDS = 2 };
// The film of light paths has a word of 64 bits for each of SPLAT_WORDS bins of SPLAT_BITS bits in a sum; the first bin
// begins at 2^-SPLAT_ORIGIN (film/splat.h).
enum { SPLAT_WORDS = 9, SPLAT_BITS = 32, SPLAT_ORIGIN = 148 };

// Paths of a pool (integrators/path_pool_lanes.h): what a work-item of more than one lane follows at a time.
enum { POOL_PATHS = 64 };

// Of sampler sobol where the film keeps FILM_SUBSUMS sums (docs/decisions/0011-error.md).
enum { SOBOL_SEQUENCES = 2 };

// First-sample values of a pixel: depth, shading normal, position, uv, t and the ray that it belongs to (RAY_O ...),
// albedo, geometric normal; shape, primitive.
enum {
  AOV_DEPTH = 0,
  AOV_NORMAL = 1,
  AOV_POSITION = 4,
  AOV_UV = 7,
  AOV_T = 9,
  AOV_RAY = 10,
  AOV_ALBEDO = 18,
  AOV_GEO_NORMAL = 21,
  AOV_REALS = 24
};
enum { AOV_SHAPE, AOV_PRIMITIVE, AOV_INTS };

// COUNT_CUT, COUNT_STUCK: work-items whose loops the device has ended before their last sample, or before their first.
// Only programs with HAS_LOOP_LIMIT have them. There the counters are followed by one number for each pixel of the
// film, or of the ring where pixels share samples: the first sample that is not there yet. Of light paths they are
// DONE_OF_PATHS numbers: that sample, and how many of its splats are in the film.
enum {
  COUNT_SATURATED,
  COUNT_INVALID,
  COUNT_SHADOW,
  COUNT_BOUNCE,
  COUNT_BRANCHES,
  COUNT_LOST_BRANCHES,
  COUNT_INTERFACES,
  COUNT_NODES,
  COUNT_PRIMITIVES,
  COUNT_CUT,
  COUNT_STUCK,
  COUNTERS
};
enum { DONE_SAMPLE, DONE_SPLATS, DONE_OF_PATHS };

// strahl intersect: a ray and a hit. All stand in blocks of LANES rays, a plane of LANES numbers for each of theirs.
enum { RAY_O = 0, RAY_D = 3, RAY_T_MIN = 6, RAY_T_MAX = 7, RAY_REALS = 8 };
enum { HIT_T = 0, HIT_U = 1, HIT_V = 2, HIT_NORMAL = 3, HIT_REALS = 6 };
// The primitive and instance that the ray has left; -1: none.
enum { DEPARTED_ID, DEPARTED_INSTANCE, DEPARTED_INTS };
enum { HIT_INSTANCE, HIT_SHAPE, HIT_PRIMITIVE, HIT_INTS };
// A hit before its surface is computed: Nearest without its t.
enum { FOUND_ID, FOUND_KIND, FOUND_SLOT, FOUND_INSTANCE, FOUND_INTS };
// As the kind of the first ray of a work-item: its hits are invalid, because the device has ended its loops early.
enum { FOUND_CUT = -2 };

#endif

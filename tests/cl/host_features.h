// SPDX-License-Identifier: MIT
// Every feature on, as --generic defines them. No guard needed beyond the unit's own: plain definitions.
#pragma once

#define HAS_PIXEL_FILTER 1
#define HAS_SHARED_SAMPLES 1
#define HAS_THIN_LENS 1
#define HAS_EMISSION 1
#define HAS_SUN 1
#define HAS_LIGHT_TEXTURE 1
#define HAS_STRICT_NORMALS 1
#define HAS_TWOSIDED 1
#define HAS_METAL 1
#define HAS_BECKMANN 1
#define HAS_GGX 1
#define HAS_BLACK 1
#define HAS_COAT 1
#define HAS_TANGENT 1
#define HAS_MASK 1
#define HAS_BLEND 1
#define HAS_RELIEF 1
#define HAS_BRANCHES 1
#define HAS_PRIORITY 1
#if HAS_MEDIA
#define HAS_PANE 1
#define HAS_OPEN_MEDIA 1
#define HAS_UNLIT_MEDIA 1
#else
#define HAS_PANE 0
#define HAS_OPEN_MEDIA 0
#define HAS_UNLIT_MEDIA 0
#endif
#define HAS_LIGHT_PATHS 1
#define HAS_SMOOTH_NORMALS 1
#define HAS_MESH_UVS 1
#define HAS_MESH_ATTRIBUTE 1
#define HAS_TEXTURE_LOD 1
#define HAS_INSTANCES 1
#define HAS_TREE 1
#define HAS_OPENNESS 1
#define HAS_AOV 1
#define HAS_ALBEDO 1
#define HAS_COUNT_RAYS 0
#define HAS_LOOP_LIMIT 0

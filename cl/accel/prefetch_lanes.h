// SPDX-License-Identifier: MIT
// Prefetches the memory that a ray will need. A child that is pushed onto the stack is requested at once, so that it
// has arrived when it is popped: incoherent rays in large scenes are bound by memory latency
// (docs/decisions/0008-tree.md). PoCL's prefetch() does nothing, so a builtin of its compiler is used; on other devices
// nothing happens. Results do not depend on it. One width; no guard.

#if !ON_HOST && LANES != 1 && defined(__clang__) && defined(__x86_64__)
enum { LINE_REALS_w = 64 / sizeof(real) };

FN void prefetch_reals_w(GLOBAL const real* p, int reals) {
  UNROLLED
  for (int i = 0; i < reals; i += LINE_REALS_w) __builtin_prefetch((PRIVATE const void*)(ulong)(p + i));
}
FN void prefetch_ints_w(GLOBAL const int* p) { __builtin_prefetch((PRIVATE const void*)(ulong)p); }
#else
FN void prefetch_reals_w(GLOBAL const real* p, int reals) {
  (void)p;
  (void)reals;
}
FN void prefetch_ints_w(GLOBAL const int* p) { (void)p; }
#endif

FN void prefetch_block_w(const Scene* scene, int kind, ulong block, int reals) {
  GLOBAL const real* blocks = scene->geometry + scene_shape_row(scene, kind)[SHAPE_GEOMETRY];
  prefetch_reals_w(blocks + block * (ulong)reals, reals);
}

/// Prefetches what a reference points to: a node, or the first block of a leaf.
FN void prefetch_child_w(const Scene* scene, GLOBAL const real* nodes, int reference) {
  if (reference >= 0) {
    prefetch_reals_w(nodes + (ulong)reference * (NODE_PLANES * TREE_WIDTH), NODE_PLANES * TREE_WIDTH);
    return;
  }
  uint leaf = (uint)~reference;
  int kind = (int)(leaf & (REFERENCE_MOST_KINDS - 1));
  (void)scene;  // A scene without shapes.
  (void)kind;
#define SHAPE(name, planes) \
  if (kind == SHAPE_##name) prefetch_block_w(scene, kind, leaf >> REFERENCE_BLOCK, (planes)*LANES);
#include "shapes/shapes.def"
#undef SHAPE
}

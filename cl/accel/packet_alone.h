// SPDX-License-Identifier: MIT
// Rays that leave a packet: where few of them are in a subtree, each goes on alone (accel/traverse.h) from there, with
// the nearest hit that it has. A hit that is put off stays so: it is decided with the other rays' at the end. One
// width; no guard.

/// A lane's nearest hit. In the robust tier one that is put off is certainly the nearest.
FN Nearest packet_nearest_w(const Scene* scene, const Packet_w* p, int lane) {
  Nearest n = nearest_none(get_w(&p->bound, lane));
  n.id = get_int_w(&p->id, lane);
  n.kind = get_int_w(&p->kind, lane);
  n.slot = get_int_w(&p->slot, lane);
  n.instance = get_int_w(&p->instance, lane);
#if TIER_ROBUST
  int kind = get_int_w(&p->approximate_kind, lane);
  if (kind < 0) return n;
  n.id = get_int_w(&p->approximate_id, lane);
  n.kind = kind;
  n.slot = get_int_w(&p->approximate_slot, lane);
  n.instance = -1;
  n.t_least = get_w(&p->approximate_least, lane);
  n.approximate = get_w(&p->approximate, lane);
  GLOBAL const real* geometry = scene->geometry + scene_shape_row(scene, kind)[SHAPE_GEOMETRY];
  (void)geometry;
#define SHAPE(name, planes)                                                                   \
  if (kind == SHAPE_##name) {                                                                 \
    n.prim = geometry + (ulong)(n.slot / LANES) * (ulong)((planes)*LANES) + n.slot % LANES;   \
    n.points = PACKET_BODY_##name##_w == PACKET_BODY_TRIANGLE                                 \
                   ? 3                                                                        \
                   : ((int)PACKET_BODY_##name##_w == (int)PACKET_BODY_PARALLELOGRAM ? 4 : 1); \
  }
#include "shapes/shapes.def"
#undef SHAPE
#else
  (void)scene;
#endif
  return n;
}

/// The reverse.
FN void packet_put_w(Packet_w* p, int lane, const Nearest* n) {
#if TIER_ROBUST
  if (n->points != 0) {
    put_w(&p->bound, lane, n->t);
    put_w(&p->approximate, lane, n->approximate);
    put_w(&p->approximate_least, lane, n->t_least);
    put_int_w(&p->approximate_id, lane, n->id);
    put_int_w(&p->approximate_kind, lane, n->kind);
    put_int_w(&p->approximate_slot, lane, n->slot);
    return;
  }
  put_int_w(&p->approximate_kind, lane, -1);
#endif
  packet_put_exact_w(p, lane, n);
}

/// The rays of `active` from a reference on, one by one.
SELDOM_FN void packet_alone_w(const Scene* scene, Packet_w* p, int reference, maskw active) {
#if TIER_ROBUST
  maskw is_held = active & ~lt_int_w(p->approximate_kind, splat_int_w(0));
  if (any_w(is_held & ~lt_w(p->bound, p->t))) packet_settle_w(scene, p);
#endif
  for (uint lanes = bits_w(active); lanes != 0u; lanes &= lanes - 1u) {
    int lane = first_bit(lanes);
    Ray ray = ray_of_w(p->rays, lane);
    Nearest best = packet_nearest_w(scene, p, lane);
    best = walk_w(scene, &ray, reference, best, p->stop_at_first ? FIND_ANY : FIND_NEAREST_PUT_OFF);
    if (p->stop_at_first && best.kind >= 0) {
      best.t = -REAL_MAX;
#if TIER_ROBUST
      best.points = 0;
#endif
    }
    packet_put_w(p, lane, &best);
  }
}

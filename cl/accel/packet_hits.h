// SPDX-License-Identifier: MIT
// The nearest hits of a packet's rays. One width; no guard.

/// One a lane. kind -1: nothing is hit.
typedef struct {
  realw t;
  intw id, kind, slot, instance;
} NearestEach_w;

FN NearestEach_w packet_found_w(const Packet_w* p) {
  NearestEach_w each;
  each.t = p->t;
  each.id = p->id;
  each.kind = p->kind;
  each.slot = p->slot;
  each.instance = p->instance;
  return each;
}

FN Nearest nearest_of_w(const NearestEach_w* each, int lane) {
  Nearest n = nearest_none(get_w(&each->t, lane));
  n.id = get_int_w(&each->id, lane);
  n.kind = get_int_w(&each->kind, lane);
  n.slot = get_int_w(&each->slot, lane);
  n.instance = get_int_w(&each->instance, lane);
  return n;
}

/// A lane's nearest hit, with its exact t.
FN void packet_put_exact_w(Packet_w* p, int lane, const Nearest* n) {
  put_w(&p->t, lane, n->t);
  put_int_w(&p->id, lane, n->id);
  put_int_w(&p->kind, lane, n->kind);
  put_int_w(&p->slot, lane, n->slot);
  put_int_w(&p->instance, lane, n->instance);
  if (n->t < get_w(&p->bound, lane)) put_w(&p->bound, lane, n->t);
}

/// nearest_take in lanes.
FN void packet_take_w(Packet_w* p, maskw hit, realw t, intw id, intw kind, intw slot) {
  maskw is_before = lt_int_w(id, p->id);
  if (HAS_INSTANCES) is_before = is_before | ~lt_int_w(p->instance, splat_int_w(0));
  maskw closer = hit & (lt_w(t, p->t) | (eq_w(t, p->t) & is_before));
  p->t = sel_w(closer, t, p->t);
  p->id = sel_int_w(closer, id, p->id);
  p->kind = sel_int_w(closer, kind, p->kind);
  p->slot = sel_int_w(closer, slot, p->slot);
  if (HAS_INSTANCES) p->instance = sel_int_w(closer, splat_int_w(-1), p->instance);
  p->bound = min_w(p->t, p->bound);
}

/// Lanes that have just left the primitive.
FN maskw packet_departed_w(const Packet_w* p, int id) { return ~nonzero_w(p->departed - splat_int_w(id)); }

/// Of a flat primitive: lanes that have just left it or end on it.
FN maskw packet_end_w(const Packet_w* p, int id) {
  return packet_departed_w(p, id) | ~nonzero_w(p->aim - splat_int_w(id));
}

#if !TIER_ROBUST
FN void packet_settle_w(const Scene* scene, Packet_w* p) {
  (void)scene;
  (void)p;
}

FN void packet_finish_w(const Scene* scene, Packet_w* p, int may_be_approximate) {
  (void)scene;
  (void)p;
  (void)may_be_approximate;
}
#endif

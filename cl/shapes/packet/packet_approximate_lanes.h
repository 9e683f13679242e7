// SPDX-License-Identifier: MIT
// Hits of a packet that are put off, robust tier: the primitive is certainly hit, at a t that is known except for its
// last digits. Each ray keeps the nearest such hit until another hit is so near to it that the order is unknown. Only
// the hits that remain at the end are decided exactly, LANES rays at a time, each with a primitive of its own. One
// width; no guard.

/// Decides what was put off.
SELDOM_FN void packet_settle_w(const Scene* scene, Packet_w* p) {
  PutOff_w put_off;
  put_off.which = ~lt_int_w(p->approximate_kind, splat_int_w(0));
  put_off.kind = p->approximate_kind;
  put_off.slot = p->approximate_slot;
  put_off.approximate = p->approximate;
  realw t = settled_w(scene, p->rays, &put_off);
  packet_take_w(p, put_off.which & le_w(p->t_min, t), t, p->approximate_id, p->approximate_kind, p->approximate_slot);
  p->approximate_kind = splat_int_w(-1);
}

/// Decides the hits that remain at the end. Where an approximate t suffices, polygons that are certainly the nearest
/// stay put off: their t is not below the exact one.
FN void packet_finish_w(const Scene* scene, Packet_w* p, int may_be_approximate) {
  if (may_be_approximate) {
    maskw is_flat = none_w();
#define SHAPE(name, planes)                                                                                  \
  if (PACKET_BODY_##name##_w == PACKET_BODY_TRIANGLE || PACKET_BODY_##name##_w == PACKET_BODY_PARALLELOGRAM) \
    is_flat = is_flat | ~nonzero_w(p->approximate_kind - splat_int_w(SHAPE_##name));
#include "shapes/shapes.def"
#undef SHAPE
    maskw sure = is_flat & lt_w(p->bound, p->t);
    p->t = sel_w(sure, p->bound, p->t);
    p->id = sel_int_w(sure, p->approximate_id, p->id);
    p->kind = sel_int_w(sure, p->approximate_kind, p->kind);
    p->slot = sel_int_w(sure, p->approximate_slot, p->slot);
    p->approximate_kind = sel_int_w(sure, splat_int_w(-1), p->approximate_kind);
    if (HAS_INSTANCES) p->instance = sel_int_w(sure, splat_int_w(-1), p->instance);
  }
  if (any_w(~lt_int_w(p->approximate_kind, splat_int_w(0)))) packet_settle_w(scene, p);
}

/// Puts hits off: t is about `approximate` and certainly within least ... most; in the lanes of `sure` it is also
/// certainly after t_min.
FN void packet_put_off_w(const Scene* scene, Packet_w* p, maskw hit, maskw sure, realw approximate, realw least,
                         realw most, intw id, int kind, intw slot) {
  if (p->stop_at_first) {
    maskw met = hit & sure & lt_w(most, p->bound);
    p->kind = sel_int_w(met, splat_int_w(kind), p->kind);
    p->t = sel_w(met, splat_w(-REAL_MAX), p->t);
    p->bound = sel_w(met, splat_w(-REAL_MAX), p->bound);
    hit = hit & ~met;
    if (!any_w(hit)) return;
  }
  maskw is_held = ~lt_int_w(p->approximate_kind, splat_int_w(0)), unsure = hit & ~sure;
  // The hit held so far is certainly behind the new one, or is replaced by an exact answer.
  if (any_w(unsure | (hit & is_held & ~lt_w(most, p->approximate_least)))) packet_settle_w(scene, p);
  p->approximate = sel_w(hit, approximate, p->approximate);
  p->approximate_least = sel_w(hit, least, p->approximate_least);
  p->approximate_id = sel_int_w(hit, id, p->approximate_id);
  p->approximate_kind = sel_int_w(hit, splat_int_w(kind), p->approximate_kind);
  p->approximate_slot = sel_int_w(hit, slot, p->approximate_slot);
  p->bound = sel_w(hit & sure & lt_w(most, p->bound), most, p->bound);
  if (any_w(unsure)) packet_settle_w(scene, p);
}

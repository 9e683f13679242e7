// SPDX-License-Identifier: MIT
// Hits of a packet that are put off, robust tier: a primitive is found to be hit for certain, at a t that is known but
// for its last digits. Each ray keeps the nearest such hit, as long as no other comes too near to it to tell which is
// the nearer; only what is left in the end is decided exactly, LANES rays at a time, each with a primitive of its own.
// One width; no guard.

/// Decides what was put off.
SELDOM_FN void LANED(packet_settle)(const Scene* scene, LANED(Packet) * p) {
  LANED(PutOff) put_off;
  put_off.which = ~lt_int_w(p->rough_kind, splat_int_w(0));
  put_off.kind = p->rough_kind;
  put_off.slot = p->rough_slot;
  put_off.rough = p->rough;
  realw t = LANED(settled)(scene, p->rays, &put_off);
  LANED(packet_take)(p, put_off.which & le_w(p->t_min, t), t, p->rough_id, p->rough_kind, p->rough_slot);
  p->rough_kind = splat_int_w(-1);
}

/// What is left in the end. Where t may be rough, polygons that are the nearest for certain stay put off: t is not
/// below what it will be.
FN void LANED(packet_finish)(const Scene* scene, LANED(Packet) * p, int may_be_rough) {
  if (may_be_rough) {
    maskw is_flat = none_w();
#define SHAPE(name, planes)                                                                                        \
  if (LANED(PACKET_BODY_##name) == PACKET_BODY_TRIANGLE || LANED(PACKET_BODY_##name) == PACKET_BODY_PARALLELOGRAM) \
    is_flat = is_flat | ~nonzero_w(p->rough_kind - splat_int_w(SHAPE_##name));
#include "shapes/shapes.def"
#undef SHAPE
    maskw sure = is_flat & lt_w(p->bound, p->t);
    p->t = sel_w(sure, p->bound, p->t);
    p->id = sel_int_w(sure, p->rough_id, p->id);
    p->kind = sel_int_w(sure, p->rough_kind, p->kind);
    p->slot = sel_int_w(sure, p->rough_slot, p->slot);
    p->rough_kind = sel_int_w(sure, splat_int_w(-1), p->rough_kind);
    if (HAS_INSTANCES) p->instance = sel_int_w(sure, splat_int_w(-1), p->instance);
  }
  if (any_w(~lt_int_w(p->rough_kind, splat_int_w(0)))) LANED(packet_settle)(scene, p);
}

/// Puts off: hit at `rough`, for certain within least ... most; `sure` lanes of them also after t_min.
FN void LANED(packet_put_off)(const Scene* scene, LANED(Packet) * p, maskw hit, maskw sure, realw rough, realw least,
                              realw most, intw id, int kind, intw slot) {
  if (p->stop_at_first) {
    maskw met = hit & sure & lt_w(most, p->bound);
    p->kind = sel_int_w(met, splat_int_w(kind), p->kind);
    p->t = sel_w(met, splat_w(-REAL_MAX), p->t);
    p->bound = sel_w(met, splat_w(-REAL_MAX), p->bound);
    hit = hit & ~met;
    if (!any_w(hit)) return;
  }
  maskw is_held = ~lt_int_w(p->rough_kind, splat_int_w(0)), unsure = hit & ~sure;
  // What is held comes after the new one for certain, or gives way to an exact answer.
  if (any_w(unsure | (hit & is_held & ~lt_w(most, p->rough_least)))) LANED(packet_settle)(scene, p);
  p->rough = sel_w(hit, rough, p->rough);
  p->rough_least = sel_w(hit, least, p->rough_least);
  p->rough_id = sel_int_w(hit, id, p->rough_id);
  p->rough_kind = sel_int_w(hit, splat_int_w(kind), p->rough_kind);
  p->rough_slot = sel_int_w(hit, slot, p->rough_slot);
  p->bound = sel_w(hit & sure & lt_w(most, p->bound), most, p->bound);
  if (any_w(unsure)) LANED(packet_settle)(scene, p);
}

// SPDX-License-Identifier: MIT
// Instances in lanes: accel/instance.h for a packet, by the same operations. One width; no guard.

#include "accel/instance_lanes.h"

/// Where a packet is within an instance, and the state of the world that it returns to.
typedef struct {
  int instance;
  int floor;           ///< Height of the stack at which the instance's own entries begin.
  realw enter, leave;  ///< Where each ray is within the instance's box.
  GLOBAL const int* group;
  Rays_w rays;  ///< In the group's frame.
} PacketPlace_w;

/// enter_instance for the rays of `active`; 0: none can hit it. to: receives the packet in the group's frame.
SELDOM_FN int packet_enter_w(const Scene* scene, Packet_w* p, int reference, maskw active, int floor,
                             PacketPlace_w* place, Packet_w* to) {
  int instance = leaf_first(reference);
  // An empty child of a node is an empty list.
  if (leaf_is_list(reference) && instance >= scene_shape_row(scene, SHAPE_COUNT)[SHAPE_LISTED]) return 0;
  GLOBAL const real* placed = instance_reals(scene, instance);
  Interval_w span;
  span.enter = p->t_min;
  span.leave = splat_w(REAL_MAX);
  span = within_box_each_w(p, placed + INSTANCE_BOX, 1, span);
  maskw which = active & le_w(span.enter, span.leave) & ~lt_w(p->bound, span.enter);
  if (!any_w(which)) return 0;
  place->instance = instance;
  place->floor = floor;
  place->enter = span.enter;
  place->leave = span.leave;
  place->group = instance_group(scene, instance);
  // As in enter_instance, up to `bound`, because t of what is put off is not known yet: packet_leave_w drops what lies
  // beyond t.
  realw limit = sel_w(lt_w(p->bound, span.leave), p->bound, splat_w(REAL_MAX));
  intw none = splat_int_w(-1);
  maskw is_from = ~nonzero_w(p->rays->departed_instance - splat_int_w(instance));
  intw departed = TIER_FAST ? none : sel_int_w(is_from, p->rays->departed, none);
  InstanceRows_w rows = instance_rows_w(placed);
  real3w o = p->o, d = p->d;
  ray_into_group_w(&rows, &o, &d);
  maskw has_departed = nonzero_w(departed - none);
  rays_make_w(o, d, sel_w(which, p->t_min, splat_w(R(1.0))), sel_w(which, limit, splat_w(-R(1.0))), has_departed,
              &place->rays);
  place->rays.departed = departed;
  place->rays.departed_instance = place->rays.aim = none;
  place->rays.is_outward = p->rays->is_outward;
  widen_rays_w(has_departed, place->rays.planes, scene->geometry + place->group[GROUP_BOUNDS]);
  if (packet_make_w(to, &place->rays, p->stop_at_first)) return 1;
  place->instance = -1;
  return 0;
}

/// leave_instance. from: the packet in the group's frame.
SELDOM_FN void packet_leave_w(const Scene* scene, PacketPlace_w* place, Packet_w* from, Packet_w* p) {
  packet_settle_w(scene, from);
  maskw found = ~lt_int_w(from->kind, splat_int_w(0));
  intw instance = splat_int_w(place->instance);
  place->instance = -1;
  if (!any_w(found)) return;
  packet_settle_w(scene, p);
  realw t = from->t * place->rays.planes[RAY_PLANE_T_FROM_SCALED];
  t = sel_w(lt_w(t, place->enter), place->enter, t);
  t = sel_w(lt_w(place->leave, t), place->leave, t);
  if (p->stop_at_first) t = splat_w(-REAL_MAX);
  maskw is_before = lt_int_w(p->kind, splat_int_w(0)) | lt_int_w(instance, p->instance);
  maskw closer = found & (lt_w(t, p->t) | (eq_w(t, p->t) & is_before));
  p->t = sel_w(closer, t, p->t);
  p->id = sel_int_w(closer, from->id, p->id);
  p->kind = sel_int_w(closer, from->kind, p->kind);
  p->slot = sel_int_w(closer, from->slot, p->slot);
  p->instance = sel_int_w(closer, instance, p->instance);
  p->bound = min_w(p->t, p->bound);
}

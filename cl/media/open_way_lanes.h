// SPDX-License-Identifier: MIT
// Ways to lights that are infinitely far away, through media that have no end. As in Mitsuba such a light shines from
// outside the ball around the scene: what lies beyond twice that ball's radius, or twice the distance from its centre,
// does not count. One width; no guard.

typedef struct {
  real3w from;
  realw length;  ///< Of the way from there, as far as media count.
} OpenWay_w;

FN OpenWay_w open_way_w(const Scene* scene, real3w from) {
  GLOBAL const real* ball = scene->shading + media_table(scene)[MEDIA_BALL];
  realw distance = length3_w(sub3_w(from, splat3_w(load3(ball))));
  OpenWay_w way;
  way.from = from;
  way.length = splat_w(R(2.0)) * max_w(distance, splat_w(ball[BALL_RADIUS]));
  return way;
}

/// Ends the flights that no boundary and no surface ends.
FN void end_flight_w(const OpenWay_w* way, Flight_w* w) {
  realw left = way->length - dot3_w(sub3_w(w->from, way->from), w->d);
  w->length = sel_w(lt_w(w->length, splat_w(REAL_MAX)), w->length, max_w(left, splat_w(R(0.0))));
}

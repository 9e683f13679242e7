// SPDX-License-Identifier: MIT
// What lights may bring to a point, by their strength, distance and direction (A. Conty Estevez, C. Kulla, "Importance
// Sampling of Many Lights with Adaptive Tree Splitting", HPG 2018). Of one light or of several together; layout:
// scene/layout.h, LIGHT_CHILD_....

typedef struct {
  realw cosine, sine;  ///< Of an angle between 0 and pi.
} LightAngle_w;

FN LightAngle_w angle_of_cosine_w(realw cosine) {
  LightAngle_w angle;
  angle.cosine = cosine;
  angle.sine = sqrt_w(max_w(fma_w(-cosine, cosine, splat_w(R(1.0))), splat_w(R(0.0))));
  return angle;
}

/// a - b, at least 0.
FN LightAngle_w angle_beyond_w(LightAngle_w a, LightAngle_w b) {
  maskw is_within = le_w(b.cosine, a.cosine);
  LightAngle_w angle;
  angle.cosine = fma_w(a.cosine, b.cosine, a.sine * b.sine);
  angle.sine = difference_of_products_w(a.sine, b.cosine, a.cosine, b.sine);
  angle.cosine = sel_w(is_within, splat_w(R(1.0)), angle.cosine);
  angle.sine = sel_w(is_within, splat_w(R(0.0)), angle.sine);
  return angle;
}

/// What the lights of a child may bring to a point: strength over the squared distance, less where they shine past it;
/// 0 where none of them can reach it. Within the ball around them, strength over its squared radius.
FN realw light_importance_w(PRIVATE const realw* child, real3w from) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), share = one;
  realw strength = child[LIGHT_CHILD_STRENGTH], radius2 = child[LIGHT_CHILD_RADIUS2];
  real3w away = sub3_w(from, real3_at_w(child + LIGHT_CHILD_MIDDLE));
  realw distance2 = dot3_w(away, away);
  maskw is_everywhere = lt_w(radius2, zero), is_inside = le_w(distance2, radius2);
  distance2 = sel_w(is_inside, radius2, distance2);
  realw cos_spread = child[LIGHT_CHILD_COS_SPREAD];
  maskw is_turned = lt_w(-one, cos_spread) & ~is_inside;
  if (any_w(is_turned)) {
    realw cosine = dot3_w(real3_at_w(child + LIGHT_CHILD_AXIS), away) / sqrt_w(distance2);
    LightAngle_w size = angle_of_cosine_w(sqrt_w(max_w(one - radius2 / distance2, zero)));
    LightAngle_w angle = angle_beyond_w(angle_of_cosine_w(cosine), angle_of_cosine_w(cos_spread));
    angle = angle_beyond_w(angle, size);
    share = max_w(angle.cosine, splat_w(R(0.0625)));
    share = sel_w(lt_w(child[LIGHT_CHILD_COS_CUTOFF], angle.cosine), share, zero);
    share = sel_w(is_turned, share, one);
  }
  return sel_w(is_everywhere, strength, strength * share / distance2);
}

/// Of the whole, where there are near lights too: lights from afar, and near ones, have an eighth of it at least.
FN realw share_afar_w(realw share) {
  realw eighth = splat_w(R(0.125));
  return min_w(max_w(share, eighth), splat_w(R(1.0)) - eighth);
}

// SPDX-License-Identifier: MIT
// From places in the scene to the sensor: the way there, where on the picture it ends, and what light on it is worth.
// The camera's rays (camera/camera_lanes.h) the other way round. One width; no guard.

typedef struct {
  maskw which;     ///< Lanes that the film sees, as far as nothing is in the way.
  real3w towards;  ///< To the sensor: t = 1 is the camera's place.
  realw t_max;     ///< How far along it the way must be free: the camera sees nothing nearer than its near plane.
  realw x, y;      ///< On the picture, in pixels from its upper left corner.
  realw gain;      ///< What a unit of radiance from a unit of area, facing the sensor, adds to the mean of a pixel.
} SensorWay_w;

/// position: in the lanes of `which`; lens: the place on the lens, in radii.
FN SensorWay_w sensor_way_w(const Scene* scene, maskw which, real3w position, Real2_w lens) {
  GLOBAL const real* camera = scene->shading + scene->index[HEADER_CAMERA];
  GLOBAL const real* sensor = scene->shading + scene->index[HEADER_SENSOR];
  PRIVATE const SplatFilm* film = scene->splats;
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), half_one = splat_w(R(0.5));
  int spreads = sensor[SENSOR_SPREADS] > R(0.0);
  real3w from = splat3_w(load3(camera + CAMERA_O)), v = sub3_w(position, from);
  realw t = dot3_w(v, splat3_w(load3(sensor + SENSOR_T)));
  maskw is_before = lt_w(zero, t);
  realw depth = sel_w(is_before, t, one), inverse = one / depth;
  SensorWay_w way;
  real3w across = v, back = negate3_w(v);
  if (HAS_THIN_LENS) {
    // o = O + off, d = d0 - FOCUS off, so that v - off + t FOCUS off = t d0.
    real3w off = scale3_w(lens.x, splat3_w(load3(camera + CAMERA_LENS_U)));
    off = fma3_w(lens.y, splat3_w(load3(camera + CAMERA_LENS_V)), off);
    across = fma3_w(fma_w(depth, splat_w(camera[CAMERA_FOCUS]), -one), off, v);
    back = add3_w(back, off);
  }
  (void)lens;
  realw scale = spreads ? inverse : one;
  realw sx = scale * dot3_w(across, splat3_w(load3(sensor + SENSOR_X)));
  realw sy = scale * dot3_w(across, splat3_w(load3(sensor + SENSOR_Y)));
  if (!spreads) back = scale3_w(-depth, splat3_w(load3(camera + CAMERA_D)));
  realw width = splat_w((real)scene->index[HEADER_WIDTH]), height = splat_w(sensor[SENSOR_HEIGHT]);
  way.x = half_one * fma_w(sx, width, width);
  way.y = half_one * fma_w(sy, height, height);
  realw reach = splat_w(sensor[SENSOR_FILTER_HALF]);
  realw left = splat_w((real)film->x) - reach, top = splat_w((real)film->y) - reach;
  realw right = splat_w((real)(film->x + film->columns)) + reach, low = splat_w((real)(film->y + film->rows)) + reach;
  way.which = which & is_before & lt_w(left, way.x) & lt_w(way.x, right) & lt_w(top, way.y) & lt_w(way.y, low);
  way.which = way.which & le_w(splat_w(camera[CAMERA_NEAR]), t) & le_w(t, splat_w(camera[CAMERA_FAR]));
  way.towards = back;
  way.t_max = one - splat_w(camera[CAMERA_NEAR]) * inverse;
  // |d| of the camera's ray is the distance over t.
  realw length = inverse * length3_w(back);
  // The mean is over the paths of a pixel: the film has as many times more as it has pixels.
  real pixels = (real)scene->index[HEADER_WIDTH] * sensor[SENSOR_HEIGHT],
       paths = (real)film->columns * (real)film->rows;
  way.gain = splat_w(sensor[SENSOR_GAIN] * (pixels / paths)) * length * (spreads ? inverse * inverse : one);
  return way;
}

// SPDX-License-Identifier: MIT
// Light of a clear day: A. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999.
// Radiance in W / (m^2 sr nm), as of Mitsuba's sky: the mean over wavelengths that the CIE 1931 observer's y weighs.
// How far other models are from it: docs/scene-emitters.md, "Sky".
#pragma once

#include <memory>

#include "image/texels.h"
#include "scene/model/vec.h"

namespace strahl {

/// A time at a place on the earth.
struct DayAndPlace {
  int year = 2010, month = 7, day = 10;  ///< month in [1, 12], day in [1, 31].
  double hour = 15;                      ///< Of the time zone, minutes and seconds as its fractions.
  double latitude = 35.6894;             ///< Degrees, north.
  double longitude = 139.6917;           ///< Degrees, east.
  double timezone = 9;                   ///< Hours before Greenwich.
};

/// Towards the sun, unit: east, up, south. Appendix A.6 of the paper, good to some tenths of a degree.
[[nodiscard]] Vec3 direction_of_sun(const DayAndPlace& when);

/// The haze of the air is its turbidity, of which 1 is none at all.
class Sky {
 public:
  /// The model is made for 2 to 10. Below, the value of its distribution at the zenith, by which it divides, passes
  /// through 0, at 1.65.
  static constexpr double least_turbidity = 2;

  /// turbidity: least_turbidity or more. sun: towards it, unit, y up.
  Sky(double turbidity, const Vec3& sun);

  /// Of a direction, unit, y up; black below the horizon, and with the sun below it.
  [[nodiscard]] Rgb radiance(const Vec3& view) const;
  /// Latitude and longitude, as of an environment (cl/lights/envmap_lanes.h).
  [[nodiscard]] std::shared_ptr<const Texels> image(int width) const;

 private:
  struct Perez {
    double a, b, c, d, e;
    [[nodiscard]] double operator()(double cos_zenith, double angle) const;
  };
  struct Channel {
    Perez perez;
    double zenith;  ///< The value at the zenith over perez there.
  };
  Vec3 sun_;
  bool is_day_;
  Channel luminance_, x_, y_;
};

/// Of the sun's disc behind the air: a black body of 5778 K, less what molecules and haze scatter. What ozone and water
/// absorb is left out. 0 below the horizon.
[[nodiscard]] Rgb radiance_of_sun(double turbidity, const Vec3& sun);

}  // namespace strahl

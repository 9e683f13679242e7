// SPDX-License-Identifier: MIT
// Daylight: where the sun stands and how bright sun and sky are beside what Mitsuba 3.9.1 says (sunsky, turbidity 3,
// albedo 0.3), whose model is another one; the parameters of both of its generations; the image.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kinds/light_reach.h"
#include "scene/scene_text.h"
#include "scene/sky/daylight.h"

using namespace strahl;
using namespace strahl::test;

namespace {

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

Vec3 at_elevation(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {0, std::sin(angle), std::cos(angle)};
}

TEST_CASE("the sun stands where Mitsuba has it") {
  // Tokyo, the 10th of July 2010: south, west, up by the hour.
  const std::vector<std::pair<double, Vec3>> told = {{9, {0.09569518, -0.6147862, 0.7828667}},
                                                     {12, {0.23111704, 0.05438877, 0.97140455}},
                                                     {15, {0.05138545, 0.69174796, 0.7203085}},
                                                     {18, {-0.33857894, 0.92423326, 0.17651364}}};
  for (const auto& [hour, direction] : told) {
    DayAndPlace when;
    when.hour = hour;
    const Vec3 sun = direction_of_sun(when);
    INFO(hour);
    CHECK(degrees_between({sun.z, -sun.x, sun.y}, direction) < 0.5);
  }
  // On the equator at an equinox it rises in the east and stands overhead at noon.
  DayAndPlace equator{2010, 3, 22, 12, 0, 0, 0};
  CHECK(degrees_between(direction_of_sun(equator), {0, 1, 0}) < 3);
  equator.hour = 6.2;
  CHECK(degrees_between(direction_of_sun(equator), {1, 0, 0}) < 3);
}

/// Ozone and water, which are left out, take a tenth of it in the green; low light is redder in Mitsuba's.
TEST_CASE("the sun's disc is as bright as Mitsuba's within a fifth") {
  const std::vector<std::pair<double, Rgb>> told = {{30, {20274.44, 15949.582, 10618.099}},
                                                    {45, {21486.57, 17647.955, 12999.033}},
                                                    {60, {21873.312, 18316.104, 14105.949}},
                                                    {90, {22181.02, 18786.312, 14859.581}}};
  for (const auto& [elevation, colour] : told) {
    INFO(elevation);
    const Rgb sun = radiance_of_sun(3, at_elevation(elevation));
    CHECK(luminance(sun) == Approx(luminance(colour)).epsilon(0.2));
    CHECK(sun.r / luminance(sun) == Approx(colour.r / luminance(colour)).epsilon(0.12));
  }
  CHECK(radiance_of_sun(3, {1, -0.01, 0}) == Rgb{0, 0, 0});
  CHECK(luminance(radiance_of_sun(6, at_elevation(30))) < 0.8 * luminance(radiance_of_sun(2, at_elevation(30))));
}

/// Preetham's zenith by the paper's own formula, and the shape: brighter to the sun, bluest away from it.
TEST_CASE("the sky is that of the paper") {
  const double t = 3, theta = std::numbers::pi / 4;
  const Sky sky(t, at_elevation(45));
  const double chi = (4.0 / 9 - t / 120) * (std::numbers::pi - 2 * theta);
  const double zenith = 1000 * ((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192) / (683 * 106.857);
  CHECK(luminance(sky.radiance({0, 1, 0})) == Approx(zenith).epsilon(1e-3));
  const Rgb near = sky.radiance(at_elevation(50)), across = sky.radiance(normalized({0, 1, -1}));
  CHECK(luminance(near) > 3 * luminance(across));
  CHECK(across.b > 1.5 * across.r);
  CHECK(sky.radiance({0, -1e-3, 1}) == Rgb{0, 0, 0});
  CHECK(Sky(t, {1, -0.1, 0}).radiance({0, 1, 0}) == Rgb{0, 0, 0});
}

TEST_CASE("a sunsky is an image of the sky and a disc that is no part of it") {
  const std::string body = "<emitter type=\"sunsky\"><vector name=\"sun_direction\" value=\"0.6, 0, 0.8\"/></emitter>";
  const LoadedScene loaded = load_body(body);
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.lights.size() == 2);
  const auto sun = std::get<SunLight>(loaded.scene.lights[0].emitter);
  const auto sky = std::get<EnvironmentLight>(loaded.scene.lights[1].emitter);
  CHECK(degrees_between(sun.direction, {0.6, 0, 0.8}) < 1e-9);
  CHECK(sun.aperture_degrees == 0.5358);
  CHECK(sun.up == Vec3{0, 0, 1});
  CHECK(sky.axes[1] == Vec3{0, 0, 1});
  // The brightest texel is next to the sun, and as bright as the sky there.
  const TexelDecoder decoded(*sky.texels, sky.curve);
  std::size_t brightest = 0;
  for (std::size_t n = 0; n < sky.texels->count(); ++n)
    if (decoded(n)[1] > decoded(brightest)[1]) brightest = n;
  const double theta = std::numbers::pi * static_cast<double>(brightest / 512) / 256;
  const double phi = 2 * std::numbers::pi * (static_cast<double>(brightest % 512) + 0.5) / 512;
  const Vec3 way = std::sin(phi) * std::sin(theta) * sky.axes[0] + std::cos(theta) * sky.axes[1] +
                   -std::cos(phi) * std::sin(theta) * sky.axes[2];
  CHECK(degrees_between(way, sun.direction) < 2);
  CHECK(decoded(brightest)[1] < 10);
}

TEST_CASE("a sky turned by a matrix with four digits has the nearest rotation") {
  const auto lights =
      load_body(
          "<emitter type=\"sunsky\"><transform name=\"to_world\"><matrix value=\"1 0 0 0 0.7071 -0.7071 "
          "0 0.7071 0.7071\"/></transform></emitter>")
          .scene.lights;
  const auto sky = std::get<EnvironmentLight>(lights.at(1).emitter);
  CHECK(length(sky.axes[1] - Vec3{0, -std::sqrt(0.5), std::sqrt(0.5)}) < 1e-15);
}

TEST_CASE("daylight has the parameters of Mitsuba 3 and of 0.x") {
  const auto old = [](const std::string& body) {
    return load_text("<scene version=\"0.6.0\">" + body + "<sensor type=\"perspective\"/></scene>").scene.lights;
  };
  const std::string up = "<vector name=\"sunDirection\" x=\"0\" y=\"1\" z=\"0.5\"/>";
  const std::vector<Light> both =
      old("<emitter type=\"sunsky\">" + up + "<float name=\"sunRadiusScale\" value=\"4\"/></emitter>");
  REQUIRE(both.size() == 2);
  const auto wide = std::get<SunLight>(both[0].emitter);
  CHECK(degrees_between(wide.direction, {0, 1, 0.5}) < 1e-9);
  CHECK(wide.aperture_degrees == Approx(4 * 0.5358));
  CHECK(std::get<EnvironmentLight>(both[1].emitter).axes[1] == Vec3{0, 1, 0});
  const auto plain = std::get<SunLight>(old("<emitter type=\"sun\">" + up + "</emitter>").at(0).emitter);
  CHECK(wide.radiance.g * 16 == Approx(plain.radiance.g).epsilon(1e-3));  // Of the same power.
  const auto point = old("<emitter type=\"sun\">" + up + "<float name=\"sunRadiusScale\" value=\"0\"/></emitter>");
  const double solid_angle = std::numbers::pi * std::pow(0.5358 / 2 * std::numbers::pi / 180, 2);
  CHECK(std::get<DirectionalLight>(point.at(0).emitter).irradiance.g ==
        Approx(plain.radiance.g * solid_angle).epsilon(1e-3));
  const auto sky = old("<emitter type=\"sky\">" + up + "<float name=\"scale\" value=\"3\"/></emitter>");
  CHECK(std::get<EnvironmentLight>(sky.at(0).emitter).scale == Rgb{3, 3, 3});
  const LoadedScene night = load_body("<emitter type=\"sunsky\"><float name=\"hour\" value=\"1\"/></emitter>");
  REQUIRE(night.warnings.size() == 1);
  CHECK(night.scene.lights.size() == 1);
}

TEST_CASE("every number of a time and a place counts") {
  const auto number = [](const std::string& type, const std::string& name, double value) {
    return "<" + type + " name=\"" + name + "\" value=\"" + std::to_string(value) + "\"/>";
  };
  const auto lights = [](const std::string& inside) {
    return load_body("<emitter type=\"sunsky\">" + inside + "</emitter>").scene.lights;
  };
  const auto day = [](int year, int month, int number_of_day) {
    return "<integer name=\"year\" value=\"" + std::to_string(year) + "\"/><integer name=\"month\" value=\"" +
           std::to_string(month) + "\"/><integer name=\"day\" value=\"" + std::to_string(number_of_day) + "\"/>";
  };
  const std::string place =
      number("float", "latitude", 48.1) + number("float", "longitude", 11.6) + number("float", "timezone", 2);
  const auto sun = [&](const std::string& inside) {
    const Vec3 towards = std::get<SunLight>(lights(inside).at(0).emitter).direction;
    return Vec3{-towards.y, towards.z, towards.x};  // East, up, south of south, west, up.
  };
  const DayAndPlace when{2024, 5, 3, 9.5125, 48.1, 11.6, 2};
  const std::string at = number("float", "hour", 9) + number("float", "minute", 30) + number("float", "second", 45);
  CHECK(degrees_between(sun(day(2024, 5, 3) + at + place), direction_of_sun(when)) < 1e-3);
  // Munich, the 3rd of May 2024, 9:30:45 of summer time: 38 degrees high in the east-south-east.
  CHECK(std::asin(direction_of_sun(when).y) * 180 / std::numbers::pi == Approx(36).margin(3));
  for (const DayAndPlace& other :
       {DayAndPlace{2023, 5, 3, 9.5125, 48.1, 11.6, 2}, DayAndPlace{2024, 6, 3, 9.5125, 48.1, 11.6, 2},
        DayAndPlace{2024, 5, 13, 9.5125, 48.1, 11.6, 2}, DayAndPlace{2024, 5, 3, 9.6, 48.1, 11.6, 2},
        DayAndPlace{2024, 5, 3, 9.5125, 11.6, 48.1, 2}, DayAndPlace{2024, 5, 3, 9.5125, 48.1, 11.6, 1}})
    CHECK(degrees_between(direction_of_sun(when), direction_of_sun(other)) > 0.01);
  const std::vector<Light> wide = lights(number("float", "sun_aperture", 2) + number("float", "sky_scale", 5));
  CHECK(std::get<SunLight>(wide.at(0).emitter).aperture_degrees == 2);
  CHECK(std::get<EnvironmentLight>(wide.at(1).emitter).scale == Rgb{5, 5, 5});
}

TEST_CASE("days that no calendar has are errors that name the range") {
  const auto fault = [](const std::string& name, const std::string& value) {
    const std::vector<std::string> found = problems(
        around("<emitter type=\"sunsky\">\n<integer name=\"" + name + "\" value=\"" + value + "\"/></emitter>"));
    REQUIRE(found.size() == 1);
    return found[0];
  };
  CHECK(fault("month", "0") == "3:1: error: \"month\" is 0; it must lie in [1, 12]");
  CHECK(fault("month", "13") == "3:1: error: \"month\" is 13; it must lie in [1, 12]");
  CHECK(fault("day", "0") == "3:1: error: \"day\" is 0; it must lie in [1, 31]");
  CHECK(fault("day", "2147483647") == "3:1: error: \"day\" is 2147483647; it must lie in [1, 31]");
}

/// Mitsuba: local_sun_dir = to_world.inverse() * sun_direction; to_world turns the sky around a sun that stays.
TEST_CASE("sun_direction is of the world, a sun of a time is turned with the sky") {
  const std::string turn = "<transform name=\"to_world\"><rotate x=\"1\" angle=\"60\"/></transform>";
  const auto lights = [](const std::string& body) {
    return load_body("<emitter type=\"sunsky\">" + body + "</emitter>").scene.lights;
  };
  const auto sun = [](const std::vector<Light>& all) { return std::get<SunLight>(all.at(0).emitter).direction; };
  const std::string given = "<vector name=\"sun_direction\" value=\"0, -0.6, 0.8\"/>";
  const std::vector<Light> turned = lights(given + turn), straight = lights(given);
  CHECK(degrees_between(sun(turned), {0, -0.6, 0.8}) < 1e-9);
  CHECK(degrees_between(sun(straight), {0, -0.6, 0.8}) < 1e-9);
  CHECK(degrees_between(std::get<EnvironmentLight>(turned.at(1).emitter).axes[1], {0, -std::sqrt(0.75), 0.5}) < 1e-9);
  // In the turned sky it stands higher, and so it is brighter.
  CHECK(std::get<SunLight>(turned[0].emitter).radiance.b > std::get<SunLight>(straight[0].emitter).radiance.b);
  const std::string at_three = "<float name=\"hour\" value=\"15\"/>";
  CHECK(degrees_between(sun(lights(at_three)), sun(lights(at_three + turn))) > 30);
  // Below the world's horizon, above the turned sky's; and the other way round.
  CHECK(lights("<vector name=\"sun_direction\" value=\"0, -1, -0.1\"/>" + turn).size() == 2);
  CHECK(lights("<vector name=\"sun_direction\" value=\"0, 1, 0.1\"/>" + turn).size() == 1);
  const std::vector<Light> old =
      load_text(
          "<scene version=\"0.6.0\"><emitter type=\"sun\"><vector name=\"sunDirection\" x=\"0\" y=\"1\" "
          "z=\"0.5\"/><transform name=\"toWorld\"><rotate x=\"1\" angle=\"30\"/></transform></emitter>"
          "<sensor type=\"perspective\"/></scene>")
          .scene.lights;
  CHECK(degrees_between(sun(old), {0, 1, 0.5}) < 1e-9);
}

TEST_CASE("below a turbidity of 2 the sky is that of 2, and the sun that of the turbidity") {
  const auto load = [](const std::string& type, const std::string& turbidity) {
    return load_text("<scene version=\"0.6.0\"><emitter type=\"" + type + "\"><float name=\"turbidity\" value=\"" +
                     turbidity + "\"/></emitter><sensor type=\"perspective\"/></scene>");
  };
  const auto texels = [&](const std::string& turbidity) {
    return std::get<EnvironmentLight>(load("sky", turbidity).scene.lights.at(0).emitter).texels->reals;
  };
  for (const char* low : {"1", "1.5", "1.7"}) CHECK(texels(low) == texels("2"));
  const LoadedScene low = load("sky", "1.5");
  REQUIRE(low.warnings.size() == 1);
  CHECK_THAT(low.warnings[0].message, Catch::Contains("a turbidity of 2 on") && Catch::Contains("in place of 1.5"));
  CHECK(load("sky", "2").warnings.empty());
  const auto sun = [&](const std::string& turbidity) {
    const LoadedScene loaded = load("sun", turbidity);
    CHECK(loaded.warnings.empty());
    return std::get<SunLight>(loaded.scene.lights.at(0).emitter).radiance.g;
  };
  CHECK(sun("1.5") > sun("2"));
}

TEST_CASE("a turbidity that is refused is not taken for another as well") {
  for (const char* wrong : {"0.5", "-1", "11"}) {
    const std::vector<std::string> found = problems(
        around("<emitter type=\"sunsky\"><float name=\"turbidity\" value=\"" + std::string(wrong) + "\"/></emitter>"));
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0], Catch::Contains("error: turbidity must lie between 1 and 10"));
  }
}

TEST_CASE("what a sky would drop is told") {
  const std::string sky = "<emitter type=\"sunsky\"><vector name=\"sun_direction\" value=\"0, 0, 1\"/>";
  const std::vector<std::string> twice = problems(around(sky + "<float name=\"hour\" value=\"9\"/></emitter>"));
  REQUIRE(twice.size() == 1);
  CHECK_THAT(twice[0], Catch::Contains("warning: \"hour\" has no effect beside \"sun_direction\""));
  const std::vector<std::string> dark = problems(around(sky + "<float name=\"sun_scale\" value=\"-1\"/></emitter>"));
  REQUIRE(dark.size() == 1);
  CHECK_THAT(dark[0], Catch::Contains("error: \"sun_scale\" must not be negative"));
  CHECK(problems(around(sky + "<float name=\"sun_scale\" value=\"0\"/></emitter>")).empty());
  for (const char* type : {"sky", "sun"})
    for (const char* scale : {"sky_scale", "sun_scale"}) {
      const std::vector<std::string> found = problems(
          around(std::string("<emitter type=\"") + type + "\"><float name=\"" + scale + "\" value=\"3\"/></emitter>"));
      REQUIRE(found.size() == 1);
      CHECK_THAT(found[0], Catch::Contains(std::string("warning: unknown parameter \"") + scale + "\""));
    }
}

}  // namespace

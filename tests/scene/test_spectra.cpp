// SPDX-License-Identifier: MIT
// Spectra as linear sRGB: curves, files, black bodies and typed spectra, compared with what Mitsuba 3.9.1 (scalar_rgb)
// makes of them and with exact values.
#include <catch2/catch.hpp>
#include <cmath>

#include "scene/scene_text.h"
#include "scene/spectra/observer.h"

using namespace strahl;
using namespace strahl::test;

namespace {

Rgb seen_reflectance(const std::string& spectrum) {
  const LoadedScene loaded = load_body("<bsdf type=\"diffuse\">" + spectrum + "</bsdf>");
  for (const Diagnostic& d : loaded.warnings) FAIL_CHECK(d.text());
  return std::get<Diffuse>(loaded.scene.materials.at(1).bsdf).reflectance.color;
}

Rgb seen_radiance(const std::string& spectrum) {
  const LoadedScene loaded = load_body("<emitter type=\"constant\">" + spectrum + "</emitter>");
  for (const Diagnostic& d : loaded.warnings) FAIL_CHECK(d.text());
  return std::get<ConstantLight>(loaded.scene.lights.at(0).emitter).radiance;
}

void check_near(const Rgb& color, const Rgb& expected, double tolerance) {
  CHECK(color.r == Approx(expected.r).epsilon(tolerance));
  CHECK(color.g == Approx(expected.g).epsilon(tolerance));
  CHECK(color.b == Approx(expected.b).epsilon(tolerance));
}

// Mitsuba sums 1,000 places and divides by 1,000 instead of 999: 0.1 %.
constexpr double of_sums = 0.0015;

}  // namespace

TEST_CASE("a reflectance of 1 at all wavelengths is exactly 1, 1, 1") {
  CHECK(seen_reflectance("<spectrum name=\"reflectance\" value=\"360:1, 830:1\"/>") == Rgb{1, 1, 1});
  CHECK(seen_reflectance("<spectrum name=\"reflectance\" value=\"300:1, 900:1\"/>") == Rgb{1, 1, 1});
  check_near(seen_reflectance("<spectrum name=\"reflectance\" value=\"360:.25, 401.5:.25, 830:.25\"/>"),
             {.25, .25, .25}, 1e-13);
}

TEST_CASE("curves under D65, 0 outside, as Mitsuba's") {
  check_near(seen_reflectance("<spectrum name=\"reflectance\" value=\"400:0.5,700:0.5\"/>"),
             {0.497671, 0.499878, 0.497455}, of_sums);
  const Rgb expected{0.887608, 0.562839, 0.155488};
  check_near(seen_reflectance("<spectrum name=\"reflectance\" value=\"400:0.1,500:0.3,600:0.9,700:0.2\"/>"), expected,
             of_sums);
  check_near(
      seen_reflectance("<spectrum type=\"irregular\" name=\"reflectance\"><string name=\"wavelengths\" "
                       "value=\"400, 500, 600, 700\"/><string name=\"values\" value=\"0.1 0.3 0.9 0.2\"/></spectrum>"),
      expected, of_sums);
  check_near(
      seen_reflectance("<spectrum type=\"regular\" name=\"reflectance\"><float name=\"wavelength_min\" value=\"400\"/>"
                       "<float name=\"wavelength_max\" value=\"700\"/><string name=\"values\" "
                       "value=\"0.1, 0.3, 0.9, 0.2\"/></spectrum>"),
      expected, of_sums);
  const SceneFolder folder;
  folder.write("spectra/a.spd", "# measured\n400 0.1\n500 0.3\n\n600 0.9\r\n700 0.2\n");
  const Scene scene = load_scene(folder.write("scene.xml", around("<path value=\"spectra\"/><bsdf type=\"diffuse\">"
                                                                  "<spectrum name=\"reflectance\" filename=\"a.spd\"/>"
                                                                  "</bsdf>")))
                          .scene;
  check_near(std::get<Diffuse>(scene.materials.at(1).bsdf).reflectance.color, expected, of_sums);
}

TEST_CASE("a file of a spectrum may have comments and further columns, as Mitsuba's") {
  const SceneFolder folder;
  folder.write("a.spd", "# measured\n400 0.1  # measured\n  # again\n500 0.3 0.01 7\n600 0.9#\n700 0.2 x\n");
  const SpectrumCurve curve = curve_of_file(folder.path("a.spd"));
  CHECK(curve.wavelengths == std::vector<double>{400, 500, 600, 700});
  CHECK(curve.values == std::vector<double>{.1, .3, .9, .2});
}

TEST_CASE("a black body shines between wavelength_min and wavelength_max alone") {
  const auto body = [](const std::string& limits) {
    return seen_radiance("<spectrum type=\"blackbody\" name=\"radiance\"><float name=\"temperature\" value=\"5000\"/>" +
                         limits + "</spectrum>");
  };
  const std::string low = "<float name=\"wavelength_max\" value=\"550.5\"/>";
  const std::string high = "<float name=\"wavelength_min\" value=\"550.5\"/>";
  const Rgb blue = body(low), red = body(high), all = body("");
  CHECK(red.r > 5 * blue.r);
  CHECK(blue.b > 5 * red.b);
  CHECK(body("<float name=\"wavelength_min\" value=\"100\"/><float name=\"wavelength_max\" value=\"1000\"/>") == all);
  const SpectrumCurve below = planck_curve(5000, 360, 550.5), above = planck_curve(5000, 550.5, 830);
  CHECK(below.wavelengths.back() == 550.5);
  CHECK(above.wavelengths.front() == 550.5);
  CHECK(below.values.back() == above.values.front());
  CHECK(below.wavelengths.size() + above.wavelengths.size() == planck_curve(5000).wavelengths.size() + 2);
}

TEST_CASE("a saturated reflectance is clamped to what sRGB can show") {
  const Rgb green = seen_reflectance("<spectrum name=\"reflectance\" value=\"515:1, 520:1, 525:1\"/>");
  CHECK(green.r == 0);
  CHECK(green.g > 0);
  const Rgb red = seen_reflectance("<spectrum name=\"reflectance\" value=\"580:0, 600:1, 830:1\"/>");
  CHECK(red.r == 1);
}

TEST_CASE("emission has no illuminant: a constant is no grey, as in Mitsuba") {
  check_near(seen_radiance("<spectrum name=\"radiance\" value=\"2\"/>"), {2.40959, 1.89658, 1.81783}, 1e-5);
  check_near(seen_radiance("<spectrum name=\"radiance\" value=\"360:1,830:1\"/>"), {1.20488, 0.948228, 0.909267},
             of_sums);
  check_near(seen_radiance("<spectrum name=\"radiance\" value=\"400:0.1,500:0.3,600:0.9,700:0.2\"/>"),
             {1.02115, 0.54285, 0.132375}, of_sums);
  CHECK(seen_radiance("<spectrum type=\"d65\" name=\"radiance\"><float name=\"scale\" value=\"3\"/></spectrum>") ==
        Rgb{3, 3, 3});
  CHECK(
      seen_radiance("<spectrum type=\"uniform\" name=\"radiance\"><float name=\"value\" value=\"0.25\"/></spectrum>") ==
      Rgb{.25, .25, .25});
  CHECK(seen_radiance("<spectrum type=\"srgb\" name=\"radiance\"><rgb name=\"color\" value=\"1, 2, 3\"/></spectrum>") ==
        Rgb{1, 2, 3});
}

TEST_CASE("a black body of 6504 K is nearly white, and a hotter one brighter and bluer") {
  const auto body = [](const std::string& kelvin) {
    return seen_radiance("<blackbody name=\"radiance\" temperature=\"" + kelvin + "\"/>");
  };
  const Rgb sun = body("6504"), lamp = body("2700K");
  CHECK(sun.r / sun.g == Approx(1).epsilon(0.08));
  CHECK(sun.b / sun.g == Approx(1).epsilon(0.08));
  CHECK(lamp.r > 1.5 * lamp.g);
  CHECK(lamp.g > 2 * lamp.b);
  CHECK(sun.g > 20 * lamp.g);
  // Luminance by Planck's law at 555 nm, where the observer is most sensitive: the same order.
  CHECK(sun.g / planck_curve(6504).at(555) == Approx(1).epsilon(0.1));
  check_near(seen_radiance("<spectrum type=\"blackbody\" name=\"radiance\"><float name=\"temperature\" value=\"6504\"/>"
                           "</spectrum>"),
             sun, 1e-15);
  check_near(seen_radiance("<blackbody name=\"radiance\" temperature=\"6504\" scale=\"2\"/>"),
             {2 * sun.r, 2 * sun.g, 2 * sun.b}, 1e-15);
}

TEST_CASE("a d65 around a texture is that texture, as in Mitsuba's RGB variants") {
  const std::string board = "<texture type=\"checkerboard\" id=\"b\"><float name=\"color0\" value=\"0.25\"/></texture>";
  const std::string shapes = "<shape type=\"sphere\"><emitter type=\"area\"><spectrum type=\"d65\" name=\"radiance\">" +
                             board +
                             "</spectrum></emitter><bsdf type=\"diffuse\"><spectrum type=\"d65\" name=\"reflectance\">"
                             "<ref id=\"b\" name=\"inside\"/></spectrum></bsdf></shape>";
  const LoadedScene loaded = load_body(shapes);
  for (const Diagnostic& d : loaded.warnings) FAIL_CHECK(d.text());
  REQUIRE(loaded.scene.textures.size() == 2);  // Of light, and of shares of it.
  for (const Texture& texture : loaded.scene.textures)
    CHECK(std::get<Checkerboard>(texture.pattern).color0 == Rgb{.25, .25, .25});
  const std::vector<std::string> two =
      problems(around("<bsdf type=\"diffuse\"><spectrum type=\"d65\" name=\"reflectance\">" + board +
                      "<texture type=\"checkerboard\"/></spectrum></bsdf>"));
  REQUIRE(two.size() == 1);
  CHECK(two[0] == "2:22: error: <spectrum type=\"d65\"> takes one <texture> inside");
}

TEST_CASE("a d65 is clamped once it is scaled, and a uniform spectrum may have ends") {
  const auto d65 = [](const char* scale, const char* color) {
    return std::string("<spectrum type=\"d65\" name=\"reflectance\"><float name=\"scale\" value=\"") + scale +
           "\"/><rgb name=\"color\" value=\"" + color + "\"/></spectrum>";
  };
  check_near(seen_reflectance(d65("0.1", "2, 3, 4")), {0.2, 0.3, 0.4}, 1e-15);
  const std::vector<std::string> found =
      problems(around("<bsdf type=\"diffuse\">" + d65("2", "0.25, 1, 0") + "</bsdf>"));
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Catch::Contains("warning: \"reflectance\" is 0.5, 2, 0, outside [0, 1]; 0.5, 1, 0 is used"));
  const std::string nested =
      "<spectrum type=\"d65\" name=\"reflectance\"><spectrum type=\"srgb\" name=\"color\"><rgb "
      "name=\"color\" value=\"-0.25, 0.5, 1\"/></spectrum></spectrum>";
  for (const std::string& negative : {d65("1", "-0.25, 0.5, 1"), nested}) {
    const std::vector<std::string> below = problems(around("<bsdf type=\"diffuse\">" + negative + "</bsdf>"));
    REQUIRE(below.size() == 1);
    CHECK_THAT(below[0],
               Catch::Contains("warning: \"reflectance\" is -0.25, 0.5, 1, outside [0, 1]; 0, 0.5, 1 is used"));
  }
  const std::vector<std::string> lamp =
      problems(around("<emitter type=\"constant\"><spectrum type=\"d65\" name=\"radiance\"><rgb name=\"color\" "
                      "value=\"-0.25, 0.5, 1\"/></spectrum></emitter>"));
  REQUIRE(lamp.size() == 1);
  CHECK_THAT(lamp[0], Catch::Contains("error: \"color\" is negative; light cannot be"));
  const std::string uniform =
      "<spectrum type=\"uniform\" name=\"reflectance\"><float name=\"wavelength_min\" value=\"400\"/><float "
      "name=\"wavelength_max\" value=\"700\"/><float name=\"value\" value=\"0.25\"/></spectrum>";
  CHECK(seen_reflectance(uniform) == Rgb{0.25, 0.25, 0.25});
}

TEST_CASE("a checkerboard takes its colours alike in a light, as Mitsuba's") {
  const Scene scene =
      load_body(
          "<shape type=\"sphere\"><emitter type=\"area\"><texture type=\"checkerboard\" name=\"radiance\">"
          "<spectrum name=\"color0\" value=\"1\"/><float name=\"color1\" value=\"3\"/></texture></emitter></shape>")
          .scene;
  const auto& board = std::get<Checkerboard>(scene.textures.at(0).pattern);
  CHECK(board.color0 == Rgb{1, 1, 1});
  CHECK(board.color1 == Rgb{3, 3, 3});
}

TEST_CASE("spectra that cannot be are errors at their place") {
  const auto problem = [](const std::string& spectrum) {
    const std::vector<std::string> found = problems(around("<bsdf type=\"diffuse\">" + spectrum + "</bsdf>"));
    REQUIRE(found.size() == 1);
    CHECK(found[0].find("2:22: error: ") == 0);
    return found[0];
  };
  CHECK(problem("<spectrum name=\"reflectance\" value=\"400:1, 400:2\"/>").find("ascend") != std::string::npos);
  CHECK(problem("<spectrum name=\"reflectance\" value=\"400:1, 5\"/>").find("no list") != std::string::npos);
  CHECK(problem("<spectrum name=\"reflectance\" value=\"400:1, 500:nan\"/>").find("finite") != std::string::npos);
  CHECK(problem("<spectrum name=\"reflectance\"/>").find("either value or filename") != std::string::npos);
  CHECK(problem("<spectrum name=\"reflectance\" filename=\"none.spd\"/>").find("none.spd") != std::string::npos);
  CHECK(problem("<spectrum type=\"irregular\" name=\"reflectance\"><string name=\"values\" value=\"1\"/></spectrum>")
            .find("as many finite values") != std::string::npos);
  CHECK(problem("<spectrum type=\"d65\" id=\"s\" name=\"reflectance\"><ref id=\"s\" name=\"color\"/></spectrum>")
            .find("contains itself") != std::string::npos);
  // Between one wavelength and nothing there is no light: Mitsuba refuses these, too.
  CHECK(problem("<spectrum name=\"reflectance\" value=\"550:10\"/>").find("of two or more") != std::string::npos);
  CHECK(problem("<spectrum type=\"irregular\" name=\"reflectance\"><string name=\"wavelengths\" value=\"550\"/>"
                "<string name=\"values\" value=\"1\"/></spectrum>")
            .find("two or more") != std::string::npos);
  CHECK(problem("<spectrum type=\"regular\" name=\"reflectance\"><string name=\"values\" value=\"1\"/></spectrum>")
            .find("two or more") != std::string::npos);
  const SceneFolder folder;
  CHECK(problem("<spectrum name=\"reflectance\" filename=\"" + folder.write("one.spd", "550 1\n") + "\"/>")
            .find("two wavelengths or more") != std::string::npos);
  CHECK(problem("<spectrum type=\"blackbody\" name=\"reflectance\"><float name=\"temperature\" value=\"5000\"/>"
                "<float name=\"wavelength_min\" value=\"900\"/></spectrum>")
            .find("no wavelength between 360 and 830") != std::string::npos);
  for (const char* huge : {"<spectrum name=\"reflectance\" value=\"400:1e306, 700:1e306\"/>",
                           "<blackbody name=\"reflectance\" temperature=\"1e308\"/>"})
    CHECK(problem(huge).find("\"reflectance\" is not finite: the numbers of its <") != std::string::npos);
  CHECK(problem("<blackbody name=\"reflectance\" temperature=\"0\"/>").find("greater than 0") != std::string::npos);
}

TEST_CASE("a chain of spectra is read to a depth of 256") {
  const auto chain = [](int length) {
    std::string text = "<bsdf type=\"diffuse\"><ref id=\"s0\" name=\"reflectance\"/></bsdf>";
    for (int i = 0; i < length; ++i) {
      const std::string within = i + 1 < length ? "<ref id=\"s" + std::to_string(i + 1) + "\" name=\"color\"/>"
                                                : "<rgb name=\"color\" value=\"0.25\"/>";
      text += "<spectrum type=\"srgb\" id=\"s" + std::to_string(i) + "\">" + within + "</spectrum>";
    }
    return around(text);
  };
  CHECK(std::get<Diffuse>(load_text(chain(256)).scene.materials.at(1).bsdf).reflectance.color == Rgb{0.25, 0.25, 0.25});
  for (const int length : {257, 20000}) {
    const std::vector<std::string> found = problems(chain(length));
    REQUIRE(found.size() == 1);
    CHECK(found[0].find("error: spectra are nested deeper than 256") != std::string::npos);
  }
}

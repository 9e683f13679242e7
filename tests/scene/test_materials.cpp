// SPDX-License-Identifier: MIT
// Metals and rough materials as scene files have them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>

#include "kinds/materials.h"
#include "scene/scene_text.h"
#include "scene/validate.h"

using namespace strahl;
using namespace strahl::test;

namespace {

template <class Bsdf>
Bsdf read_as(const std::string& bsdf) {
  const LoadedScene loaded = load_body(bsdf);
  CHECK(loaded.warnings.empty());
  return std::get<Bsdf>(loaded.scene.materials.at(1).bsdf);
}

std::string problem(const std::string& bsdf) {
  const std::vector<std::string> found = problems(around(bsdf));
  REQUIRE(found.size() == 1);
  return found[0];
}

std::string rough(const std::string& inside) { return "<bsdf type=\"roughconductor\">" + inside + "</bsdf>"; }

TEST_CASE("a coating has the parameters of Mitsuba 0.x") {
  const std::string grey = "<bsdf type=\"diffuse\"/>";
  const LoadedScene loaded = load_text(
      "<scene version=\"0.6.0\"><bsdf type=\"coating\"><float name=\"intIOR\" value=\"1.7\"/><float name=\"thickness\" "
      "value=\"2\"/><rgb name=\"sigmaA\" value=\"0.1, 2, 3\"/>" +
      grey + "</bsdf><bsdf type=\"coating\">" + grey + "</bsdf><sensor type=\"perspective\"/></scene>");
  CHECK(loaded.warnings.empty());
  const auto at = [&](std::size_t i) { return loaded.scene.materials.at(i).bsdf; };
  const Coat coat = std::get<Coat>(at(2)), plain = std::get<Coat>(at(4));
  CHECK(coat.int_ior == 1.7);
  CHECK(coat.thickness == 2);
  CHECK(coat.sigma_a.color == Rgb{0.1, 2, 3});
  CHECK(std::holds_alternative<Diffuse>(at(static_cast<std::size_t>(coat.nested))));
  CHECK(plain.int_ior == 1.5046);
  CHECK(plain.thickness == 1);
  CHECK(plain.sigma_a.color == Rgb{0, 0, 0});
  CHECK(plain.specular_reflectance.color == Rgb{1, 1, 1});
  const LoadedScene glass = load_body("<bsdf type=\"coating\"><bsdf type=\"dielectric\"/></bsdf>");
  REQUIRE(glass.warnings.size() == 1);
  CHECK(std::holds_alternative<Dielectric>(glass.scene.materials.back().bsdf));
}

}  // namespace

TEST_CASE(
    "a checkerboard that gives a number has its colours the other way round, as Mitsuba's, and of each the mean") {
  const std::string board =
      "<rgb name=\"color0\" value=\".3, .6, .9\"/><float name=\"color1\" value=\".25\"/></texture>";
  const auto named = [&](const char* name) {
    return "<texture type=\"checkerboard\" name=\"" + std::string(name) + "\">" + board;
  };
  const LoadedScene loaded = load_body(
      "<texture type=\"checkerboard\" id=\"b\">" + board + "<bsdf type=\"mask\">" + named("opacity") +
      rough(named("alpha") + "<ref name=\"specular_reflectance\" id=\"b\"/>") +
      "</bsdf><bsdf type=\"principled\"><ref name=\"metallic\" id=\"b\"/><ref name=\"base_color\" id=\"b\"/></bsdf>");
  CHECK(loaded.warnings.empty());
  int numbers = 0, colours = 0;
  for (const Texture& texture : loaded.scene.textures) {
    const auto& found = std::get<Checkerboard>(texture.pattern);
    const bool is_number = found.color0 == Rgb{0.25, 0.25, 0.25};
    CHECK(found.color1.r == Approx(is_number ? 0.6 : 0.25));
    CHECK(found.color1.b == Approx(is_number ? 0.6 : 0.25));
    if (!is_number) CHECK(found.color0 == Rgb{0.3, 0.6, 0.9});
    (is_number ? numbers : colours) += 1;
  }
  CHECK(numbers == 3);
  CHECK(colours == 1);
}

TEST_CASE("metals have a name, or eta and k, over the index outside") {
  const auto metal = [](const std::string& inside) {
    return read_as<Conductor>("<bsdf type=\"conductor\">" + inside + "</bsdf>").index;
  };
  CHECK(metal("<string name=\"material\" value=\"Au\"/>").eta.color == Rgb{0.143036, 0.375307, 1.44205});
  CHECK(metal("<string name=\"material\" value=\"Au\"/>").k.color == Rgb{3.983, 2.38556, 1.60336});
  CHECK(metal("").eta.color == Rgb{0, 0, 0});
  CHECK(metal("").k.color == Rgb{1, 1, 1});
  const MetalIndex values = metal("<rgb name=\"eta\" value=\"1, 2, 3\"/><float name=\"k\" value=\"4\"/>");
  CHECK(values.eta.color == Rgb{1, 2, 3});
  CHECK(values.k.color == Rgb{4, 4, 4});
  const MetalIndex in_water = metal(
      "<float name=\"eta\" value=\"2.666\"/><float name=\"k\" value=\"1.333\"/><string name=\"ext_eta\" "
      "value=\"water\"/>");
  CHECK(in_water.eta.color == Rgb{2, 2, 2});
  CHECK(in_water.k.color == Rgb{1, 1, 1});
  CHECK(problem("<bsdf type=\"conductor\"><string name=\"material\" value=\"Gold\"/></bsdf>")
            .find("2:24: error: \"Gold\" is no metal that strahl knows") == 0);
  CHECK(
      problem("<bsdf type=\"conductor\"><string name=\"material\" value=\"Au\"/><float name=\"k\" value=\"1\"/></bsdf>")
          .find("either a material or eta and k") != std::string::npos);
}

TEST_CASE("microfacets are Beckmann's by default, alike along u and v or not") {
  const Microfacets plain = read_as<RoughConductor>(rough("")).microfacets;
  CHECK(plain.kind == MicrofacetKind::beckmann);
  CHECK(plain.alpha_u.color == Rgb{0.1, 0.1, 0.1});
  CHECK(plain.alpha_v.color == Rgb{0.1, 0.1, 0.1});
  CHECK(plain.sample_visible);
  const Microfacets ggx = read_as<RoughConductor>(rough("<string name=\"distribution\" value=\"GGX\"/>"
                                                        "<float name=\"alpha\" value=\".3\"/>"
                                                        "<boolean name=\"sample_visible\" value=\"false\"/>"))
                              .microfacets;
  CHECK(ggx.kind == MicrofacetKind::ggx);
  CHECK(ggx.alpha_v.color == Rgb{0.3, 0.3, 0.3});
  CHECK_FALSE(ggx.sample_visible);
  const Microfacets brushed = read_as<RoughConductor>(rough("<float name=\"alpha_u\" value=\".05\"/>"
                                                            "<texture type=\"checkerboard\" name=\"alpha_v\"/>"))
                                  .microfacets;
  CHECK(brushed.alpha_u.color == Rgb{0.05, 0.05, 0.05});
  CHECK(brushed.alpha_v.texture == 0);
  CHECK(problem(rough("<float name=\"alpha_u\" value=\".05\"/>")).find("both of alpha_u and alpha_v") !=
        std::string::npos);
  CHECK(problem(rough("<float name=\"alpha\" value=\"-.1\"/>")).find("negative") != std::string::npos);
  CHECK(problem(rough("<string name=\"distribution\" value=\"gx\"/>")).find("there are beckmann and ggx") !=
        std::string::npos);
}

TEST_CASE("a blend has two materials, each read once, and blends, masks and sides around it") {
  const std::string white = "<bsdf type=\"diffuse\" id=\"white\"/>", ref = "<ref id=\"white\"/>";
  const auto scene_of = [&](const std::string& body) { return load_body(white + body).scene; };
  const Scene blend = scene_of(
      "<bsdf type=\"blendbsdf\"><rgb name=\"weight\" value=\".1, .2, .6\"/><bsdf type=\"plastic\"/>" + ref + "</bsdf>");
  const auto blend_in = [](const Scene& scene) { return std::get<Blend>(scene.materials.back().bsdf); };
  CHECK(blend_in(blend).weight.color.g == Approx(0.3));
  CHECK(material_facts(blend.materials.at(static_cast<std::size_t>(blend_in(blend).first))).kind == "plastic");
  CHECK(blend.materials.at(static_cast<std::size_t>(blend_in(blend).second)).id == "white");
  CHECK(blend_in(scene_of("<bsdf type=\"blendbsdf\">" + ref + ref + "</bsdf>")).weight.color == Rgb{0.5, 0.5, 0.5});
  const Scene beside =
      scene_of("<bsdf type=\"twosided\"><bsdf type=\"blendbsdf\">" + ref + "<bsdf type=\"conductor\"/></bsdf></bsdf>");
  CHECK(beside.materials.back().twosided);
  CHECK(lobes_of(beside, beside.materials.back()) == (lobes::LOBE_DELTA | lobes::LOBE_DIFFUSE | lobes::LOBE_REFLECT));
  const std::string glass = "<bsdf type=\"blendbsdf\">" + ref + "<bsdf type=\"dielectric\"/></bsdf>";
  CHECK(transmits(scene_of(glass), scene_of(glass).materials.back()));
  CHECK_FALSE(scene_of("<bsdf type=\"twosided\">" + glass + "</bsdf>").materials.back().twosided);
  CHECK(problems(around("<bsdf type=\"blendbsdf\">" + white + "</bsdf>")).at(0) ==
        "2:1: error: <bsdf type=\"blendbsdf\"> needs two <bsdf> inside");
  CHECK(problems(around("<bsdf type=\"blendbsdf\" id=\"x\"><ref id=\"x\"/>" + white + "</bsdf>")).at(0) ==
        "2:1: error: bsdf \"x\" contains itself");
}

TEST_CASE("very many materials around one of very many are read in no time") {
  std::string all = "<bsdf type=\"diffuse\" id=\"0\"/>";
  constexpr int count = 8191;
  for (int i = count; i > 0; --i) {
    const int first = 2 * i < count ? 2 * i : 0, second = first > 0 ? first + 1 : 0;
    const auto half = [](int id) { return "<ref id=\"" + std::to_string(id) + "\"/>"; };
    all += "<bsdf type=\"blendbsdf\" id=\"" + std::to_string(i) + "\">" + half(first) + half(second) + "</bsdf>";
  }
  for (int i = 0; i < count; ++i) all += "<bsdf type=\"twosided\"><ref id=\"1\"/></bsdf>";
  const auto begin = std::chrono::steady_clock::now();
  const Scene scene = load_body(all).scene;
  CHECK(scene.materials.back().twosided);
  // A quadratic one takes a minute.
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
}

TEST_CASE("reliefs have a map, Mitsuba's options and a material inside") {
  const std::string map = "<rgb name=\"normalmap\" value=\"0.6, 0.4, 0.9\"/>", white = "<bsdf type=\"diffuse\"/>";
  const std::string letter = "<texture type=\"bitmap\"><string name=\"filename\" value=\"" STRAHL_SOURCE_DIR
                             "/scenes/textures/letter.png\"/></texture>";
  const auto relief_of = [](const std::string& bsdf) {
    const LoadedScene loaded = load_body(bsdf);
    CHECK(loaded.warnings.empty());
    return std::get<Relief>(loaded.scene.materials.back().bsdf);
  };
  const Relief normals = relief_of("<bsdf type=\"normalmap\">" + map + white + "</bsdf>");
  CHECK(normals.kind == Relief::Kind::normals);
  CHECK(normals.map.color == Rgb{0.6, 0.4, 0.9});
  CHECK(normals.flip_invalid_normals);
  CHECK(normals.use_shadowing_function);
  const Relief heights =
      relief_of("<bsdf type=\"bumpmap\">" + letter + white +
                "<float name=\"scale\" value=\"-2.5\"/><boolean name=\"flip_invalid_normals\" "
                "value=\"false\"/><boolean name=\"use_shadowing_function\" value=\"false\"/></bsdf>");
  CHECK(heights.kind == Relief::Kind::heights);
  CHECK(heights.map.texture == 0);
  CHECK(heights.scale == -2.5);
  CHECK_FALSE(heights.flip_invalid_normals);
  CHECK_FALSE(heights.use_shadowing_function);
  CHECK(problem("<bsdf type=\"normalmap\">" + white + "</bsdf>").find("needs a normalmap") != std::string::npos);
  const Relief scaled = relief_of(
      "<bsdf type=\"bumpmap\"><float name=\"scale\" value=\"3\"/><texture type=\"scale\"><float name=\"scale\" "
      "value=\".5\"/>" +
      letter + "</texture>" + white + "</bsdf>");
  CHECK(scaled.scale == 1.5);
  CHECK(scaled.map.texture == 0);
  for (const char* steep : {"1.1e12", "-1e38"})
    CHECK(problem("<bsdf type=\"bumpmap\"><texture type=\"scale\"><float name=\"scale\" value=\"" + std::string(steep) +
                  "\"/>" + letter + "</texture>" + white + "</bsdf>")
              .find("scale must be from -1e12 to 1e12") != std::string::npos);
  CHECK(problem("<bsdf type=\"bumpmap\"><texture type=\"scale\"/>" + white + "</bsdf>").find("needs one <texture>") !=
        std::string::npos);
  CHECK(problem("<bsdf type=\"bumpmap\">" + white + "</bsdf>").find("needs one <texture>") != std::string::npos);
  CHECK(problem("<bsdf type=\"bumpmap\">" + letter + "</bsdf>").find("needs one <bsdf>") != std::string::npos);
  CHECK(problem("<bsdf type=\"normalmap\">" + map + "<bsdf type=\"normalmap\">" + map + white + "</bsdf></bsdf>")
            .find("bent twice") != std::string::npos);
  CHECK(problem("<bsdf type=\"normalmap\">" + map + "<bsdf type=\"twosided\">" + white + "<bsdf type=\"normalmap\">" +
                map + white + "</bsdf></bsdf></bsdf>")
            .find("bent twice") != std::string::npos);
}

TEST_CASE("principled materials have Mitsuba's defaults, and eta or specular") {
  const auto is_grey = [](const Varying& value, double grey) { return value.color == Rgb{grey, grey, grey}; };
  const Principled plain = read_as<Principled>("<bsdf type=\"principled\"/>");
  CHECK(is_grey(plain.base_color, 0.5));
  CHECK(is_grey(plain.roughness, 0.5));
  CHECK(is_grey(plain.clearcoat, 0));
  CHECK(plain.eta == Approx(1.5));
  const auto eta_of = [](const std::string& inside) {
    return read_as<Principled>("<bsdf type=\"principled\">" + inside + "</bsdf>").eta;
  };
  const std::string glass = "<float name=\"spec_trans\" value=\"0.5\"/>",
                    flat = "<float name=\"specular\" value=\"0\"/>";
  CHECK(eta_of("<float name=\"eta\" value=\"1.3\"/>") == 1.3);
  CHECK(eta_of(flat) == 1);
  CHECK(eta_of(flat + glass) == Approx(2 / (1 - std::sqrt(0.08e-3)) - 1));
  CHECK(eta_of("<float name=\"eta\" value=\"1\"/>" + glass) == 1.001);
  CHECK(
      problem("<bsdf type=\"principled\"><float name=\"eta\" value=\"1.3\"/>" + flat + "</bsdf>").find("either eta") !=
      std::string::npos);
  CHECK(problem("<bsdf type=\"principled\"><float name=\"metallic\" value=\"2\"/></bsdf>").find("[0, 1]") !=
        std::string::npos);
  const Scene sides = load_body("<bsdf type=\"twosided\"><bsdf type=\"principled\"/></bsdf>").scene;
  CHECK(sides.materials.back().twosided);
  const PrincipledThin sheet =
      read_as<PrincipledThin>("<bsdf type=\"principledthin\"><float name=\"diff_trans\" value=\"1.5\"/></bsdf>");
  CHECK(is_grey(sheet.diff_trans, 1.5));
  CHECK(is_grey(sheet.eta, 1.5));
}

TEST_CASE("materials of Mitsuba 0.x, by its names and by Mitsuba 3's") {
  const std::string old = "<scene version=\"0.6.0\"><sensor type=\"perspective\"/>";
  const auto last = [](const std::string& text) { return load_text(text + "</scene>").scene.materials.back(); };
  const Phong phong = std::get<Phong>(
      last(old + "<bsdf type=\"phong\"><rgb name=\"diffuseReflectance\" value=\".1, .2, .3\"/></bsdf>").bsdf);
  CHECK(phong.diffuse_reflectance.color == Rgb{.1, .2, .3});
  CHECK(phong.specular_reflectance.color == Rgb{.2, .2, .2});
  CHECK(phong.exponent.color == Rgb{30, 30, 30});
  const RoughDiffuse rough = std::get<RoughDiffuse>(
      last(old + "<bsdf type=\"roughdiffuse\"><boolean name=\"useFastApprox\" value=\"true\"/></bsdf>").bsdf);
  CHECK(rough.use_fast_approx);
  CHECK(rough.alpha.color == Rgb{.2, .2, .2});
  CHECK(read_as<DiffTrans>("<bsdf type=\"difftrans\"/>").transmittance.color == Rgb{.5, .5, .5});
  const Ward ward = read_as<Ward>("<bsdf type=\"ward\"><string name=\"variant\" value=\"ward-duer\"/></bsdf>");
  CHECK(ward.variant == Ward::Variant::ward_duer);
  CHECK(ward.alpha_u.color == Rgb{.1, .1, .1});
  // Mitsuba 0.6: alphaU and alphaV are alpha where they are not given.
  const Ward brushed = std::get<Ward>(
      last(old + "<bsdf type=\"ward\"><float name=\"alpha\" value=\".3\"/><float name=\"alphaV\" value=\".2\"/></bsdf>")
          .bsdf);
  CHECK(brushed.alpha_u.color == Rgb{.3, .3, .3});
  CHECK(brushed.alpha_v.color == Rgb{.2, .2, .2});
  CHECK(problem("<bsdf type=\"ward\"><string name=\"variant\" value=\"new\"/></bsdf>").find("no variant") !=
        std::string::npos);
  Material both;
  both.bsdf = Phong{{{0.8, 0.8, 0.8}}, {{0.8, 0.8, 0.8}}};
  // Mitsuba 0.6, ensureEnergyConservation: 0.99 over what both reflect together.
  CHECK(material_facts(both).slots[0].reals[0] == Approx(0.8 * 0.99 / 1.6));
}

TEST_CASE("a blend of materials that do not stand before it is refused") {
  Scene scene = load_body("<bsdf type=\"diffuse\"/>").scene;
  scene.materials.back().bsdf = Blend{{{0.5, 0.5, 0.5}}, 0, static_cast<int>(scene.materials.size()) - 1};
  const std::vector<Diagnostic> found = validate(scene);
  REQUIRE(found.size() == 1);
  CHECK(found[0].message.find("stand before it") != std::string::npos);
}

TEST_CASE("a mask has an opacity, nothing is a mask, and two sides may differ") {
  const auto material = [](const std::string& bsdf) {
    const LoadedScene loaded = load_body(bsdf);
    CHECK(loaded.warnings.empty());
    return loaded.scene.materials.back();
  };
  const Material mask =
      material("<bsdf type=\"mask\"><rgb name=\"opacity\" value=\"0, .5, 1\"/><bsdf type=\"plastic\"/></bsdf>");
  REQUIRE(mask.opacity);
  CHECK(mask.opacity->color == Rgb{0.5, 0.5, 0.5});
  CHECK(std::holds_alternative<Plastic>(mask.bsdf));
  CHECK(material("<bsdf type=\"null\"/>").opacity->color == Rgb{0, 0, 0});
  CHECK_FALSE(material("<bsdf type=\"diffuse\"/>").opacity);
  const std::string half = "<bsdf type=\"mask\"><float name=\"opacity\" value=\"0.5\"/><bsdf type=\"plastic\"/></bsdf>";
  const Material twice = material("<bsdf type=\"mask\"><float name=\"opacity\" value=\"0.4\"/>" + half + "</bsdf>");
  CHECK(twice.opacity->color.r == Approx(0.2));
  CHECK(std::holds_alternative<Plastic>(twice.bsdf));
  const Scene patterned =
      load_body("<bsdf type=\"mask\"><texture type=\"checkerboard\" name=\"opacity\"/>" + half + "</bsdf>").scene;
  const Material& outer = patterned.materials.back();
  CHECK(outer.opacity->texture == 0);
  const Blend& all = std::get<Blend>(outer.bsdf);
  CHECK(all.weight.color == Rgb{0, 0, 0});
  const Material& inner = patterned.materials.at(static_cast<std::size_t>(all.first));
  CHECK(inner.opacity->color == Rgb{0.5, 0.5, 0.5});
  CHECK(std::holds_alternative<Plastic>(inner.bsdf));
  CHECK(problem("<bsdf type=\"mask\"/>").find("needs one <bsdf> inside") != std::string::npos);
  const Scene sides =
      load_body("<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/><bsdf type=\"conductor\"/></bsdf>").scene;
  const auto front =
      std::find_if(sides.materials.begin(), sides.materials.end(), [](const Material& each) { return each.twosided; });
  REQUIRE(front != sides.materials.end());
  REQUIRE(front->back >= 0);
  CHECK(std::holds_alternative<Conductor>(sides.materials[static_cast<std::size_t>(front->back)].bsdf));
}

TEST_CASE("a mask around two sides is on both") {
  const Scene scene = load_body(
                          "<bsdf type=\"mask\"><float name=\"opacity\" value=\"0.25\"/><bsdf type=\"twosided\">"
                          "<bsdf type=\"plastic\"/><bsdf type=\"diffuse\"/></bsdf></bsdf>")
                          .scene;
  const Material& front = scene.materials.back();
  CHECK(front.opacity->color.r == 0.25);
  REQUIRE(front.back >= 0);
  const Material& back = scene.materials.at(static_cast<std::size_t>(front.back));
  CHECK(std::holds_alternative<Diffuse>(back.bsdf));
  REQUIRE(back.opacity);
  CHECK(back.opacity->color.r == 0.25);
}

/// The opacities on the way to the material that is seen, by their red; -1 of a texture.
std::vector<double> opacities_of(const Scene& scene, Material at, bool is_behind) {
  std::vector<double> found;
  for (;;) {
    if (is_behind && at.back >= 0) at = scene.materials.at(static_cast<std::size_t>(at.back));
    if (at.opacity) found.push_back(at.opacity->texture < 0 ? at.opacity->color.r : -1);
    const auto* blend = std::get_if<Blend>(&at.bsdf);
    if (blend == nullptr) return found;
    at = scene.materials.at(static_cast<std::size_t>(blend->first));
  }
}

TEST_CASE("masks in masks around two sides count once from either, and one of a side on that side") {
  const auto mask = [](const std::string& opacity, const std::string& inside) {
    return "<bsdf type=\"mask\">" + opacity + inside + "</bsdf>";
  };
  const std::string half = "<float name=\"opacity\" value=\"0.5\"/>",
                    quarter = "<float name=\"opacity\" value=\"0.25\"/>",
                    board = "<texture type=\"checkerboard\" name=\"opacity\"/>", front = "<bsdf type=\"plastic\"/>",
                    back = "<bsdf type=\"diffuse\"/>";
  const auto sides = [](const std::string& both) { return "<bsdf type=\"twosided\">" + both + "</bsdf>"; };
  struct Case {
    std::string bsdf;
    std::vector<double> before, behind;
  };
  for (const Case& one : {Case{mask(half, mask(board, sides(front + back))), {0.5, -1}, {0.5, -1}},
                          Case{mask(board, mask(half, sides(front + back))), {-1, 0.5}, {-1, 0.5}},
                          Case{mask(half, mask(quarter, sides(front + back))), {0.125}, {0.125}},
                          Case{mask(board, sides(mask(board, front) + back)), {-1, -1}, {-1}},
                          Case{mask(half, sides(mask(board, front) + back)), {0.5, -1}, {0.5}},
                          Case{mask(half, sides(mask(quarter, front) + back)), {0.125}, {0.5}},
                          Case{mask(half, sides(front + mask(board, back))), {0.5}, {0.5, -1}}}) {
    INFO(one.bsdf);
    const Scene scene = load_body(one.bsdf).scene;
    CHECK(opacities_of(scene, scene.materials.back(), false) == one.before);
    CHECK(opacities_of(scene, scene.materials.back(), true) == one.behind);
  }
}

TEST_CASE("textures of what is no share of light are not cut at 1, and numbers are means of colours") {
  const std::string values = "<float name=\"color0\" value=\"2\"/><float name=\"color1\" value=\"4\"/></texture>";
  const LoadedScene loaded = load_body(
      "<bsdf type=\"roughconductor\"><float name=\"eta\" value=\"0.2\"/>"
      "<texture type=\"checkerboard\" name=\"k\">" +
      values + "<rgb name=\"alpha\" value=\"0.1, 0.1, 0.7\"/></bsdf>");
  CHECK(loaded.warnings.empty());
  const auto& metal = std::get<RoughConductor>(loaded.scene.materials.back().bsdf);
  const auto& board =
      std::get<Checkerboard>(loaded.scene.textures.at(static_cast<std::size_t>(metal.index.k.texture)).pattern);
  CHECK(board.color0 == Rgb{2, 2, 2});
  CHECK(board.color1 == Rgb{4, 4, 4});
  CHECK(metal.microfacets.alpha_u.color.r == Approx(0.3));
  CHECK(metal.microfacets.alpha_v.color.b == Approx(0.3));
  // Of Mitsuba 0.x's, too, but that a checkerboard's colours stay in their places.
  const auto colour = [](const char* name) {
    return std::string("<rgb name=\"") + name + "\" value=\"0.1, 0.1, 0.7\"/></bsdf>";
  };
  CHECK(read_as<Phong>("<bsdf type=\"phong\">" + colour("exponent")).exponent.color.r == Approx(0.3));
  CHECK(read_as<RoughDiffuse>("<bsdf type=\"roughdiffuse\">" + colour("alpha")).alpha.color.g == Approx(0.3));
  CHECK(read_as<Ward>("<bsdf type=\"ward\">" + colour("alpha")).alpha_v.color.b == Approx(0.3));
  CHECK(read_as<Ward>("<bsdf type=\"ward\">" + colour("alpha_u")).alpha_u.color.b == Approx(0.3));
  CHECK(read_as<Ward>("<bsdf type=\"ward\">" + colour("alpha_v")).alpha_v.color.r == Approx(0.3));
  const Scene phong =
      load_body("<bsdf type=\"phong\"><texture type=\"checkerboard\" name=\"exponent\">" + values + "</bsdf>").scene;
  CHECK(std::get<Checkerboard>(phong.textures.at(0).pattern).color0 == Rgb{2, 2, 2});
}

// SPDX-License-Identifier: MIT
// Image files of textures and environments: parameters of Mitsuba 3 and 0.x, files that are shared, faults.
#include <catch2/catch.hpp>

#include "image/image_io.h"
#include "kinds/textures.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

struct ImageFolder : SceneFolder {
  ImageFolder() {
    write_image(Image{4, 3, {"R", "G", "B"}, std::vector<float>(36, 0.5F), {}}, path("a.png"));
    std::vector<float> bright(36, 0.5F);
    bright[7] = 8;
    write_image(Image{4, 3, {"R", "G", "B"}, bright, {}}, path("bright.exr"));
  }
  [[nodiscard]] LoadedScene load(const std::string& body, const std::string& version = "3.0.0") const {
    return load_scene(write(
        "scene.xml", "<scene version=\"" + version + "\">\n" + body + "\n<sensor type=\"perspective\"/></scene>\n"));
  }
  /// The first texture, which has these parameters.
  [[nodiscard]] Bitmap bitmap(const std::string& parameters, const std::string& version = "3.0.0") const {
    const LoadedScene loaded = load(
        "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\">"
        "<string name=\"filename\" value=\"a.png\"/>" +
            parameters + "</texture></bsdf>",
        version);
    return std::get<Bitmap>(loaded.scene.textures.at(0).pattern);
  }
  [[nodiscard]] std::string fault(const std::string& body) const {
    try {
      (void)load(body);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  }
};

using UvMap = std::array<double, 6>;

TEST_CASE("a bitmap has Mitsuba's parameters") {
  const ImageFolder folder;
  const Bitmap plain = folder.bitmap("");
  REQUIRE(plain.texels);
  CHECK(plain.texels->width == 4);
  CHECK(plain.curve.kind == TexelCurve::Kind::srgb);
  CHECK(plain.filter == TextureFilter::bilinear);
  CHECK(plain.wrap == TextureWrap::repeat);
  CHECK(plain.to_uv == UvMap{1, 0, 0, 0, 1, 0});
  CHECK(plain.mean.g == Approx(0.5).epsilon(0.01));
  const Bitmap full = folder.bitmap(
      "<boolean name=\"raw\" value=\"true\"/><string name=\"filter_type\" value=\"nearest\"/>"
      "<string name=\"wrap_mode\" value=\"mirror\"/>"
      "<transform name=\"to_uv\"><scale x=\"2\" y=\"3\"/><translate x=\".5\"/></transform>");
  CHECK(full.curve.kind == TexelCurve::Kind::linear);
  CHECK(full.filter == TextureFilter::nearest);
  CHECK(full.wrap == TextureWrap::mirror);
  CHECK(full.to_uv == UvMap{2, 0, 0.5, 0, 3, 0});
  CHECK(full.mean.g == Approx(0.735).epsilon(0.01));
  CHECK(folder.bitmap("<string name=\"wrap_mode\" value=\"clamp\"/>").wrap == TextureWrap::clamp);
  const LoadedScene spectrum = folder.load(
      "<bsdf type=\"diffuse\"><spectrum type=\"bitmap\" name=\"reflectance\"><string name=\"filename\" "
      "value=\"a.png\"/></spectrum></bsdf>");
  CHECK(std::holds_alternative<Bitmap>(spectrum.scene.textures.at(0).pattern));
}

TEST_CASE("of to_uv x and y alone count") {
  const ImageFolder folder;
  const auto map = [](const std::string& steps) { return "<transform name=\"to_uv\">" + steps + "</transform>"; };
  CHECK(folder.bitmap(map("<scale x=\"2\" y=\"3\" z=\"0\"/>")).to_uv == UvMap{2, 0, 0, 0, 3, 0});
  CHECK(folder.bitmap(map("<matrix value=\"2 0 0  0 4 0  0 0 0\"/><scale x=\"1e-20\" y=\"1e-20\"/>")).to_uv ==
        UvMap{2e-20, 0, 0, 0, 4e-20, 0});
  // A texture may be the same all along u, v or a line.
  CHECK(folder.bitmap(map("<scale x=\"2\" y=\"0\"/>")).to_uv == UvMap{2, 0, 0, 0, 0, 0});
  CHECK(folder.bitmap(map("<matrix value=\"1 2 0  2 4 0  0 0 1\"/>")).to_uv == UvMap{1, 2, 0, 2, 4, 0});
  CHECK_NOTHROW(folder.bitmap(map("<rotate x=\"1\" angle=\"90\"/>")));
}

TEST_CASE("a bitmap has the parameters of Mitsuba 0.x, as Mitsuba 3 upgrades them") {
  const ImageFolder folder;
  const Bitmap old = folder.bitmap(
      "<float name=\"uscale\" value=\"3\"/><float name=\"uoffset\" value=\"0.25\"/><float name=\"voffset\" "
      "value=\"0.5\"/><string name=\"filterType\" value=\"ewa\"/><string name=\"wrapMode\" value=\"clamp\"/><float "
      "name=\"gamma\" value=\"1\"/>",
      "0.6.0");
  CHECK(old.to_uv == UvMap{3, 0, 0.75, 0, 1, 0.5});
  CHECK(old.filter == TextureFilter::bilinear);
  CHECK(old.wrap == TextureWrap::clamp);
  CHECK(old.curve.kind == TexelCurve::Kind::linear);
  CHECK(folder.bitmap("<float name=\"uvscale\" value=\"2\"/>", "0.6.0").to_uv == UvMap{2, 0, 0, 0, 2, 0});
  CHECK(folder.bitmap("<float name=\"gamma\" value=\"2.2\"/>", "0.6.0").curve ==
        TexelCurve{TexelCurve::Kind::power, 2.2});
}

TEST_CASE("files are read once, and named among those of the scene") {
  const ImageFolder folder;
  const std::string file = "<string name=\"filename\" value=\"a.png\"/>";
  const std::string texture = "<texture type=\"bitmap\" name=\"reflectance\">" + file + "</texture>";
  const LoadedScene loaded = folder.load("<bsdf type=\"diffuse\">" + texture + "</bsdf><bsdf type=\"diffuse\">" +
                                         texture + "</bsdf><emitter type=\"envmap\">" + file + "</emitter>");
  const auto texels = [&](std::size_t i) { return std::get<Bitmap>(loaded.scene.textures.at(i).pattern).texels; };
  CHECK(texels(0) == texels(1));
  CHECK(std::get<EnvironmentLight>(loaded.scene.lights.at(0).emitter).texels == texels(0));
  CHECK(loaded.scene.files == std::vector<std::string>{folder.path("scene.xml"), folder.path("a.png")});
}

TEST_CASE("lights have textures that may exceed 1, beside those of materials") {
  const ImageFolder folder;
  const std::string file =
      "<texture type=\"bitmap\" id=\"bright\"><string name=\"filename\" value=\"bright.exr\"/></texture>";
  const std::string board =
      "<texture type=\"checkerboard\" name=\"texture\"><rgb name=\"color0\" value=\"7, 8, 9\"/></texture>";
  const LoadedScene loaded = folder.load(
      file + "<shape type=\"sphere\"><bsdf type=\"diffuse\"><ref id=\"bright\" name=\"reflectance\"/></bsdf>" +
      "<emitter type=\"area\"><ref id=\"bright\" name=\"radiance\"/></emitter></shape>" +
      "<emitter type=\"projector\"><ref id=\"bright\" name=\"irradiance\"/><float name=\"scale\" value=\"2\"/>" +
      "<float name=\"fov\" value=\"90\"/></emitter><emitter type=\"spot\">" + board + "</emitter>");
  REQUIRE(loaded.warnings.size() == 1);  // Of the reflectance.
  const std::vector<Texture>& textures = loaded.scene.textures;
  REQUIRE(textures.size() == 3);
  const Shape& shape = loaded.scene.shapes.at(0);
  const auto texture = [&](int i) { return textures.at(static_cast<std::size_t>(i)); };
  CHECK(shape.radiance == Rgb{1, 1, 1});
  CHECK(texture(shape.radiance_texture).is_unbounded);
  CHECK(TexelDecoder(*std::get<Bitmap>(texture(shape.radiance_texture).pattern).texels, {})(2)[1] == 8);
  const auto projector = std::get<ProjectorLight>(loaded.scene.lights.at(0).emitter);
  CHECK(projector.texture == shape.radiance_texture);
  CHECK(projector.irradiance == Rgb{2, 2, 2});
  CHECK(projector.tan_x == 1);
  CHECK(projector.tan_y == 0.75);  // The image is 4 x 3.
  const auto spot = std::get<SpotLight>(loaded.scene.lights.at(1).emitter);
  CHECK(std::get<Checkerboard>(texture(spot.texture).pattern).color0 == Rgb{7, 8, 9});
  CHECK_THAT(folder.fault("<emitter type=\"spot\"><float name=\"cutoff_angle\" value=\"95\"/>" + board + "</emitter>"),
             Contains("less than 90 degrees"));
}

TEST_CASE("a mesh_attribute is of the meshes that it is on; others are dropped") {
  const ImageFolder folder;
  folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty "
      "float r\nproperty float g\nproperty float b\nproperty float heat_0\nelement face 1\nproperty list uchar "
      "int vertex_indices\nend_header\n0 0 0 1 0 0 1\n1 0 0 0 1 0 2\n0 1 0 0 0 1 3\n3 0 1 2\n");
  const auto body = [](const std::string& name, const std::string& shape) {
    return "<bsdf type=\"diffuse\" id=\"a\"><texture type=\"mesh_attribute\" name=\"reflectance\"><string "
           "name=\"name\" "
           "value=\"" +
           name + "\"/><float name=\"scale\" value=\"0.5\"/></texture></bsdf>" + shape;
  };
  const std::string mesh =
      "<shape type=\"ply\"><string name=\"filename\" value=\"a.ply\"/><bsdf type=\"twosided\"><ref "
      "id=\"a\"/></bsdf></shape>";
  const Scene scene = folder.load(body("vertex_heat", mesh)).scene;
  const auto attribute = std::get<AttributeTexture>(scene.textures.at(0).pattern);
  CHECK(attribute.name == "vertex_heat");
  CHECK(attribute.scale == 0.5);
  const std::vector<MeshAttribute>& kept = std::get<Mesh>(scene.shapes.at(0).geometry).attributes;
  REQUIRE(kept.size() == 1);
  CHECK(kept[0].values == std::vector<Rgb>{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
  CHECK_THAT(folder.fault(body("vertex_cold", mesh)), Contains("has no attribute \"vertex_cold\""));
  CHECK_THAT(folder.fault(body("vertex_heat", "<shape type=\"sphere\"><ref id=\"a\"/></shape>")),
             Contains("has no attribute \"vertex_heat\""));
  CHECK_THAT(folder.fault(body("heat", mesh)), Contains("vertex_ or face_"));
}

TEST_CASE("what reflects more than all is cut, with a warning; light is not") {
  const ImageFolder folder;
  const std::string file = "<string name=\"filename\" value=\"bright.exr\"/>";
  const LoadedScene loaded = folder.load("<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\">" +
                                         file + "</texture></bsdf><emitter type=\"envmap\">" + file + "</emitter>");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK_THAT(loaded.warnings[0].message, Contains("1 of the 12 texels"));
  const auto most = [](const Texels& texels) { return TexelDecoder(texels, {})(2)[1]; };
  CHECK(most(*std::get<Bitmap>(loaded.scene.textures.at(0).pattern).texels) == 1);
  CHECK(most(*std::get<EnvironmentLight>(loaded.scene.lights.at(0).emitter).texels) == 8);
}

TEST_CASE("an environment has scale, turn and compensation") {
  const ImageFolder folder;
  const LoadedScene loaded = folder.load(
      "<emitter type=\"envmap\"><string name=\"filename\" value=\"a.png\"/><float name=\"scale\" value=\"3\"/><boolean "
      "name=\"mis_compensation\" value=\"true\"/><transform name=\"to_world\"><scale x=\"-1\"/><rotate "
      "y=\"1\" angle=\"90\"/></transform></emitter>");
  CHECK(loaded.warnings.empty());
  const auto& light = std::get<EnvironmentLight>(loaded.scene.lights.at(0).emitter);
  CHECK(light.scale == Rgb{3, 3, 3});
  CHECK(light.mis_compensation);
  CHECK(light.axes[0].z == Approx(1));
  CHECK(light.axes[1].y == Approx(1));
  CHECK(light.axes[2].x == Approx(1));
}

TEST_CASE("an environment that to_world scales is shown as if it did not, with a warning") {
  const ImageFolder folder;
  const auto load = [&](const std::string& scale) {
    return folder.load(
        "<emitter type=\"envmap\"><string name=\"filename\" value=\"a.png\"/><transform name=\"to_world\"><scale "
        "value=\"" +
        scale + "\"/></transform></emitter>");
  };
  for (const char* scale : {"2", "0.5", "1.002"}) {
    INFO(scale);
    const LoadedScene loaded = load(scale);
    REQUIRE(loaded.warnings.size() == 1);
    CHECK_THAT(loaded.warnings[0].message, Contains("here the scale has no effect"));
    CHECK(std::get<EnvironmentLight>(loaded.scene.lights.at(0).emitter).axes[1].y == Approx(1));
  }
  for (const char* scale : {"-1", "1.0004"}) CHECK(load(scale).warnings.empty());
}

TEST_CASE("a map_Kd of an MTL file is a texture, times Kd; one that is not there is warned of") {
  const ImageFolder folder;
  folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
  folder.write("a.mtl", "newmtl m\nKd 1 0.5 0.25\nmap_Kd -s 2 4 -o 0.5 0.25 a.png\n");
  const std::string shape = "<shape type=\"obj\"><string name=\"filename\" value=\"a.obj\"/></shape>";
  const LoadedScene loaded = folder.load(shape);
  CHECK(loaded.warnings.empty());
  const auto& bitmap = std::get<Bitmap>(loaded.scene.textures.at(0).pattern);
  CHECK(bitmap.scale == Rgb{1, 0.5, 0.25});
  // The mesh counts v from the top.
  CHECK(bitmap.to_uv == UvMap{2, 0, 0.5, 0, 4, -3.25});
  CHECK(std::get<Diffuse>(loaded.scene.materials.back().bsdf).reflectance.texture == 0);
  folder.write("a.mtl", "newmtl m\nKd 1 0.5 0.25\nmap_Kd no.png\n");
  const LoadedScene without = folder.load(shape);
  REQUIRE(without.warnings.size() == 1);
  CHECK_THAT(without.warnings[0].message, Contains("no.png") && Contains("Kd stands"));
  CHECK(without.warnings[0].where.line == 3);
  CHECK(without.scene.textures.empty());
}

TEST_CASE("faults of images name the line") {
  const ImageFolder folder;
  const auto texture = [](const std::string& parameters) {
    return "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\">" + parameters + "</texture></bsdf>";
  };
  CHECK_THAT(folder.fault(texture("")), Contains("2:22") && Contains("needs the string \"filename\""));
  CHECK_THAT(folder.fault(texture("<string name=\"filename\" value=\"no.png\"/>")),
             Contains("2:64") && Contains("no.png"));
  folder.write("text.png", "no image at all");
  CHECK_THAT(folder.fault(texture("<string name=\"filename\" value=\"text.png\"/>")),
             Contains("2:64") && Contains("is not an image"));
  const std::string file = "<string name=\"filename\" value=\"a.png\"/>";
  CHECK_THAT(folder.fault(texture(file + "<float name=\"gamma\" value=\"-2\"/>")), Contains("gamma -2"));
  CHECK_THAT(folder.fault("<emitter type=\"envmap\">" + file +
                          "<transform name=\"to_world\"><scale x=\"2\"/></transform></emitter>"),
             Contains("must be a rotation"));
  CHECK_THAT(folder.fault("<emitter type=\"envmap\">" + file +
                          "<transform name=\"to_world\"><scale x=\"1.002\"/></transform></emitter>"),
             Contains("must be a rotation"));
  CHECK_THAT(folder.fault("<emitter type=\"constant\"/><emitter type=\"envmap\">" + file + "</emitter>"),
             Contains("one constant, envmap or sky emitter"));
  CHECK_THAT(folder.load(texture(file + "<string name=\"wrap_mode\" value=\"miror\"/>")).warnings.at(0).message,
             Contains("did you mean \"mirror\""));
}

TEST_CASE("an environment turned by a matrix with four digits has the nearest rotation") {
  const ImageFolder folder;
  const LoadedScene loaded = folder.load(
      "<emitter type=\"envmap\"><string name=\"filename\" value=\"a.png\"/><transform name=\"to_world\"><matrix "
      "value=\"0.7071 0 0.7071 0 1 0 -0.7071 0 0.7071\"/></transform></emitter>");
  CHECK(loaded.warnings.empty());
  const auto light = std::get<EnvironmentLight>(loaded.scene.lights.at(0).emitter);
  const double half = std::sqrt(0.5);
  CHECK(length(light.axes[0] - Vec3{half, 0, -half}) < 1e-15);
  CHECK(length(light.axes[1] - Vec3{0, 1, 0}) < 1e-15);
  CHECK(length(light.axes[2] - Vec3{half, 0, half}) < 1e-15);
}

TEST_CASE("textures of floats are cut at 1 where a share is meant, and nowhere else") {
  const ImageFolder folder;
  const auto board = [](const char* name) {
    return std::string("<texture type=\"checkerboard\" name=\"") + name +
           "\"><float name=\"color0\" value=\"2\"/><float name=\"color1\" value=\"3\"/></texture>";
  };
  const auto bitmap = [](const char* name) {
    return std::string("<texture type=\"bitmap\" name=\"") + name +
           "\"><string name=\"filename\" value=\"bright.exr\"/></texture>";
  };
  const auto brightest = [](const LoadedScene& loaded) {
    return kinds::brightest(loaded.scene, 0).g + kinds::brightest(loaded.scene, 0).r;
  };
  const std::string thin = "<bsdf type=\"principledthin\">", rough = "<bsdf type=\"roughconductor\">";
  for (const std::string& what : {thin + bitmap("eta"), thin + bitmap("diff_trans"), rough + bitmap("alpha")}) {
    INFO(what);
    const LoadedScene loaded = folder.load(what + "</bsdf>");
    CHECK(loaded.warnings.empty());
    CHECK(brightest(loaded) > 8);
  }
  for (const std::string& what : {thin + board("eta"), rough + board("alpha")}) {
    INFO(what);
    const LoadedScene loaded = folder.load(what + "</bsdf>");
    CHECK(loaded.warnings.empty());
    CHECK(std::get<Checkerboard>(loaded.scene.textures.at(0).pattern).color0 == Rgb{3, 3, 3});
  }
  const LoadedScene roughness = folder.load(thin + bitmap("roughness") + "</bsdf>");
  REQUIRE(roughness.warnings.size() == 1);
  CHECK(brightest(roughness) <= 2);
}

TEST_CASE("a bump map's heights may lie below 0, light may not, of one file") {
  const ImageFolder folder;
  write_image(Image{2, 1, {"R", "G", "B"}, {-1, -1, -1, 2, 2, 2}, {}}, folder.path("signed.exr"));
  const std::string file = "<string name=\"filename\" value=\"signed.exr\"/></texture>";
  const std::string bump =
      "<bsdf type=\"bumpmap\"><texture type=\"bitmap\">" + file + "<bsdf type=\"diffuse\"/></bsdf>";
  const auto values = [](const LoadedScene& loaded) {
    const Bitmap& bitmap = std::get<Bitmap>(loaded.scene.textures.back().pattern);
    const TexelDecoder decoded(*bitmap.texels, bitmap.curve);
    return std::array{decoded(0)[0], decoded(1)[0]};
  };
  const LoadedScene heights = folder.load(bump);
  CHECK(heights.warnings.empty());
  CHECK(values(heights) == std::array{-1.0, 2.0});
  const std::string lamp = "<texture type=\"bitmap\" name=\"radiance\">" + file;
  const LoadedScene both =
      folder.load("<shape type=\"sphere\">" + bump + "<emitter type=\"area\">" + lamp + "</emitter></shape>");
  REQUIRE(both.warnings.size() == 1);
  CHECK_THAT(both.warnings[0].message, Contains("1 of the 2 texels of") && Contains("negative, infinite or no number"));
  CHECK(values(both) == std::array{0.0, 2.0});
}
}  // namespace

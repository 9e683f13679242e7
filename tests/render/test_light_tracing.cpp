// SPDX-License-Identifier: MIT
// Paths from the lights (integrator ptracer) make the picture that paths from the camera make: of every light, of
// materials that refract, bend normals or are open, through lenses and wide filters. The same bits however they are
// followed, and on another device.
#include <catch2/catch.hpp>

#include "errors.h"
#include "kinds/lights.h"
#include "kinds/materials.h"
#include "render/alike.h"
#include "render/film_state.h"
#include "render/stage.h"
#include "scene/model/build.h"
#include "settings/sampling.h"

namespace strahl::test {
namespace {

void hold_like_path(const char* what, const Scene& scene, int samples = 128, double tolerance = 0.01) {
  hold_alike("ptracer", "path", what, scene, samples, tolerance);
}

/// One of the project's, with a finite floor, and diffuse where it mirrors: paths from lights do not find what the
/// camera sees in mirrors, nor paths from the camera what mirrors throw of points.
Scene without_mirrors(const std::string& path) {
  Scene scene = load_scene((scene_folder / path).string() + ".xml").scene;
  for (Material& material : scene.materials)
    if (material_facts(material).has_lobe(lobes::LOBE_DELTA)) material.bsdf = Diffuse{{{0.5, 0.5, 0.5}}};
  for (Shape& shape : scene.shapes)
    if (const auto* plane = std::get_if<Plane>(&shape.geometry)) {
      const Vec3 u = 4 * plane->u, v = 4 * plane->v;
      shape.geometry = Rectangle{plane->point - u - v, 2 * u, 2 * v};
    }
  return scene;
}

TEST_CASE("every light, from its own end") {
  require_pocl_and_rusticl();
  Scene lamp = under_lamp(diffuse({0.7, 0.5, 0.3}, true)), point = grey_ball(), sky = grey_ball(), sun = grey_ball(),
        all = lamp;
  hold_like_path("area", lamp);
  add(point, PointLight{{1, -2, 3}, {20, 15, 10}});
  hold_like_path("point", point);
  add(sky, ConstantLight{{1, 0.9, 0.8}});
  hold_like_path("constant", sky);
  add(sun, DirectionalLight{{0.3, 0.2, -1}, {3, 3, 3}});
  hold_like_path("directional", sun);
  add(all, PointLight{{1, -2, 3}, {5, 5, 5}});
  add(all, ConstantLight{{0.2, 0.2, 0.4}});
  add(all, DirectionalLight{{0.3, 0.2, -1}, {0.5, 0.5, 0.5}});
  hold_like_path("all of them", all);
}

TEST_CASE("a renderer tells how many samples its film holds") {
  require_pocl_and_rusticl();
  Scene scene = under_lamp(diffuse({0.7, 0.5, 0.3}));
  scene.film.width = scene.film.height = 128;
  const auto most = [&](const std::string& integrator, bool estimate_error) {
    scene.integrator.name = integrator;
    RenderSettings settings;
    settings.estimate_error = estimate_error;
    return Renderer::most_samples(scene, settings);
  };
  CHECK(most("path", true) == max_spp);
  CHECK(most("ptracer", true) == 1 << 19);
  CHECK(most("ptracer", false) == 1 << 17);
  scene.integrator.name = "ptracer";
  CHECK(Renderer(Device::open("pocl"), scene, generic_settings()).most_samples() == most("ptracer", true));
  RenderGoal goal;
  goal.spp = (1 << 19) + 1;
  CHECK_THROWS_AS(Renderer::require_samples(scene, {}, goal), UsageError);
}

TEST_CASE("what stands between a surface and the camera hides it from light paths") {
  require_pocl_and_rusticl();
  Scene scene = under_lamp(diffuse({0.7, 0.5, 0.3}));
  scene.camera =
      perspective_camera({0, 1, -5}, {0, 0, 0}, {0, 0, 1}, 60);  // From below the floor, which is dark there.
  scene.integrator.name = "ptracer";
  scene.sampler.sample_count = 16;
  CHECK(lit_pixels(render("pocl", scene, {}).color) == 0);
  scene.camera = perspective_camera({0, 1, 5}, {0, 0, 0}, {0, 0, 1}, 60);
  CHECK(lit_pixels(render("pocl", scene, {}).color) > 200);
}

TEST_CASE("lights of the project's scenes: images of the sky, projectors, spots, textured screens", "[slow]") {
  require_pocl_and_rusticl();
  for (const char* name : {"envmap", "projector", "spot", "screen", "sphere", "disk", "cylinder", "mesh"})
    hold_like_path(name, without_mirrors(std::string("lights/") + name), 64, 0.02);
  hold_like_path("sunsky", without_mirrors("lights/sunsky"), 192, 0.02);
}

TEST_CASE("lenses, filters, cameras of parallel rays and parts of a picture") {
  require_pocl_and_rusticl();
  Scene scene = under_lamp(diffuse({0.7, 0.5, 0.3}, true));
  scene.film.filter = {FilterKind::gaussian};
  scene.camera.aperture_radius = 0.2;
  scene.camera.focus_distance = 5;
  hold_like_path("gaussian and lens", scene);
  scene.film.filter = {FilterKind::tent};
  scene.camera.aperture_radius = 0;
  scene.camera.projection = Projection::orthographic;
  scene.film.crop = Window{3, 8, 27, 28};
  hold_like_path("part of parallel rays, tent", scene, 2048);
}

TEST_CASE("glass scales radiance and not flux; shading normals and reliefs count from both sides", "[slow]") {
  require_pocl_and_rusticl();
  Material glass;
  glass.bsdf = RoughDielectric{};
  Scene scene = under_lamp(diffuse({0.6, 0.6, 0.6}, true));
  scene.materials.push_back(glass);
  scene.shapes[1].material = 1;
  scene.integrator.max_depth = 8;
  hold_like_path("rough glass", scene, 512, 0.02);
  for (const char* name : {"roughconductor", "normalmap", "roughplastic"})
    hold_like_path(name, without_mirrors(std::string("materials/") + name), 256, 0.02);
  // Shadow rays of path do not go through masks, so that only light that its rays can meet comes through them.
  Scene masks = without_mirrors("materials/mask");
  std::erase_if(masks.lights, [](const Light& light) { return kinds::light(light).is_delta; });
  hold_like_path("mask", masks, 512);
}

TEST_CASE("what scatters otherwise from the other side does so as the camera would see it") {
  require_pocl_and_rusticl();
  Scene sheet = under_lamp(diffuse({0.5, 0.5, 0.5}));
  PrincipledThin thin;
  thin.base_color = {{0.9, 0.9, 0.9}};
  thin.roughness = {{0.9, 0.9, 0.9}};
  thin.spec_trans = {{1, 1, 1}};
  thin.eta = {{2, 2, 2}};
  sheet.shapes[1].geometry = Rectangle{{-2, -2, 0.8}, {4, 0, 0}, {0, 4, 0}};
  sheet.shapes[1].material = add(sheet, thin);
  sheet.shapes[2].geometry = Rectangle{{4, -0.5, 1.2}, {-0.25, 0, 0.95}, {0, 1, 0}};
  sheet.shapes[2].radiance = Rgb{20, 20, 20};
  hold_like_path("a sheet under a low lamp", sheet, 128, 0.03);

  // A mirror whose normal is bent by 40 degrees throws the light of the lamp straight above it at a wall.
  Scene mirror = under_lamp(diffuse({0.5, 0.5, 0.5}));
  Relief relief;
  relief.map = {{0.821, 0.5, 0.883}};
  relief.nested = add(mirror, Conductor{});
  mirror.shapes[0].material = add(mirror, relief);
  mirror.shapes[1].geometry = Rectangle{{3, 3, 0}, {0, -6, 0}, {0, 0, 3}};
  mirror.shapes[1].material = 0;
  mirror.camera = perspective_camera({2, 0, 0.55}, {3, 0, 0.55}, {0, 0, 1}, 40);
  mirror.integrator.max_depth = 3;
  mirror.integrator.hide_emitters = true;
  hold_like_path("a bent mirror", mirror, 256, 0.03);

  // Light goes straight through a pane with the same normal, and fades by where it comes from.
  Scene pane = under_lamp(diffuse({0.5, 0.5, 0.5}));
  Relief bent;
  bent.map = {{0.821, 0.5, 0.883}};
  bent.nested = add(pane, ThinDielectric{});
  pane.shapes[1].geometry = Rectangle{{-2, -2, 0.8}, {4, 0, 0}, {0, 4, 0}};
  pane.shapes[1].material = add(pane, bent);
  pane.shapes[2].geometry = Rectangle{{-4, -1, 1.2}, {0, 2, 0}, {0.5, 0, 1.9}};
  pane.shapes[2].radiance = Rgb{20, 20, 20};
  pane.camera = perspective_camera({0, -1.8, 0.5}, {0, 0, -0.3}, {0, 0, 1}, 40);  // Below the pane.
  pane.integrator.max_depth = 4;
  hold_like_path("a bent pane", pane, 512, 0.03);
}

// The way from the light is long and the light low: as wide as that, squares would be grey.
TEST_CASE("squares of a checkerboard are as sharp as paths from the camera show them") {
  require_pocl_and_rusticl();
  Scene scene =
      stage({Rectangle{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}, Rectangle{{-10, -10, -0.5}, {20, 0, 0}, {0, 20, 0}}},
            diffuse({0.5, 0.5, 0.5}));
  scene.textures = {{"", Checkerboard{{0.8, 0.8, 0.8}, {0, 0, 0}, {6, 0, 0, 0, 6, 0}}, {}}};  // 4 x 4 pixels each.
  Material board;
  board.bsdf = Diffuse{{{1, 1, 1}, 0}};
  scene.shapes[0].material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(board);
  scene.camera = perspective_camera({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 2 * std::atan(0.5) * 180 / std::numbers::pi);
  add(scene, DirectionalLight{{1, 0.3, -0.1}, {3, 3, 3}});
  scene.film.filter = {FilterKind::box, 0.5, 0.5};
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 512;
  for (const char* integrator : {"ptracer", "bdpt"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    const Image image = render("pocl", scene, generic_settings()).color;
    CHECK(lit_pixels(image) < stage_size * stage_size / 2 + 24);
    CHECK(lit_pixels(image) > stage_size * stage_size / 8);
  }
}

// Were both drawn by one number, the floor would be white only where the pane is open, or only where it is not.
TEST_CASE("a blend behind a blend of masks: each draws by a number of its own") {
  require_pocl_and_rusticl();
  Scene scene = under_lamp(diffuse({0.5, 0.5, 0.5}, true));
  const auto put = [&scene](Material material) {
    scene.materials.push_back(std::move(material));
    return static_cast<int>(scene.materials.size()) - 1;
  };
  const auto put_blend = [&](Material first, Material second) {
    Material blend;
    const int a = put(std::move(first)), b = put(std::move(second));
    blend.bsdf = Blend{{{0.5, 0.5, 0.5}}, a, b};
    return put(blend);
  };
  const Material white = diffuse({0.9, 0.9, 0.9}, true), black = diffuse({0, 0, 0}, true);
  Material open = black;
  open.opacity = Reflectance{{0, 0, 0}};
  scene.shapes[0].material = put_blend(white, black);
  scene.shapes[1].material = put_blend(black, white);
  add(scene, Rectangle{{-4, -4, -2}, {8, 0, 0}, {0, 0, 8}});
  scene.shapes.back().material = put_blend(open, black);
  hold_like_path("pane", scene, 256);
}

TEST_CASE("max_depth and hidden emitters leave out what they do from the camera") {
  require_pocl_and_rusticl();
  for (const int depth : {1, 2, 3}) {
    Scene scene = under_lamp(diffuse({0.7, 0.5, 0.3}, true));
    scene.camera = perspective_camera({0, -5, 1}, {0, 0, 2.5}, {0, 0, 1}, 70);  // It sees the lamp from below.
    add(scene, ConstantLight{{0.2, 0.2, 0.2}});
    scene.integrator.max_depth = depth;
    hold_like_path("depth", scene);
    scene.integrator.hide_emitters = true;
    if (depth > 1) hold_like_path("hidden", scene);
  }
}

Scene caustic(int spp = 16) {
  Scene scene = small_scene(scene_folder / "lights/caustic.xml", 29, 23, spp);
  return scene;
}

/// What a floor of reflectance 1/2 under the camera throws upwards, times pi / (1/2): the power that reaches it.
double power_on_floor(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += static_cast<double>(image.at(x, y, 0));
  const double pixel_side = 2 * half_width / stage_size;
  return 2 * std::numbers::pi * sum * pixel_side * pixel_side;
}

TEST_CASE("beams bring all of their power to where they point") {
  require_pocl_and_rusticl();
  Scene floor = stage({Rectangle{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}}, diffuse({0.5, 0.5, 0.5}));
  floor.integrator.name = "ptracer";
  floor.sampler.kind = SamplerKind::independent;
  floor.sampler.sample_count = 4;
  floor.film.filter = {FilterKind::box, 0.5, 0.5};
  Scene beam = floor, beside = floor, lamp = floor;
  add(beam, CollimatedLight{{3, 0.2, 3}, {-2.9, 0, -3}, {7, 7, 7}});
  const Image lit = render("pocl", beam, {}).color;
  CHECK(power_on_floor(lit) == Approx(7));
  CHECK(lit_pixels(lit) == 1);
  Scene border = floor;  // Between two pixels, which both have it at their end.
  add(border, CollimatedLight{{3, 0, 3}, {-3, 0, -3}, {7, 7, 7}});
  CHECK(power_on_floor(render("pocl", border, {}).color) == Approx(7));
  add(beside, CollimatedLight{{3, 0.2, 3}, {2.9, 0, -3}, {7, 7, 7}});
  CHECK(power_on_floor(render("pocl", beside, {}).color) == 0);
  // Of area 1/2, out of the camera's sight; the floor's normal is 60 degrees off.
  add(lamp, Rectangle{{2 * std::sqrt(3.0) - 0.125, -0.5, 2 + 0.125 * std::sqrt(3.0)},
                      {0, 1, 0},
                      {0.25, 0, -0.25 * std::sqrt(3.0)}});
  lamp.shapes.back().exitance = Rgb{3, 3, 3};
  CHECK(power_on_floor(render("pocl", lamp, {}).color) == Approx(1.5).epsilon(1e-3));
}

// The lamp's flux is infinite in red, of which the floor reflects nothing.
TEST_CASE("light that is no number is counted, and its other channels stay") {
  require_pocl_and_rusticl();
  Scene scene = stage({Rectangle{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}}, diffuse({0, 0.5, 0.5}));
  Shape lamp = emitting(Rectangle{{-5, -5, 6}, {0, 10, 0}, {10, 0, 0}}, {1e38, 1, 1});
  lamp.material = add(scene, Diffuse{{{0, 0, 0}}});
  add(scene, lamp);
  scene.integrator.max_depth = 2;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 64;
  for (const char* integrator : {"ptracer", "bdpt"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    const RenderResult result = render("pocl", scene, generic_settings());
    CHECK(result.stats.unusual.invalid > 0);
    double red = 0, green = 0;
    for (std::size_t i = 0; i < result.color.data.size(); i += 3) {
      red += static_cast<double>(result.color.data[i]);
      green += static_cast<double>(result.color.data[i + 1]);
    }
    CHECK(red == 0);
    CHECK(green / (stage_size * stage_size) > 0.1);
  }
}

TEST_CASE("the same bits by any lanes, launches and programs") {
  require_pocl_and_rusticl();
  hold_same_ways(caustic(), {1, 16});
  hold_same_ways(small_scene(scene_folder / "lights/beams.xml", 29, 23, 16), {16});
}

TEST_CASE("the same bits of more scenes; an error that nobody asked for", "[slow]") {
  require_pocl_and_rusticl();
  Scene cornell = small_scene(scene_folder / "cornell/cornell-box.xml", 29, 23, 16);
  cornell.integrator.name = "ptracer";
  hold_same_ways(cornell, {16});
  hold_same_ways(small_scene(scene_folder / "lights/beams.xml", 29, 23, 16), {1});
  RenderSettings untold;
  untold.estimate_error = false;
  CHECK_FALSE(render("pocl", caustic(), untold).error);
}

TEST_CASE("on a device that ends loops, too, each splat is made once") {
  require_pocl_and_rusticl();
  // A small program: llvmpipe takes minutes for large ones.
  Scene scene = stage({Sphere{{0, 0, 0}, 1.5}}, diffuse({0.8, 0.8, 0.8}));
  add(scene, PointLight{{0, 1, 4}, {8, 8, 8}});
  scene.integrator.name = "ptracer";
  scene.film.width = scene.film.height = 8;
  scene.film.filter = {FilterKind::box, 0.5, 0.5};
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 256;
  RenderSettings watched;
  watched.precision = Precision::stable;
  RenderSettings plain = watched;
  watched.loop_turns = 65534;
  watched.passes = 1;
  const RenderResult expected = render("pocl", scene, plain), found = render("llvmpipe", scene, watched);
  CHECK(same_bits(expected, found));
  CHECK(found.stats.kernel_runs.size() > 1);  // Paths were cut short.
  CHECK(same_bits(expected, render("pocl", scene, watched)));
}

TEST_CASE("a film of splats goes on from any launch, and ends at an error or a deadline") {
  require_pocl_and_rusticl();
  RenderSettings settings;
  settings.passes = 5;
  Renderer renderer(Device::open("pocl"), caustic(32), settings);
  const RenderResult expected = renderer.render();
  std::vector<FilmState> states;
  FilmKeeper keeper;
  keeper.is_due = [] { return true; };
  keeper.keep = [&](FilmState state) { states.push_back(std::move(state)); };
  CHECK(same_bits(expected, renderer.render({}, {}, &keeper)));
  REQUIRE(states.size() > 3);
  for (const FilmState& state : states) {
    FilmKeeper other;
    other.begin_with = &state;
    const RenderResult found = renderer.render({}, {}, &other);
    CHECK(same_bits(expected, found));
    CHECK(is_told_alike(expected, found));
  }
  RenderGoal goal;
  goal.max_error = 0.2;
  const RenderResult ended = renderer.render({}, goal);
  CHECK(ended.ending == Ending::error);
  REQUIRE(ended.error);
  CHECK(ended.error->rmse <= 0.2);
}

// A table over all of a radius far beyond the bell would have cells as wide as the bell.
TEST_CASE("a filter that is cut far off has the picture of one that is cut nearer") {
  require_pocl_and_rusticl();
  Scene scene = under_lamp(diffuse({0.7, 0.5, 0.3}));
  scene.integrator.name = "ptracer";
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 16;
  const auto power = [&](double radius) {
    scene.film.filter = {FilterKind::gaussian, radius, 0.5};
    return power_on_floor(render("pocl", scene, generic_settings()).color);
  };
  CHECK(power(1000) == Approx(power(4)).epsilon(0.02));
}

}  // namespace
}  // namespace strahl::test

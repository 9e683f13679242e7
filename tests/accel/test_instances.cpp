// SPDX-License-Identifier: MIT
// A group that is placed is what its shapes would be there: the same hits, bit for bit where the map is exact; with and
// without trees, at every width. What decides equal t, what a ray has left, mirrored and distorted groups.
#include "cl/instanced_scenes.h"
#include "cl/same_bits.h"
#include "support/asked.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

Device device() {
  require_pocl();
  return Device::open("pocl");
}

RenderSettings settings_of(Precision precision, int width, Acceleration acceleration) {
  RenderSettings settings;
  settings.generic = asks_generic();
  settings.precision = precision;
  settings.bvh_width = width;
  settings.acceleration = acceleration;
  return settings;
}

Vec3 whole(oracle::Random& random) {
  const auto step = [&] { return 4.0 * random.integer(-8, 8); };
  return {step(), step(), step()};
}

/// Origins on a grid that translations keep, so that nothing is rounded but what the flat scene rounds too.
std::vector<Ray> on_grid(std::vector<Ray> rays) {
  for (Ray& ray : rays) {
    const auto round = [](double x) { return std::nearbyint(16 * x) / 16; };
    ray.origin = {round(ray.origin.x), round(ray.origin.y), round(ray.origin.z)};
  }
  return rays;
}

/// One of every way to find a hit; programs for all kinds take long to compile.
const std::vector<std::string> kind_names = {"sphere", "plane", "box", "triangle"};

int widest(Precision precision) { return precision == Precision::fp64 ? 8 : 16; }

double distance(const Vec3& a, const Vec3& b) { return length(a - b); }

std::size_t differing(const std::vector<Hit>& a, const std::vector<Hit>& b) {
  REQUIRE(a.size() == b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += !is_same(a[i], b[i], true);
  return count;
}

/// And as many that go on from there, with what they left.
void go_on(std::vector<Ray>& rays, const std::vector<Hit>& hits, oracle::Random& random) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].shape < 0) continue;
    Ray ray;
    ray.origin = rays[i].origin + hits[i].t * rays[i].direction;
    ray.direction = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    ray.instance = hits[i].instance;
    ray.shape = hits[i].shape;
    ray.primitive = hits[i].primitive;
    rays.push_back(ray);
  }
}

struct Question {
  Scene scene;
  std::vector<Ray> rays;
};

/// Scene `number`: 2 to 40 instances, moved or distorted, every fifth scene far away.
Question question(int number, std::size_t rays) {
  InstancedMaker maker(100 + static_cast<std::uint64_t>(number));
  Question q;
  q.scene = maker.scene(
      2 + 2 * number,
      [&](int i) { return i % 4 == 0 ? moved_by(whole(maker.random())) : distorted(maker.random(), i); }, kind_names);
  q.rays = maker.rays(rays);
  if (number % 5 == 4) {
    const Vec3 by{100003, -7001, 0.5};
    q.scene = translated(q.scene, by);
    for (Ray& ray : q.rays) ray.origin = ray.origin + by;
  }
  return q;
}

Scene with_group(const Geometry& geometry, const std::vector<Transform>& places) {
  Scene scene;
  Group group;
  group.shapes.emplace_back().geometry = geometry;
  add(scene, group);
  for (const Transform& place : places) add_instance(scene, 0, place);
  return scene;
}

Transform scaled_by(double x, double y, double z) {
  Transform transform;
  transform.m[0][0] = x;
  transform.m[1][1] = y;
  transform.m[2][2] = z;
  return transform;
}

/// By every tier that the host has.
template <class Check>
void on_host(const Scene& scene, const Check& check) {
  for (const int lanes : {1, 8, 16}) check(HostTracer<float>(scene, lanes), 0x1p-20);
  for (const int lanes : {1, 8}) check(HostTracer<double>(scene, lanes), 0x1p-48);
}

void hold_moved(Precision precision) {
  InstancedMaker maker(7);
  const Scene scene = maker.scene(
      40, [&](int) { return moved_by(whole(maker.random())); }, kind_names);
  const Scene flat = flattened(scene);
  const std::vector<Ray> rays = on_grid(maker.rays(40000));
  const auto expected =
      Intersector(device(), flat, settings_of(precision, widest(precision), Acceleration::tree)).trace(rays);
  const auto hits =
      Intersector(device(), scene, settings_of(precision, widest(precision), Acceleration::tree)).trace(rays);
  int instanced = 0, others = 0, differing = 0;
  double off = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    (hits[i].instance >= 0 ? instanced : others) += hits[i].shape >= 0;
    const bool same = hits[i].t == expected[i].t && hits[i].primitive == expected[i].primitive &&
                      flat_shape(scene, hits[i]) == expected[i].shape && hits[i].u == expected[i].u &&
                      hits[i].v == expected[i].v;
    differing += !same;
    if (!same && differing < 5)
      UNSCOPED_INFO(i << ": " << hits[i].instance << " " << flat_shape(scene, hits[i]) << "/" << hits[i].primitive
                      << " t " << hits[i].t << " u " << hits[i].u << " v " << hits[i].v << ", flat "
                      << expected[i].shape << "/" << expected[i].primitive << " t " << expected[i].t << " u "
                      << expected[i].u << " v " << expected[i].v);
    if (hits[i].shape >= 0 && expected[i].shape >= 0) off = std::max(off, distance(hits[i].normal, expected[i].normal));
  }
  INFO(precision_name(precision));
  CHECK(differing == 0);
  CHECK(instanced > 10000);
  CHECK(others > 1000);
  CHECK(off < (precision == Precision::fp64 ? 0x1p-50 : 0x1p-21));
}

void hold_trees(Precision precision) {
  const Device on = device();
  for (int number = 0; number < 15; ++number) {
    Question q = question(number, 600);
    const int width = widest(precision);
    Intersector lists(on, q.scene, settings_of(precision, width, Acceleration::list));
    std::vector<Ray> rays = q.rays;
    InstancedMaker other(5);
    go_on(rays, lists.trace(rays), other.random());
    const std::vector<Hit> expected = lists.trace(rays);
    INFO("scene " << number << ", " << precision_name(precision));
    CHECK(std::count_if(expected.begin(), expected.end(), [](const Hit& hit) { return hit.instance >= 0; }) > 100);
    // The others in robust: test_trees_equal_lists.
    for (const int tree : precision == Precision::fp64 ? std::vector{8, 2} : std::vector{16, 4}) {
      INFO("width " << tree);
      Intersector trees(on, q.scene, settings_of(precision, tree, Acceleration::tree));
      CHECK(trees.stats().tree.nodes > 0);
      CHECK(differing(trees.trace(rays), expected) == 0);
      const std::vector<Hit> any = trees.trace(rays, true);
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < any.size(); ++i) wrong += (any[i].t == 0) != (expected[i].shape >= 0);
      CHECK(wrong == 0);
    }
    if (precision == Precision::fp64) CHECK(differing(HostTracer<double>(q.scene, 8).trace(rays), expected) == 0);
  }
}

}  // namespace

TEST_CASE("Instances that are only moved are hit as their shapes would be, bit for bit") {
  hold_moved(Precision::robust);
}

TEST_CASE("Instances that are only moved are hit as their shapes would be, in double", "[slow]") {
  hold_moved(Precision::fp64);
}

TEST_CASE("On the host that holds for every kind of shape") {
  InstancedMaker maker(8);
  const Scene scene = maker.scene(30, [&](int) { return moved_by(whole(maker.random())); });
  const Scene flat = flattened(scene);
  const std::vector<Ray> rays = on_grid(maker.rays(4000));
  const auto hits = HostTracer<double>(scene, 8).trace(rays), expected = HostTracer<double>(flat, 8).trace(rays);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
    wrong += hits[i].t != expected[i].t || hits[i].primitive != expected[i].primitive ||
             flat_shape(scene, hits[i]) != expected[i].shape || hits[i].u != expected[i].u ||
             hits[i].v != expected[i].v;
  CHECK(wrong == 0);
}

TEST_CASE("With instances trees of every width find what lists find") { hold_trees(Precision::robust); }

TEST_CASE("With instances trees of every width find what lists find, and the host the same, in double", "[slow]") {
  hold_trees(Precision::fp64);
}

TEST_CASE("Hits of instances are described in lanes as one by one, of the other kinds, too") {
  InstancedMaker maker(31);
  const Scene scene =
      maker.scene(20, [&](int i) { return distorted(maker.random(), i); }, {"disk", "cylinder", "rectangle"});
  const std::vector<Ray> rays = maker.rays(20000);
  const auto traced = [&](int width) {
    return Intersector(device(), scene, settings_of(Precision::robust, width, Acceleration::list)).trace(rays);
  };
  const std::vector<Hit> expected = traced(4);
  CHECK(std::count_if(expected.begin(), expected.end(), [](const Hit& hit) { return hit.instance >= 0; }) > 5000);
  CHECK(differing(traced(16), expected) == 0);
}

TEST_CASE("A distorted group is hit where its distorted shapes would be") {
  const std::vector<std::string> names = {"triangle", "rectangle", "cube", "mesh"};
  InstancedMaker maker(11);
  const Scene scene = maker.scene(
      30, [&](int i) { return distorted(maker.random(), i); }, names);
  const std::vector<Ray> rays = maker.rays(20000);
  const auto hits = HostTracer<double>(scene, 1).trace(rays),
             expected = HostTracer<double>(flattened(scene), 1).trace(rays);
  int instanced = 0, others = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool same = hits[i].primitive == expected[i].primitive && flat_shape(scene, hits[i]) == expected[i].shape;
    // Rays are aimed at corners and edges, which either of two shapes may have.
    if (!same) ++others;
    if (!same || hits[i].instance < 0) continue;
    ++instanced;
    const Instance& instance = scene.instances[static_cast<std::size_t>(hits[i].instance)];
    const bool is_mirrored = instance.world_from_group.determinant() < 0;
    // Corners in the other sense turn the normal of the flat shape, but a cube's, which faces outwards as built.
    const auto& shape =
        scene.groups[static_cast<std::size_t>(instance.group)].shapes[static_cast<std::size_t>(hits[i].shape)];
    const bool is_turned = is_mirrored && !std::holds_alternative<Cube>(shape.geometry);
    CHECK(distance(hits[i].normal, is_turned ? -expected[i].normal : expected[i].normal) < 0x1p-40);
    CHECK(length((hits[i].t - expected[i].t) * rays[i].direction) <= 0x1p-36);
  }
  CHECK(instanced > 8000);
  CHECK(others < 2000);
}

TEST_CASE("A sphere that is scaled unevenly is an ellipsoid, hit from outside and inside") {
  const Scene scene = with_group(Sphere{}, {moved_by({10, 0, 0}) * scaled_by(3, 2, -0.5)});
  on_host(scene, [&](const auto& host, double tolerance) {
    const Hit along_x = host.trace(Ray{{0, 0, 0}, {1, 0, 0}}), along_z = host.trace(Ray{{10, 0, -4}, {0, 0, 2}});
    CHECK(std::fabs(along_x.t - 7) <= tolerance);
    CHECK(distance(along_x.normal, {-1, 0, 0}) <= tolerance);
    CHECK(along_z.t == 1.75);
    CHECK(along_z.instance == 0);
    CHECK(distance(along_z.normal, {0, 0, -1}) <= tolerance);
    Ray inside{{10, 0, -0.5}, {0, 0, 1}};
    inside.instance = inside.shape = inside.primitive = 0;
    CHECK(host.trace(inside).t == 1);
    inside.direction = {0, 0, -1};
    CHECK(host.trace(inside).shape == -1);
    // x = 3 cos a, y = 2 sin a: the normal there is that of the ellipse.
    const Hit slanting = host.trace(Ray{{10 + 3 * 0.6, 20, 0}, {0, -1, 0}});
    CHECK(std::fabs(slanting.t - (20 - 2 * 0.8)) <= 32 * tolerance);
    CHECK(distance(slanting.normal, normalized({0.6 / 3, 0.8 / 2, 0})) <= 8 * tolerance);
  });
}

TEST_CASE("Of equal hits that of the scene itself counts, then that of the first instance") {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  Scene scene = with_group(box, std::vector<Transform>(40));
  const Ray ray{{0.25, 0.25, -5}, {0, 0, 1}};
  on_host(scene, [&](const auto& host, double) {
    CHECK(host.trace(ray).t == 4);
    CHECK(host.trace(ray).instance == 0);
    Ray left = ray;
    left.origin.z = -1;
    left.instance = left.shape = left.primitive = 0;
    CHECK(host.trace(left).instance == 1);
    CHECK(host.trace(left).t == 0);
    left.instance = 7;
    CHECK(host.trace(left).instance == 0);
    left.instance = -1;
    left.shape = -1;
    CHECK(host.trace(left).instance == 0);
  });
  add(scene, box);
  on_host(scene, [&](const auto& host, double) {
    CHECK(host.trace(ray).instance == -1);
    CHECK(host.trace(ray).shape == 0);
    Ray left = ray;
    left.origin.z = -1;
    left.shape = left.primitive = 0;
    CHECK(host.trace(left).instance == 0);
  });
}

TEST_CASE("A hundred thousand instances of a group take its memory once") {
  InstancedMaker maker(3);
  const Scene scene = maker.scene(
      100000,
      [&](int i) {
        const Vec3 by{40.0 * (i % 50), 40.0 * (i / 50 % 50), 40.0 * (i / 2500)};
        Transform transform = distorted(maker.random(), i);
        for (std::size_t row = 0; row < 3; ++row) transform.m[row][3] += row == 0 ? by.x : row == 1 ? by.y : by.z;
        return transform;
      },
      kind_names);
  const std::vector<Ray> rays = maker.rays(2000);
  const Device on = device();
  Intersector trees(on, scene, settings_of(Precision::robust, 16, Acceleration::tree));
  CHECK(trees.stats().device_bytes < 30'000'000);
  const std::vector<Hit> hits = trees.trace(rays);
  CHECK(std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.instance > 1000; }) > 1000);
  CHECK(differing(Intersector(on, scene, settings_of(Precision::robust, 4, Acceleration::tree)).trace(rays), hits) ==
        0);
  const std::vector<Ray> few(rays.begin(), rays.begin() + 100);
  Intersector lists(on, scene, settings_of(Precision::robust, 16, Acceleration::list));
  CHECK(differing(lists.trace(few), {hits.begin(), hits.begin() + 100}) == 0);
}

TEST_CASE("Rays name what they left in an instance that is there, and a shape of its group") {
  InstancedMaker maker(3);
  const Scene scene = maker.scene(
      2,
      [](int i) {
        return moved_by({200.0 * i, 0, 0});
      },
      kind_names);
  const int shapes = static_cast<int>(scene.groups[0].shapes.size());
  Intersector intersector(device(), scene, settings_of(Precision::robust, 16, Acceleration::list));
  const auto left = [](int instance, int shape) {
    Ray ray{{0, 0, 0}, {1, 0, 0}};
    ray.instance = instance;
    ray.shape = shape;
    ray.primitive = 0;
    return std::vector{ray};
  };
  CHECK_NOTHROW(intersector.trace(left(1, shapes - 1)));
  CHECK_THROWS_WITH(static_cast<void>(intersector.trace(left(2, 0))),
                    "ray 0: instance 2 does not exist (0 to 1, or -1)");
  CHECK_THROWS_WITH(static_cast<void>(intersector.trace(left(1, shapes))),
                    Catch::Contains("does not exist in instance 1 (0 to " + std::to_string(shapes - 1) + ", or -1)"));
}

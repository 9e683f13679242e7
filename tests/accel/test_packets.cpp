// SPDX-License-Identifier: MIT
// Packets find what rays find alone, bit for bit: random scenes, by lists and by trees, near and
// far off; bundles of rays that are alike, that part, that are mixed with unlike and with unusable ones; rays that have
// left something; closest hit and any hit; counts that fill no packet. In fast, where a compiler may take sums as it
// likes and infinities for what it likes, usable rays that differ are counted.
// STRAHL_RAYS: how many a tier and width; STRAHL_DEVICE: where.
#include <fmt/format.h>

#include <limits>

#include "cl/instanced_scenes.h"
#include "cl/same_bits.h"
#include "program/kernel_files.h"
#include "support/asked.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

constexpr int scenes = 12;
constexpr std::size_t bundle = 32;

std::size_t rays_asked() { return static_cast<std::size_t>(count_asked_for("STRAHL_RAYS", 240'000)); }

Device device() { return Device::open(device_asked_for()); }

/// What a packet must not be led astray by.
void spoil(Ray& ray, int how) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  switch (how) {
    case 0:
      ray.direction = {0, 0, 0};
      break;
    case 1:
      ray.direction.y = nan;
      break;
    case 2:
      ray.origin.x = infinite;
      break;
    case 3:
      ray.t_max = nan;
      break;
    case 4:
      ray.t_min = 2;
      ray.t_max = 1;
      break;
    case 5:
      ray.direction = -ray.direction;
      break;
    case 6:
      ray.direction.z = 0;
      break;
    case 7:
      ray.t_min = -infinite;
      break;
    default:
      ray.direction = 1e-30 * ray.direction;
  }
}

/// Bundles about the rays of a maker: ever wider, now and then from one point, with a spoilt one in some.
template <class Maker>
std::vector<Ray> bundles(Maker& maker, std::size_t count, bool with_spoilt) {
  const std::vector<Ray> leaders = maker.rays(count / bundle + 1);
  oracle::Random random(7);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < leaders.size(); ++i) {
    const double width = std::pow(10.0, -1.0 * static_cast<double>(i % 6)), size = length(leaders[i].direction);
    const auto by = [&] { return width * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
    for (std::size_t k = 0; k < bundle; ++k) {
      Ray ray = leaders[i];
      if (i % 3 != 0) ray.origin = ray.origin + by();
      if (i % 8 != 0) ray.direction = ray.direction + size * by();
      if (with_spoilt && i % 4 == 0 && k % 5 == 0) spoil(ray, static_cast<int>((i / 4 + k) % 9));
      rays.push_back(ray);
    }
  }
  rays.resize(count - 5);
  return rays;
}

/// As many again that go on from where the first ones ended, neighbours still alike.
void add_departing(std::vector<Ray>& rays, const std::vector<Hit>& hits) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    Ray ray = rays[i];
    if (hits[i].shape >= 0) {
      ray.origin = ray.origin + hits[i].t * ray.direction;
      ray.instance = hits[i].instance;
      ray.shape = hits[i].shape;
      ray.primitive = hits[i].primitive;
      ray.t_min = 0;
      if (i / bundle % 2 == 0)
        ray.direction = ray.direction - (2 * dot(hits[i].normal, ray.direction)) * hits[i].normal;
    }
    rays.push_back(ray);
  }
}

struct Tally {
  std::size_t rays = 0, hits = 0, instanced = 0, differing = 0, any_differing = 0;
};

/// The rays, and as many that depart, in one way and in another.
void compare(const Device& on, const Scene& scene, std::vector<Ray> rays, const RenderSettings& one,
             const RenderSettings& other, Tally& tally) {
  Intersector alone(on, scene, one), together(on, scene, other);
  add_departing(rays, alone.trace(rays));
  const std::vector<Hit> expected = alone.trace(rays), hits = together.trace(rays), any = together.trace(rays, true);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit &a = hits[i], &b = expected[i];
    const bool same = is_same(a, b, true) && a.instance == b.instance;
    const Ray& r = rays[i];
    if (!same && tally.differing == 0)
      UNSCOPED_INFO("ray " << i << ": o " << r.origin.x << " " << r.origin.y << " " << r.origin.z << " d "
                           << r.direction.x << " " << r.direction.y << " " << r.direction.z << ": " << a.instance << "/"
                           << a.shape << "/" << a.primitive << " t " << a.t << ", alone " << b.instance << "/"
                           << b.shape << "/" << b.primitive << " t " << b.t);
    ++tally.rays;
    tally.hits += b.shape >= 0;
    tally.instanced += b.instance >= 0;
    tally.differing += !same;
    tally.any_differing += (any[i].t == 0) != (b.shape >= 0);
  }
}

/// Alone and in packets.
void compare(const Device& on, const Scene& scene, const std::vector<Ray>& rays, const RenderSettings& settings,
             Tally& tally) {
  RenderSettings coherent = settings;
  coherent.coherent = true;
  compare(on, scene, rays, settings, coherent, tally);
}

const std::vector<std::string> round_kinds = {"sphere", "plane", "disk"},
                               flat_kinds = {"triangle", "mesh", "rectangle", "cube"};

/// Whatever has no body for packets, as the kernels say (cl/accel/packet_kinds.h).
std::vector<std::string> other_kinds() {
  std::vector<std::string> kinds;
  for (const std::string& kind : list_entries("shapes")) {
    const std::string text = kernel_files().at(fmt::format("shapes/{0}/{0}_lanes.h", kind));
    for (const std::string none : {"NONE", "CYLINDER"})
      if (text.find(fmt::format("PACKET_BODY_{}_w = PACKET_BODY_{}", kind, none)) != std::string::npos)
        kinds.push_back(kind);
  }
  return kinds;
}

/// Every other ray ends a few last places, or a thousandth of its way, beside where it went: past an edge or a corner.
void graze(std::vector<Ray>& rays) {
  oracle::Random random(11);
  for (std::size_t i = 0; i < rays.size(); i += 2) {
    const double off = length(rays[i].direction) * std::ldexp(1.0, -random.integer(10, 26));
    const Vec3 by{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    rays[i].direction = rays[i].direction + off * by;
  }
}

/// Some kinds, all of them listed and in a tree: listed, their rays are in lanes however unlike they are.
Tally compare_listed(const std::vector<std::string>& kinds, Precision precision, int lanes, std::size_t count) {
  Tally tally;
  for (int number = 0; number < 4; ++number) {
    SceneMaker maker(3000 + static_cast<std::uint64_t>(number));
    for (const std::string& kind : kinds)
      maker.add(kind, kind == "plane" ? 1 + number : (number == 3 ? 1 : 4 + 7 * number));
    std::vector<Ray> rays = maker.rays(count / 8);
    for (std::size_t i = 0; i < rays.size() && precision != Precision::fast; i += 13)
      spoil(rays[i], static_cast<int>(i % 9));
    const std::vector<Ray> alike = bundles(maker, count / 8, precision != Precision::fast);
    rays.insert(rays.end(), alike.begin(), alike.end());
    graze(rays);
    const Vec3 by = number == 2 ? Vec3{100'000, -30'000, 0.5} : Vec3{};
    for (Ray& ray : rays) ray.origin = ray.origin + by;
    RenderSettings tree, list;
    tree.precision = list.precision = precision;
    tree.lanes = list.lanes = lanes;
    tree.acceleration = Acceleration::tree;
    list.acceleration = Acceleration::list;
    compare(device(), translated(maker.scene(), by), rays, tree, list, tally);
  }
  return tally;
}

Tally compare(Precision precision, int lanes) {
  Tally tally;
  const Device on = device();
  for (int number = 0; number < scenes; ++number) {
    SceneMaker maker(2000 + static_cast<std::uint64_t>(number));
    // Kinds that packets have a body for, and one that they have none for: programs of all kinds take long to compile.
    for (const std::string name : {"sphere", "triangle", "mesh", "box"}) maker.add(name, 2 + 5 * number);
    std::vector<Ray> rays = bundles(maker, rays_asked() / scenes / 2, precision != Precision::fast);
    const Vec3 by = number % 4 == 3 ? Vec3{100'000, -30'000, 0.5} : Vec3{};
    for (Ray& ray : rays) ray.origin = ray.origin + by;
    RenderSettings settings;
    settings.generic = asks_generic();
    settings.precision = precision;
    settings.lanes = lanes;
    settings.acceleration = number % 3 == 0 ? Acceleration::list : Acceleration::tree;
    compare(on, translated(maker.scene(), by), rays, settings, tally);
  }
  return tally;
}

void hold_same(Precision precision, int lanes) {
  INFO(precision_name(precision) << ", " << lanes << " lanes");
  const Tally tally = compare(precision, lanes);
  CHECK(tally.hits > tally.rays / 4);
  CHECK(tally.differing == 0);
  CHECK(tally.any_differing == 0);
}

}  // namespace

TEST_CASE("Packets find the bits that single rays find") { hold_same(Precision::robust, 16); }

TEST_CASE("Packets find the bits that single rays find in instances") {
  Tally tally;
  for (const Acceleration acceleration : {Acceleration::list, Acceleration::tree}) {
    InstancedMaker maker(3);
    const Scene scene =
        maker.scene(20, [&](int number) { return distorted(maker.random(), number); }, {"sphere", "triangle"});
    RenderSettings settings;
    settings.generic = asks_generic();
    settings.lanes = 16;
    settings.acceleration = acceleration;
    compare(device(), scene, bundles(maker, 20'000, true), settings, tally);
  }
  CHECK(tally.instanced > tally.rays / 8);
  CHECK(tally.differing == 0);
  CHECK(tally.any_differing == 0);
}

TEST_CASE("Lists of spheres and planes and disks find in lanes what a tree finds ray by ray") {
  const Tally tally = compare_listed(round_kinds, Precision::robust, 16, rays_asked() / 2);
  CHECK(tally.hits > tally.rays / 4);
  CHECK(tally.differing == 0);
  CHECK(tally.any_differing == 0);
}

TEST_CASE("Lists of flat polygons find in lanes what a tree finds ray by ray") {
  const Tally tally = compare_listed(flat_kinds, Precision::robust, 16, rays_asked() / 2);
  CHECK(tally.hits > tally.rays / 4);
  CHECK(tally.differing == 0);
  CHECK(tally.any_differing == 0);
}

TEST_CASE("Lists of kinds without a body find in lanes what a tree finds ray by ray") {
  const Tally tally = compare_listed(other_kinds(), Precision::robust, 16, rays_asked() / 2);
  CHECK(tally.hits > tally.rays / 4);
  CHECK(tally.differing == 0);
  CHECK(tally.any_differing == 0);
}

// Programs take seconds to compile.
TEST_CASE("Packets of every tier and width", "[slow]") {
  hold_same(Precision::robust, 8);
  hold_same(Precision::fp64, 8);
  hold_same(Precision::stable, 16);
  hold_same(Precision::stable, 8);
  CHECK(compare_listed(round_kinds, Precision::stable, 16, rays_asked()).differing == 0);
  for (const auto& kinds : {round_kinds, flat_kinds, other_kinds()}) {
    CHECK(compare_listed(kinds, Precision::robust, 8, rays_asked()).differing == 0);
    CHECK(compare_listed(kinds, Precision::stable, 8, rays_asked()).differing == 0);
    CHECK(compare_listed(kinds, Precision::fast, 16, rays_asked()).differing < rays_asked() / 1000);
  }
  const Tally tally = compare(Precision::fast, 16);
  WARN(tally.differing << " of " << tally.rays << " rays differ in fast, " << tally.any_differing
                       << " of any-hit rays");
  CHECK(tally.differing < tally.rays / 1000);
  CHECK(tally.any_differing < tally.rays / 1000);
}

// SPDX-License-Identifier: MIT
// Large numbers of rays from inside closed surfaces, at their shared edges and vertices, in the robust tier on a
// device. Convex ones (valence 3 ... 64, lattices along the axes, needles, sizes 10^-6 ... 10^6, 10^6 away) are hit
// exactly once, rooms of six rectangles too; of a torus an odd number of triangles is hit.
//
// STRAHL_RAYS: so many rays a test instead of 10^7. More: campaign/progress.h.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "campaign/progress.h"
#include "scene/model/transforms.h"
#include "selftest/closed_meshes.h"
#include "selftest/nearest.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::selftest;

namespace {

constexpr std::size_t rays_a_surface = 125000;

struct SeamTally {
  std::uint64_t rays = 0, leaks = 0, doubles = 0;

  void add(const SeamTally& c) { rays += c.rays, leaks += c.leaks, doubles += c.doubles; }
  friend std::ostream& operator<<(std::ostream& out, const SeamTally& c) {
    return out << c.rays << ' ' << c.leaks << ' ' << c.doubles;
  }
  friend std::istream& operator>>(std::istream& in, SeamTally& c) { return in >> c.rays >> c.leaks >> c.doubles; }
};

/// A turn, a size of 10^-6 ... 10^6 and a place up to 10^4 sizes (or, large, 10^6) away; every other one stays along
/// the axes.
struct Placement {
  explicit Placement(oracle::Random& random) {
    size = std::pow(10.0, random.integer(-6, 6));
    const double off = random.integer(0, 2) == 0 ? 0 : random.integer(0, 1) == 0 ? 1e4 * size : 1e6;
    if (off <= 1e4 * size) center = off * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (random.integer(0, 1) == 0)
      turn = rotation({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)}, random.uniform(0, 360));
  }
  [[nodiscard]] Vec3 operator()(const Vec3& p) const { return to_float(center + size * turn.vector(p)); }

  double size = 1;
  Vec3 center;
  Transform turn;
};

ClosedSurface mesh_surface(const std::vector<Vec3>& unit, const std::vector<std::array<int, 3>>& triangles,
                           const Placement& place, double inner) {
  Mesh mesh;
  for (const Vec3& p : unit) mesh.positions.push_back(place(p));
  mesh.triangles = triangles;
  ClosedSurface surface = surface_of(mesh, place.center, inner * place.size, mesh.positions);
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] < t[(i + 1) % 3])
        surface.edges.emplace_back(static_cast<std::size_t>(t[i]), static_cast<std::size_t>(t[(i + 1) % 3]));
  return surface;
}

/// Two fans of n triangles over one ring: two vertices of valence n.
ClosedSurface fans(int n, double height, const Placement& place) {
  std::vector<Vec3> unit = {{0, 0, height}, {0, 0, -height}};
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    unit.push_back({std::cos(angle), std::sin(angle), 0});
    const int a = 2 + i, b = 2 + (i + 1) % n;
    triangles.push_back({0, a, b});
    triangles.push_back({1, b, a});
  }
  const double ring = std::cos(M_PI / n);
  return mesh_surface(unit, triangles, place, 0.5 * ring * height / std::hypot(ring, height));
}

/// A cube with n x n squares a side, two triangles each, its vertices on a lattice.
ClosedSurface lattice(int n, const Placement& place) {
  std::vector<Vec3> unit;
  std::vector<std::array<int, 3>> triangles;
  std::map<std::array<int, 3>, int> known;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = known.try_emplace(at, static_cast<int>(unit.size()));
    if (is_new) unit.push_back({2.0 * at[0] / n - 1, 2.0 * at[1] / n - 1, 2.0 * at[2] / n - 1});
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int di, int dj) {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            return vertex(p);
          };
          triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
          triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
  return mesh_surface(unit, triangles, place, 0.5);
}

ClosedSurface convex_mesh(std::uint64_t number) {
  oracle::Random random(number + 1);
  const Placement place(random);
  switch (number % 4) {
    case 0:
      return fans(random.integer(3, 64), random.uniform(0.3, 2), place);
    case 1:
      return fans(random.integer(3, 64), std::pow(10.0, random.integer(1, 3)), place);  // needles
    case 2:
      return lattice(1 << random.integer(0, 2), place);
    default:
      return icosphere(place.center, place.size, 1);
  }
}

/// Six rectangles that share corners, every one a shape of its own.
ClosedSurface rectangles(std::uint64_t number) {
  oracle::Random random(number + 1);
  const Placement place(random);
  const Vec3 a = place({-1, -1, -1}), x = place({1, -1, -1}) - a, y = place({-1, 1, -1}) - a,
             z = place({-1, -1, 1}) - a;
  ClosedSurface surface = room({a, {x, y, z}});
  surface.scene.shapes.clear();
  for (const auto& [corner, u, v] : std::array<std::array<Vec3, 3>, 6>{
           {{a, x, y}, {a + z, x, y}, {a, y, z}, {a + x, y, z}, {a, z, x}, {a + y, z, x}}})
    surface.scene.shapes.emplace_back().geometry = Rectangle{corner, u, v};
  return surface;
}

SeamTally ask(const Device& device, const ClosedSurface& surface, std::uint64_t seed) {
  RenderSettings settings;
  settings.precision = Precision::robust;
  Intersector intersector(device, surface.scene, settings);
  std::vector<Ray> rays = rays_at_seams(surface, rays_a_surface, seed);
  SeamTally count;
  count.rays = rays.size();
  const std::vector<Hit> hits = intersector.trace(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    count.leaks += hits[i].shape < 0;
    rays[i].shape = hits[i].shape;
    rays[i].primitive = hits[i].primitive;
  }
  // What is flat and was left is not hit anywhere, so whatever is hit now was hit as well.
  for (const Hit& hit : intersector.trace(rays)) count.doubles += hit.shape >= 0;
  return count;
}

void hold(const std::string& name, ClosedSurface (*surface)(std::uint64_t)) {
  test::require_pocl_and_rusticl();
  const Device device = Device::open(test::device_asked_for());
  test::Progress<SeamTally> progress;
  const double wanted = test::count_asked_for("STRAHL_RAYS", 1e7);
  SeamTally total;
  for (std::uint64_t number = 0; static_cast<double>(total.rays) < wanted; ++number) {
    const std::string chunk = name + "/" + std::to_string(number);
    const SeamTally* known = progress.find(chunk);
    const SeamTally count = known ? *known : ask(device, surface(number), number);
    if (!known) progress.finished(chunk, count);
    if (count.leaks + count.doubles > 0) UNSCOPED_INFO("number " << number << ": " << count);
    total.add(count);
  }
  std::cout << name << ": " << total.rays << " rays, " << total.leaks << " leaks, " << total.doubles << " double hits"
            << std::endl;
  CHECK(total.leaks == 0);
  CHECK(total.doubles == 0);
}

}  // namespace

TEST_CASE("convex meshes") { hold("meshes", convex_mesh); }
TEST_CASE("rooms of rectangles") { hold("rooms", rectangles); }

TEST_CASE("an odd number of a torus' triangles") {
  constexpr int around = 12, across = 8;
  std::vector<Vec3> vertices;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = 2 * M_PI * i / around, b = 2 * M_PI * j / across, r = 2 + 0.75 * std::cos(b);
      vertices.push_back(to_float(Vec3{r * std::cos(a), r * std::sin(a), 0.75 * std::sin(b)}));
    }
  std::vector<std::array<double, 9>> triangles;
  const auto at = [&](int i, int j) { return vertices[static_cast<std::size_t>(i % around * across + j % across)]; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
      for (const auto& [a, b, c] :
           {std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)}})
        triangles.push_back({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
  oracle::Random random(9);
  constexpr int rays = 100000;
  int even = 0, many = 0;
  for (int ray = 0; ray < rays; ++ray) {
    const double angle = 2 * M_PI * random.uniform();
    const auto off = [&] { return random.uniform(-0.2, 0.2); };
    const Vec3 o = to_float(Vec3{1.9 * std::cos(angle) + off(), 1.9 * std::sin(angle) + off(), off()});
    const int i = random.integer(0, around - 1), j = random.integer(0, across - 1);
    const double share = ray % 3 == 0 ? 0 : random.uniform();
    const Vec3 d = to_float(at(i, j) + share * (at(i + 1, j + ray % 2) - at(i, j)) - o);
    const std::array<double, 8> given{o.x, o.y, o.z, d.x, d.y, d.z, 0, INFINITY};
    int hits = 0;
    for (const auto& planes : triangles) hits += std::isfinite(test::nearest_robust("triangle", planes, given, -1).t);
    even += hits % 2 == 0;
    many += hits > 1;
  }
  CHECK(even == 0);
  CHECK(many > rays / 10);
}

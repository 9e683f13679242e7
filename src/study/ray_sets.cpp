// SPDX-License-Identifier: MIT
#include "study/ray_sets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "packing/cl_layout.h"
#include "packing/pack_camera.h"
#include "study/generated/stage.h"
#include "study/hashed.h"

namespace strahl {
namespace {

bool is_point(const Light& light) { return std::holds_alternative<PointLight>(light.emitter); }

struct Pixel {
  int x = 0, y = 0;
};

/// Bits 0, 2 and 1, 3 of `i`: x and y within a square of 4 x 4.
Pixel within_four(int i) { return {(i & 1) | ((i >> 1) & 2), ((i >> 1) & 1) | ((i >> 2) & 2)}; }

std::vector<Pixel> tiled(int width, int height) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < height; y += 16)
    for (int x = 0; x < width; x += 16)
      for (int i = 0; i < 256; ++i) {
        const Pixel outer = within_four(i >> 4), inner = within_four(i & 15);
        const Pixel pixel{x + 4 * outer.x + inner.x, y + 4 * outer.y + inner.y};
        if (pixel.x < width && pixel.y < height) pixels.push_back(pixel);
      }
  return pixels;
}

/// Where a ray met something, lifted off it towards where it came from so that no program meets it again.
struct Departure {
  Vec3 point;
  Vec3 normal;
};

Departure departure(const Ray& ray, const Hit& hit) {
  const Vec3 normal = dot(hit.normal, ray.direction) > 0 ? -hit.normal : hit.normal;
  const Vec3 way = hit.t * ray.direction;
  return {to_float(ray.origin + way + (0x1p-16 * length(way)) * normal), normal};
}

template <typename Direction>
RaySet leaving(RayKind kind, const RaySet& primary, const std::vector<Hit>& hits, double t_max, Direction direction) {
  RaySet set{kind, {}};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].shape < 0) continue;
    const Departure from = departure(primary.rays[i], hits[i]);
    const Vec3 towards = to_float(direction(i, from));
    if (length(towards) > 0) set.rays.push_back({from.point, towards, 0, t_max});
  }
  return set;
}

}  // namespace

const char* ray_kind_name(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return "primary";
    case RayKind::shadow:
      return "shadow";
    case RayKind::diffuse:
      return "diffuse";
  }
  return "";
}

RaySet primary_rays(const Scene& scene) {
  const Film& film = scene.film;
  const std::vector<double> camera = camera_reals(scene.camera, film, UploadFrame{});
  const auto vec = [&camera](int at) {
    const double* v = &camera[static_cast<std::size_t>(at)];
    return Vec3{v[0], v[1], v[2]};
  };
  const Vec3 o = vec(layout::CAMERA_O), ox = vec(layout::CAMERA_OX), oy = vec(layout::CAMERA_OY);
  const Vec3 d = vec(layout::CAMERA_D), dx = vec(layout::CAMERA_DX), dy = vec(layout::CAMERA_DY);
  RaySet set;
  for (const Pixel& pixel : tiled(film.width, film.height)) {
    const double sx = (2.0 * pixel.x + 1) / film.width - 1, sy = (2.0 * pixel.y + 1) / film.height - 1;
    set.rays.push_back({to_float(o + sx * ox + sy * oy), to_float(normalized(d + sx * dx + sy * dy))});
  }
  return set;
}

void add_missing_point_light(Scene& scene) {
  if (std::any_of(scene.lights.begin(), scene.lights.end(), is_point)) return;
  const Transform& camera = scene.camera.world_from_camera;
  scene.lights.push_back({"", PointLight{camera.point({-1, 1, 0})}, {}});
}

RaySet shadow_rays(const Scene& scene, const RaySet& primary, const std::vector<Hit>& hits) {
  const auto lamp = std::find_if(scene.lights.begin(), scene.lights.end(), is_point);
  if (lamp == scene.lights.end()) throw InputError("shadow rays need a point light, and the scene has none");
  const Vec3 to = std::get<PointLight>(lamp->emitter).position;
  return leaving(RayKind::shadow, primary, hits, 1,
                 [&to](std::size_t, const Departure& from) { return to - from.point; });
}

RaySet diffuse_rays(const RaySet& primary, const std::vector<Hit>& hits) {
  return leaving(RayKind::diffuse, primary, hits, std::numeric_limits<double>::infinity(),
                 [](std::size_t i, const Departure& from) {
                   const auto [s, t] = orthonormal_basis(from.normal);
                   const double square = hashed_uniform(2 * i), turn = 2 * std::numbers::pi * hashed_uniform(2 * i + 1);
                   const double radius = std::sqrt(square);
                   return radius * std::cos(turn) * s + radius * std::sin(turn) * t +
                          std::sqrt(1 - square) * from.normal;
                 });
}

}  // namespace strahl

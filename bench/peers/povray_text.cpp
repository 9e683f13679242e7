// SPDX-License-Identifier: MIT
// POV-Ray 3.7's scene language. Its camera takes any three vectors, so its left-handedness does not matter; its lamps
// fade as 2 / (1 + (d / fade_distance)^2), which is 1 / d^2 where fade_distance is small.
#include <fmt/format.h>

#include <iterator>
#include <numbers>

#include "bench/scene_files.h"

namespace strahl::bench {
namespace {

std::string pov_vector(const Vec3& v) { return fmt::format("<{},{},{}>", v.x, v.y, v.z); }

struct PovShapes {
  std::string& text;

  template <typename... Values>
  void add(const char* format, const Values&... values) {
    fmt::vformat_to(std::back_inserter(text), format, fmt::make_format_args(values...));
  }
  void operator()(const Sphere& s) { add("sphere{{{},{}}}\n", pov_vector(s.center), s.radius); }
  void operator()(const Box& b) { add("box{{{},{}}}\n", pov_vector(b.min), pov_vector(b.max)); }
  void operator()(const Plane& p) {
    const Vec3 n = normalized(p.normal);
    add("plane{{{},{}}}\n", pov_vector(n), dot(n, p.point));
  }
  void operator()(const Triangle& t) {
    add("triangle{{{},{},{}}}\n", pov_vector(t.p0), pov_vector(t.p1), pov_vector(t.p2));
  }
  void operator()(const Rectangle& r) {
    const Vec3 far = r.corner + r.edge_u + r.edge_v;
    (*this)(Triangle{r.corner, r.corner + r.edge_u, far});
    (*this)(Triangle{r.corner, far, r.corner + r.edge_v});
  }
  void operator()(const Mesh& mesh) {
    add("mesh2{{vertex_vectors{{{}", mesh.positions.size());
    for (const Vec3& p : mesh.positions) add(",{}", pov_vector(p));
    add("}}face_indices{{{}", mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) add(",<{},{},{}>", a, b, c);
    add("}}}}\n");
  }
  template <typename Other>
  void operator()(const Other&) const {
    throw Error("strahl-bench scene writes no such shape for POV-Ray");
  }
};

}  // namespace

std::string povray_text(const Scene& scene) {
  constexpr double fade = 0x1p-7;
  const Looks looks = looks_of(scene);
  std::string text = fmt::format(
      "#version 3.7;\nglobal_settings{{assumed_gamma 1.0}}\n"
      "#default{{pigment{{rgb {}}} finish{{ambient 0 diffuse 1}}}}\n"
      "camera{{location {} direction {} right {} up {}}}\n",
      looks.grey, pov_vector(looks.eye), pov_vector(looks.forward), pov_vector(2 * looks.tangent * looks.right),
      pov_vector(2 * looks.tangent * looks.aspect * looks.up));
  for (const Light& light : scene.lights) {
    const auto& [p, i] = std::get<PointLight>(light.emitter);
    const double scale = 1 / (2 * std::numbers::pi * fade * fade);
    text += fmt::format("light_source{{{} rgb {} fade_distance {} fade_power 2}}\n", pov_vector(p),
                        pov_vector({scale * i.r, scale * i.g, scale * i.b}), fade);
  }
  PovShapes shapes{text};
  for (const Shape& shape : scene.shapes) std::visit(shapes, shape.geometry);
  return text;
}

}  // namespace strahl::bench

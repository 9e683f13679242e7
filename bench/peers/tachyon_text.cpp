// SPDX-License-Identifier: MIT
// Tachyon's scene language (J. Stone). Left-handed: written as seen in a mirror, z negated.
#include <fmt/format.h>

#include <iterator>
#include <numbers>

#include "bench/scene_files.h"

namespace strahl::bench {
namespace {

std::string tachyon_vector(const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, -v.z); }

struct TachyonShapes {
  std::string& text;

  template <typename... Values>
  void add(const char* format, const Values&... values) {
    fmt::vformat_to(std::back_inserter(text), format, fmt::make_format_args(values...));
  }
  void operator()(const Sphere& s) { add("SPHERE CENTER {} RAD {} GREY\n", tachyon_vector(s.center), s.radius); }
  void operator()(const Plane& p) {
    add("PLANE CENTER {} NORMAL {} GREY\n", tachyon_vector(p.point), tachyon_vector(normalized(p.normal)));
  }
  void operator()(const Triangle& t) {
    add("TRI V0 {} V1 {} V2 {} GREY\n", tachyon_vector(t.p0), tachyon_vector(t.p1), tachyon_vector(t.p2));
  }
  void operator()(const Rectangle& r) {
    const Vec3 far = r.corner + r.edge_u + r.edge_v;
    (*this)(Triangle{r.corner, r.corner + r.edge_u, far});
    (*this)(Triangle{r.corner, far, r.corner + r.edge_v});
  }
  void operator()(const Mesh& mesh) {
    const auto at = [&mesh](int i) { return mesh.positions[static_cast<std::size_t>(i)]; };
    for (const auto& [a, b, c] : mesh.triangles) (*this)(Triangle{at(a), at(b), at(c)});
  }
  template <typename Other>
  void operator()(const Other&) const {
    throw Error("strahl-bench scene writes no such shape for Tachyon");
  }
};

}  // namespace

std::string tachyon_text(const Scene& scene) {
  const Looks looks = looks_of(scene);
  std::string text = fmt::format(
      "BEGIN_SCENE\nRESOLUTION {} {}\nCAMERA\nZOOM {}\nASPECTRATIO 1\nANTIALIASING 0\nRAYDEPTH 1\nCENTER {}\n"
      "VIEWDIR {}\nUPDIR {}\nEND_CAMERA\nBACKGROUND 0 0 0\n"
      "TEXDEF GREY AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR {} {} {} TEXFUNC 0\n",
      scene.film.width, scene.film.height, 1 / looks.tangent / 2, tachyon_vector(looks.eye),
      tachyon_vector(looks.forward), tachyon_vector(looks.up), looks.grey, looks.grey, looks.grey);
  for (const Light& light : scene.lights) {
    const auto& [p, i] = std::get<PointLight>(light.emitter);
    text += fmt::format("LIGHT CENTER {} RAD 0.001 ATTENUATION CONSTANT 0 LINEAR 0 QUADRATIC 1 COLOR {} {} {}\n",
                        tachyon_vector(p), i.r / std::numbers::pi, i.g / std::numbers::pi, i.b / std::numbers::pi);
  }
  TachyonShapes shapes{text};
  for (const Shape& shape : scene.shapes) std::visit(shapes, shape.geometry);
  return text + "END_SCENE\n";
}

}  // namespace strahl::bench

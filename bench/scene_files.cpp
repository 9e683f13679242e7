// SPDX-License-Identifier: MIT
#include "bench/scene_files.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>

#include "image/atomic_file.h"

namespace strahl::bench {
namespace {

void write(const std::filesystem::path& path, const std::string& bytes) {
  AtomicFile file(path.string());
  file.write(bytes);
  file.commit();
}

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

struct XmlShapes {
  std::string& text;
  std::string mesh_prefix;
  int meshes = 0;

  template <typename... Values>
  void add(const char* format, const Values&... values) {
    fmt::vformat_to(std::back_inserter(text), format, fmt::make_format_args(values...));
  }
  void operator()(const Sphere& s) {
    add("<shape type=\"sphere\"><point name=\"center\" value=\"{}, {}, {}\"/><float name=\"radius\" value=\"{}\"/>"
        "<ref id=\"grey\"/></shape>\n",
        s.center.x, s.center.y, s.center.z, s.radius);
  }
  void operator()(const Box& b) {
    add("<shape type=\"box\"><point name=\"min\" value=\"{}, {}, {}\"/><point name=\"max\" value=\"{}, {}, {}\"/>"
        "<ref id=\"grey\"/></shape>\n",
        b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z);
  }
  void operator()(const Plane& p) {
    add("<shape type=\"plane\"><point name=\"point\" value=\"{}, {}, {}\"/><vector name=\"normal\" "
        "value=\"{}, {}, {}\"/><ref id=\"grey\"/></shape>\n",
        p.point.x, p.point.y, p.point.z, p.normal.x, p.normal.y, p.normal.z);
  }
  void operator()(const Rectangle& r) {
    const Vec3 u = 0.5 * r.edge_u, v = 0.5 * r.edge_v, n = normalized(cross(u, v)), c = r.corner + u + v;
    add("<shape type=\"rectangle\"><transform name=\"to_world\"><matrix value=\"{} {} {} {} {} {} {} {} {} {} {} {} "
        "0 0 0 1\"/></transform><ref id=\"grey\"/></shape>\n",
        u.x, v.x, n.x, c.x, u.y, v.y, n.y, c.y, u.z, v.z, n.z, c.z);
  }
  void operator()(const Triangle& t) {
    add("<shape type=\"triangle\"><point name=\"p0\" value=\"{}, {}, {}\"/><point name=\"p1\" value=\"{}, {}, {}\"/>"
        "<point name=\"p2\" value=\"{}, {}, {}\"/><ref id=\"grey\"/></shape>\n",
        t.p0.x, t.p0.y, t.p0.z, t.p1.x, t.p1.y, t.p1.z, t.p2.x, t.p2.y, t.p2.z);
  }
  void operator()(const Mesh&) {
    add("<shape type=\"ply\"><string name=\"filename\" value=\"{}-{}.ply\"/><ref id=\"grey\"/></shape>\n", mesh_prefix,
        meshes++);
  }
  template <typename Other>
  void operator()(const Other&) const {
    throw Error("strahl-bench scene writes no such shape");
  }
};

}  // namespace

Looks looks_of(const Scene& scene) {
  if (scene.camera.projection != Projection::perspective || scene.camera.fov_axis != FovAxis::x)
    throw Error("strahl-bench scene writes perspective cameras with fov_axis x only");
  const auto* diffuse = std::get_if<Diffuse>(&scene.materials.at(0).bsdf);
  if (diffuse == nullptr) throw Error("strahl-bench scene writes diffuse grey only");
  const Transform& camera = scene.camera.world_from_camera;
  return {camera.translation(),
          normalized(camera.column(2)),
          -normalized(camera.column(0)),
          normalized(camera.column(1)),
          std::tan(scene.camera.fov_degrees * std::numbers::pi / 360),
          static_cast<double>(scene.film.height) / scene.film.width,
          diffuse->reflectance.color.r};
}

std::string xml_text(const Scene& scene, const std::string& mesh_prefix) {
  const Looks looks = looks_of(scene);
  const Vec3 left = -looks.right, &up = looks.up, &forward = looks.forward, &eye = looks.eye;
  std::string text = fmt::format(
      "<scene version=\"3.0.0\">\n<integrator type=\"direct\"/>\n"
      "<sensor type=\"perspective\"><float name=\"fov\" value=\"{}\"/>\n"
      "<transform name=\"to_world\"><matrix value=\"{} {} {} {} {} {} {} {} {} {} {} {} 0 0 0 1\"/></transform>\n"
      "<sampler type=\"independent\"><integer name=\"sample_count\" value=\"{}\"/></sampler>\n"
      "<film type=\"hdrfilm\"><integer name=\"width\" value=\"{}\"/><integer name=\"height\" value=\"{}\"/>"
      "<rfilter type=\"box\"/></film></sensor>\n",
      scene.camera.fov_degrees, left.x, up.x, forward.x, eye.x, left.y, up.y, forward.y, eye.y, left.z, up.z, forward.z,
      eye.z, scene.sampler.sample_count.value_or(1), scene.film.width, scene.film.height);
  for (const Light& light : scene.lights) {
    const auto& [p, i] = std::get<PointLight>(light.emitter);
    text += fmt::format(
        "<emitter type=\"point\"><point name=\"position\" value=\"{}, {}, {}\"/><rgb name=\"intensity\" "
        "value=\"{}, {}, {}\"/></emitter>\n",
        p.x, p.y, p.z, i.r, i.g, i.b);
  }
  text += fmt::format(
      "<bsdf type=\"twosided\" id=\"grey\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"{}\"/></bsdf>"
      "</bsdf>\n",
      looks.grey);
  XmlShapes shapes{text, mesh_prefix};
  for (const Shape& shape : scene.shapes) std::visit(shapes, shape.geometry);
  return text + "</scene>\n";
}

std::string ply_bytes(const Mesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.triangles.size());
  for (const Vec3& p : mesh.positions)
    for (const double x : {p.x, p.y, p.z}) append(bytes, static_cast<float>(x));
  for (const auto& triangle : mesh.triangles) {
    append(bytes, static_cast<unsigned char>(3));
    for (const int i : triangle) append(bytes, i);
  }
  return bytes;
}

std::string sphere_ply_bytes(const std::vector<Sphere>& spheres) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float radius\nend_header\n",
      spheres.size());
  for (const Sphere& s : spheres)
    for (const double x : {s.center.x, s.center.y, s.center.z, s.radius}) append(bytes, static_cast<float>(x));
  return bytes;
}

void write_scene(const Scene& scene, const std::string& path) {
  const std::filesystem::path file = path;
  if (file.extension() == ".pov") return write(file, povray_text(scene));
  if (file.extension() == ".dat") return write(file, tachyon_text(scene));
  if (file.extension() != ".xml")
    throw UsageError(fmt::format("{}: a scene is written as .xml, .pov (POV-Ray) or .dat (Tachyon)", path));
  int meshes = 0;
  for (const Shape& shape : scene.shapes)
    if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
      write(file.parent_path() / fmt::format("{}-{}.ply", file.stem().string(), meshes++), ply_bytes(*mesh));
  write(file, xml_text(scene, file.stem().string()));
}

void write_scene_with_cloud(Scene scene, const std::string& path) {
  std::vector<Sphere> spheres;
  std::erase_if(scene.shapes, [&spheres](const Shape& shape) {
    const auto* sphere = std::get_if<Sphere>(&shape.geometry);
    if (sphere != nullptr) spheres.push_back(*sphere);
    return sphere != nullptr;
  });
  const std::filesystem::path file = path;
  const std::string cloud = file.stem().string() + "-spheres.ply";
  std::string text = xml_text(scene, file.stem().string());
  text.insert(
      text.rfind("</scene>"),
      fmt::format("<shape type=\"spheres\"><string name=\"filename\" value=\"{}\"/><ref id=\"grey\"/></shape>\n",
                  cloud));
  write(file.parent_path() / cloud, sphere_ply_bytes(spheres));
  write(file, text);
}

}  // namespace strahl::bench

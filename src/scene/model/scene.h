// SPDX-License-Identifier: MIT
// The scene: plain structs, always double, world frame, right-handed. Nothing here knows OpenCL.
//
// Readers (loader.h) fill it and validate it; a program that builds one by hand calls validate() (validate.h).
// Shapes keep the order of the file: their index is the `shape` column of `strahl intersect`. Groups and instances are
// no shapes and have indices of their own.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "errors.h"
#include "image/texels.h"
#include "scene/model/aovs.h"
#include "scene/model/materials.h"
#include "scene/model/media.h"
#include "scene/model/vec.h"

namespace strahl {

// ---- shapes -------------------------------------------------------------------------------------------------
// Each: world-frame geometry; u, v as documented in docs/scene-format.md.

/// Centre and radius > 0. The frame (x, y, z; orthonormal) orients u, v only.
struct Sphere {
  Vec3 center;
  double radius = 1;
  std::array<Vec3, 3> frame{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// Spheres alike but for place and size, a primitive each.
struct SphereCloud {
  struct Ball {
    Vec3 center;
    double radius = 1;
  };
  std::vector<Ball> spheres;
  std::array<Vec3, 3> frame{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  ///< As of a Sphere, the same for all.
};

/// Infinite plane through `point`. `normal` has any length > 0 and is kept as given. `u`, `v`, at right angles to it,
/// span its 2-D frame; plane_through() (build.h) chooses them.
struct Plane {
  Vec3 point;
  Vec3 normal{0, 1, 0};
  Vec3 u{1, 0, 0};
  Vec3 v{0, 0, -1};
};

/// Axis-aligned box, min <= max in every axis (flat boxes are allowed).
struct Box {
  Vec3 min, max;
};

/// Geometric normal along (p1 - p0) x (p2 - p0).
struct Triangle {
  Vec3 p0, p1, p2;
};

/// Parallelogram corner + s edge_u + t edge_v, 0 <= s, t <= 1; normal along edge_u x edge_v.
struct Rectangle {
  Vec3 corner, edge_u, edge_v;
};

/// Parallelepiped corner + sum s_i edge[i], 0 <= s_i <= 1. Six faces, normals outward whatever the handedness.
struct Cube {
  Vec3 corner;
  std::array<Vec3, 3> edge;
};

/// Centre, two perpendicular axes of equal length (the radius); normal along axis_u x axis_v.
struct Disk {
  Vec3 center, axis_u, axis_v;
};

/// Open cylinder around the segment p0 -> p1, radius > 0; `reference` (unit, perpendicular to the axis) is u = 0.
struct Cylinder {
  Vec3 p0, p1;
  double radius = 1;
  Vec3 reference{1, 0, 0};
};

/// What a group of a mesh's triangles looks like (OBJ usemtl).
struct MeshPart {
  int material = -1;  ///< Index into Scene::materials.
  std::optional<Rgb> radiance;
  int radiance_texture = -1;  ///< As a Shape's.
};

/// Values of a mesh's vertices or faces, which textures name.
struct MeshAttribute {
  std::string name;         ///< "vertex_..." or "face_...".
  std::vector<Rgb> values;  ///< As many as there are positions, or triangles; grey of a single number.
  [[nodiscard]] bool is_of_faces() const { return name.starts_with("face_"); }
};

/// Triangles over shared vertices; `normals` and `uvs` are empty or as long as `positions`.
struct Mesh {
  std::vector<Vec3> positions;
  /// Finite. They are interpolated as they are, so that lengths weigh them; readers make units of those of a file.
  /// Empty, or where 0 comes out: shade with the face normal.
  std::vector<Vec3> normals;
  std::vector<Vec2> uvs;
  std::vector<std::array<int, 3>> triangles;
  std::vector<MeshPart> parts;            ///< Empty: the shape's own material and radiance hold everywhere.
  std::vector<int> part_of_triangle;      ///< As long as `triangles` where parts is not empty.
  std::vector<MeshAttribute> attributes;  ///< Of meshes without parts.
};

using Geometry = std::variant<Sphere, Plane, Box, Triangle, Rectangle, Cube, Disk, Cylinder, Mesh, SphereCloud>;

struct Shape {
  std::string id;
  Geometry geometry;
  int material = 0;             ///< Index into Scene::materials.
  std::optional<Rgb> radiance;  ///< Area emitter: emitted on the side that the normal points to.
  std::optional<Rgb> exitance;  ///< Emitter directionalarea: W/m^2 that leave along the normal and in no other way.
  int radiance_texture = -1;    ///< Index into Scene::textures, of one that multiplies either; -1: none.
  double sampling_weight = 1;   ///< As a Light's, of what it emits.
  bool flip_normals = false;    ///< Mitsuba's flip_normals: reverses the normal as built.
  /// Of glass, and of boundaries of media that light passes as it came: where such shapes overlap the highest one is
  /// there. None: not tracked.
  std::optional<int> priority;
  std::optional<MediumBoundary> media;  ///< None: the shape is no boundary of media.
  SourceLocation where;                 ///< The <shape> element.
  SourceLocation radiance_where;        ///< The <emitter> element inside it.
};

/// Shapes that instances place, in a frame of their own. They are no part of the scene themselves. Neither planes nor
/// emitters are among them. `shape` and `primitive` of a hit count within the group.
struct Group {
  std::string id;
  std::vector<Shape> shapes;
  SourceLocation where;  ///< The <shape type="shapegroup"> element.
};

/// A group, placed. Its index in Scene::instances is the `instance` column of `strahl intersect`. Normals go through
/// the inverse transpose, whatever the handedness: what faces outwards in the group does in the world.
struct Instance {
  std::string id;
  int group = 0;  ///< Index into Scene::groups.
  Transform world_from_group;
  SourceLocation where;
};

/// Number of primitives of a shape as `strahl intersect` counts them: cube 6, mesh its triangles, cloud its spheres,
/// others 1.
[[nodiscard]] int primitive_count(const Shape& shape);

// ---- appearance ---------------------------------------------------------------------------------------------

/// Squares of 1/2 by 1/2 of u' = m0 u + m1 v + m2, v' = m3 u + m4 v + m5.
struct Checkerboard {
  Rgb color0{0.4, 0.4, 0.4};
  Rgb color1{0.2, 0.2, 0.2};
  std::array<double, 6> to_uv{1, 0, 0, 0, 1, 0};
};

/// An image over u', v' (as of a checkerboard) in [0, 1], whose first row is at v' = 0.
struct Bitmap {
  std::shared_ptr<const Texels> texels;
  TexelCurve curve;
  TextureFilter filter = TextureFilter::bilinear;
  TextureWrap wrap = TextureWrap::repeat;
  std::array<double, 6> to_uv{1, 0, 0, 0, 1, 0};
  Rgb scale{1, 1, 1};       ///< Multiplies the texels.
  Rgb mean{0.5, 0.5, 0.5};  ///< Of the texels; replaces them where textures are disabled.
};

/// What the meshes that it is on have by this name; they must have it.
struct AttributeTexture {
  std::string name;
  double scale = 1;  ///< Multiplies the values; what is above 1 then counts as 1, but for lights.
};

/// A colour that varies over a surface.
struct Texture {
  std::string id;
  std::variant<Checkerboard, Bitmap, AttributeTexture> pattern;
  SourceLocation where;
  bool is_unbounded = false;  ///< Of a light, or of values that are no shares: its colours are not held to [0, 1].
};

// ---- lights (emitters that are not shapes) --------------------------------------------------------------------

struct PointLight {
  Vec3 position;
  Rgb intensity{1, 1, 1};  ///< W/sr.
};

/// A point that shines into a cone: all of its intensity up to beam_degrees off the axis, then less, in proportion to
/// the angle, down to nothing at cutoff_degrees.
struct SpotLight {
  Vec3 position;
  Vec3 axis{0, 0, 1};          ///< The way the light travels, any length > 0.
  Rgb intensity{1, 1, 1};      ///< W/sr, on the axis.
  double cutoff_degrees = 20;  ///< Within (0, 180).
  double beam_degrees = 15;    ///< Within [0, cutoff_degrees].
  /// Index into Scene::textures, of one that multiplies the intensity; -1: none. It fills the square around the cone at
  /// a distance of 1, u along x and v along y, unit vectors that are perpendicular to the axis and each other. Its cone
  /// is narrower than 90 degrees.
  int texture = -1;
  Vec3 x{1, 0, 0}, y{0, 1, 0};
};

/// A point that shows a picture: a camera the other way round.
struct ProjectorLight {
  Vec3 position;
  /// Unit and at right angles: to the picture's left, up, and the way the light travels.
  std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  double tan_x = 0.41421356237309503, tan_y = tan_x;  ///< Of half the opening, across and up; > 0.
  Rgb irradiance{1, 1, 1};  ///< Over pi, on a plane across the axis, at distance 1, as Mitsuba has it.
  int texture = -1;         ///< Index into Scene::textures, of the picture that multiplies it; -1: none.
};

struct DirectionalLight {
  Vec3 direction{0, 0, 1};  ///< The way the light travels, any length > 0.
  Rgb irradiance{1, 1, 1};  ///< W/m^2 on a plane perpendicular to it.
};

/// A beam without width.
struct CollimatedLight {
  Vec3 position;
  Vec3 direction{0, 0, 1};  ///< The way the light travels, any length > 0.
  Rgb power{1, 1, 1};       ///< W.
};

/// Radiance of every ray that leaves the scene.
struct ConstantLight {
  Rgb radiance{1, 1, 1};
};

/// Radiance of rays that leave the scene, by a latitude-longitude image (cl/lights/envmap_lanes.h).
struct EnvironmentLight {
  std::shared_ptr<const Texels> texels;
  TexelCurve curve;
  Rgb scale{1, 1, 1};
  /// Where x, y (towards row 0) and z of the image lie in the world: orthonormal, of either handedness.
  std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  /// Draws no more than what exceeds the mean luminance; directions of materials find the rest.
  bool mis_compensation = true;
};

/// A disc in the sky, before the background.
struct SunLight {
  Vec3 direction{0, 1, 0};           ///< To its middle, any length > 0.
  double aperture_degrees = 0.5358;  ///< Of the whole disc, > 0, at most 90.
  Rgb radiance{1, 1, 1};
  Vec3 up{0, 0, 0};  ///< What is on its other side is below the horizon and dark; 0, 0, 0: there is no horizon.
};

struct Light {
  std::string id;
  std::variant<PointLight, SpotLight, ProjectorLight, DirectionalLight, CollimatedLight, ConstantLight,
               EnvironmentLight, SunLight>
      emitter;
  SourceLocation where;
  double sampling_weight = 1;  ///< Multiplies its chance to be drawn, not its light; at least 0.
};

// ---- camera, film, sampling -----------------------------------------------------------------------------------

enum class Projection { perspective, orthographic };
enum class FovAxis { x, y, diagonal, smaller, larger };

/// Camera frame as Mitsuba's: looks along +z, y up, +x to the LEFT of the picture. world_from_camera may scale.
/// Orthographic: the picture spans [-1, 1] in x of the camera frame; size comes from world_from_camera.
struct Camera {
  Projection projection = Projection::perspective;
  Transform world_from_camera;
  double fov_degrees = 50;  ///< Opening angle along fov_axis (a stated fov; a focal_length is converted).
  FovAxis fov_axis = FovAxis::x;
  /// As Mitsuba 3.9 computes it: every ray of a perspective camera goes where the ray this many picture widths to its
  /// right (heights below it) would go.
  double principal_point_offset_x = 0;
  double principal_point_offset_y = 0;
  /// A thin lens where the radius is > 0 (perspective only); what lies at focus_distance along the axis is sharp.
  double aperture_radius = 0;
  double focus_distance = 1;
  double near_clip = 0;  ///< Distances along the viewing axis. Default: nothing is clipped (Mitsuba: 1e-2 … 1e4).
  double far_clip = std::numeric_limits<double>::infinity();
  int medium = -1;  ///< Index into Scene::media, of the one around the camera; -1: none.
  int number = 0;   ///< Of its <sensor> among those of the scene, in file order.
  SourceLocation where;
};

enum class FilterKind { box, tent, gaussian, mitchell, catmullrom, lanczos };

/// Pixel reconstruction filter: how much samples around a pixel's middle count in it.
struct Filter {
  static constexpr double largest_radius = 1024;  ///< What paths from lights add to a pixel loops over its width.
  static constexpr double largest_of_cubic = 4;   ///< Of B and C.
  static constexpr int most_lobes = 4;            ///< Of the lanczos: its radius.
  FilterKind kind = FilterKind::gaussian;
  double radius = 0;  ///< Pixels. 0: the kind's own (box 0.5, tent 1, gaussian 4 stddev, lanczos 3); others have 2.
  double stddev = 0.5;
  double b = 1.0 / 3, c = 1.0 / 3;  ///< Mitchell and Netravali's B and C.
};

/// Pixels [x0, x1) x [y0, y1) of the full picture; y down.
struct Window {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
  friend bool operator==(const Window&, const Window&) = default;
};

struct Film {
  static constexpr int largest_size = 65536;  ///< Of width and height.
  int width = 768;
  int height = 576;
  std::optional<Window> crop;  ///< None: the whole picture.
  Filter filter;
  SourceLocation where;
  [[nodiscard]] Window window() const { return crop ? *crop : Window{0, 0, width, height}; }
};

/// centre: rays through the pixels' middles; what else a sample draws comes from sobol.
enum class SamplerKind { independent, sobol, centre };

struct SamplerSettings {
  std::optional<SamplerKind> kind;  ///< None: the integrator's default.
  std::optional<int> sample_count;
  std::optional<int> seed;
  SourceLocation where;
};

struct IntegratorSettings {
  std::string name = "direct";  ///< An entry of cl/integrators/integrators.def.
  int max_depth = -1;           ///< -1: no limit. Mitsuba's count: 1 = emission only, 2 = one bounce.
  int rr_depth = 5;             ///< Surfaces after which Russian roulette begins, at least 1; of all that follow paths.
  bool hide_emitters = false;
  bool strict_normals = false;  ///< Surfaces are lit where shading and geometric normal agree about the side.
  double max_distance = std::numeric_limits<double>::infinity();  ///< How far ao looks, > 0.
  std::string why;  ///< Why "auto" chose it (auto_integrator.h); empty: it was named.
  SourceLocation where;
  /// To be written beside the picture; no two have a channel in common. Whoever renders the scene decides whether its
  /// file holds them (RenderSettings::aovs).
  std::vector<NamedAov> aovs;
  SourceLocation aovs_where;
};

struct Scene {
  std::string name;                ///< The file's stem; names the picture where no -o is given.
  int lost_emitters = 0;           ///< Of its file, left out: the loader has warned of it where no light is left.
  std::vector<std::string> files;  ///< Every file that it was read from; none where a program made it.
  std::vector<Shape> shapes;
  std::vector<Group> groups;
  std::vector<Instance> instances;
  std::vector<Material> materials{Material{}};  ///< Index 0 is the default: diffuse 0.5, one-sided, as in Mitsuba.
  std::vector<Texture> textures;
  std::vector<Light> lights;
  std::vector<Medium> media;
  Camera camera;
  Film film;
  SamplerSettings sampler;
  IntegratorSettings integrator;
};

/// Axis-aligned bounds of everything bounded; none where there is nothing bounded. Of an instance it is those of its
/// group's bounds, turned.
[[nodiscard]] std::optional<Box> bounds(const Scene& scene);
/// None: it is unbounded.
[[nodiscard]] std::optional<Box> bounds(const Shape& shape);
/// The axis-aligned box around a box that `transform` has placed.
[[nodiscard]] Box bounds(const Box& box, const Transform& transform);
/// In the group's own frame.
[[nodiscard]] std::optional<Box> bounds(const Group& group);

/// The scene's own shapes, then those of its groups.
template <class Visit>
void for_each_shape(const Scene& scene, Visit visit) {
  for (const Shape& shape : scene.shapes) visit(shape);
  for (const Group& group : scene.groups)
    for (const Shape& shape : group.shapes) visit(shape);
}

}  // namespace strahl

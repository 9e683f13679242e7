// SPDX-License-Identifier: MIT
#include "render/intersector.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "kinds/entries.h"
#include "opencl/program.h"
#include "opencl/tuned_width.h"
#include "packing/cl_layout.h"
#include "packing/memory_estimate.h"
#include "packing/scene_buffers.h"
#include "program/program_text.h"
#include "render/median.h"
#include "render/traversal_choice.h"
#include "scene/validate.h"
#include "settings/require_settings.h"
#include "stopwatch.h"

namespace strahl {

/// Shapes that are counted together, among those of for_each_shape.
struct ShapeRange {
  std::size_t first, count;
};

namespace {

/// Rays, or hits to be described, a work-group.
constexpr std::size_t rays_at_once = 64;

/// Rays a launch: keeps buffers and launches small for any number of rays.
constexpr std::size_t chunk_rays = std::size_t{1} << 18;

/// The parts of a scene that intersection needs, with only the first shape of every kind: no vertices, lights,
/// materials or film.
Features intersection_features(const Scene& scene, const RenderSettings& settings) {
  Scene bare;
  bare.integrator.name = "emission";
  bare.sampler.kind = SamplerKind::centre;
  std::set<std::string> kinds;
  for_each_shape(scene, [&](const Shape& shape) {
    if (!kinds.insert(shape_kind(shape)).second) return;
    Shape& first = bare.shapes.emplace_back();
    first.where = shape.where;
    // The kind alone: the numbers may be many.
    first.geometry = std::visit([]<typename Kind>(const Kind&) -> Geometry { return Kind{}; }, shape.geometry);
  });
  if (!scene.instances.empty()) bare.instances.push_back(scene.instances.front());
  RenderSettings plain = settings;
  plain.aovs.clear();
  plain.estimate_error = false;
  return features_of(bare, plain);
}

std::size_t blocks_of(std::size_t count, std::size_t lanes) { return (count + lanes - 1) / lanes; }

/// Where the numbers of ray i begin, `lanes` apart, in blocks of so many planes of `lanes` rays.
std::size_t place_in_blocks(std::size_t i, std::size_t planes, std::size_t lanes) {
  return i / lanes * lanes * planes + i % lanes;
}

/// Blocks of `lanes` rays, RAY_REALS planes a block; the last is filled up with zeros.
template <typename Real>
std::vector<Real> pack_rays(const std::vector<Ray>& rays, std::size_t first, std::size_t count, std::size_t lanes) {
  std::vector<Real> reals(blocks_of(count, lanes) * lanes * layout::RAY_REALS, Real(0));
  for (std::size_t i = 0; i < count; ++i) {
    const Ray& ray = rays[first + i];
    const double values[] = {ray.origin.x,    ray.origin.y,    ray.origin.z, ray.direction.x,
                             ray.direction.y, ray.direction.z, ray.t_min,    ray.t_max};
    Real* to = reals.data() + place_in_blocks(i, layout::RAY_REALS, lanes);
    for (std::size_t k = 0; k < layout::RAY_REALS; ++k) to[k * lanes] = static_cast<Real>(values[k]);
  }
  return reals;
}

std::vector<ShapeRange> ranges_of(const Scene& scene) {
  std::vector<ShapeRange> ranges;
  std::size_t first = scene.shapes.size();
  for (const Group& group : scene.groups) {
    ranges.push_back({first, group.shapes.size()});
    first += group.shapes.size();
  }
  ranges.push_back({0, scene.shapes.size()});
  return ranges;
}

}  // namespace

struct Intersector::State {
  Device device;
  Precision precision;
  bool is_cached;
  std::optional<std::uint64_t> loop_turns;
  std::function<ProgramSource(bool any_hit)> source;
  SceneBuffers buffers;
  std::array<std::optional<cl::Kernel>, 2> finders;  ///< For the nearest hit and for any hit.
  cl::Kernel describe;
  std::vector<std::int64_t> first_ids;
  std::vector<ShapeRange> shapes_of_group;  ///< And last the scene's own.
  std::vector<int> group_of_instance;
  RunStats stats;

  State(const Device& d, const RenderSettings& settings)
      : device(d), precision(settings.precision), is_cached(settings.cached_program), loop_turns(settings.loop_turns) {}

  [[nodiscard]] const ShapeRange& shapes_beside(const Ray& ray, std::size_t row) const;
  [[nodiscard]] std::int32_t left_id(const Ray& ray, std::size_t row) const;
  cl::Kernel& finder(bool any_hit);
  void run(cl::Kernel& kernel, const std::vector<cl::Buffer>& arguments, std::size_t count, std::size_t rays_an_item);
  void take_any(const cl::Buffer& found, std::size_t first, std::size_t count, std::vector<Hit>& hits);
  [[nodiscard]] std::vector<std::size_t> cut_rays(const cl::Buffer& found, std::size_t count, bool any_hit) const;
  /// Returns those of the chunk whose loops the device has ended; their hits are wrong.
  template <typename Real>
  std::vector<std::size_t> trace_chunk(const std::vector<Ray>& rays, std::size_t first, std::size_t count, bool any_hit,
                                       std::vector<double>& run_seconds, std::vector<Hit>& hits);
  template <typename Real>
  void trace_again(const std::vector<Ray>& rays, const std::vector<std::size_t>& which, bool any_hit,
                   std::vector<Hit>& hits);
  template <typename Real>
  void trace(const std::vector<Ray>& rays, bool any_hit, std::vector<double>& run_seconds, std::vector<Hit>& hits);
};

const ShapeRange& Intersector::State::shapes_beside(const Ray& ray, std::size_t row) const {
  if (ray.instance == -1) return shapes_of_group.back();
  const auto instances = static_cast<std::ptrdiff_t>(group_of_instance.size());
  if (ray.instance < 0 || ray.instance >= instances)
    throw InputError(
        fmt::format("ray {}: instance {} does not exist ({})", row, ray.instance,
                    instances == 0 ? "the scene has none: -1" : fmt::format("0 to {}, or -1", instances - 1)));
  return shapes_of_group[static_cast<std::size_t>(group_of_instance[static_cast<std::size_t>(ray.instance)])];
}

std::int32_t Intersector::State::left_id(const Ray& ray, std::size_t row) const {
  if (ray.shape == -1) {
    if (ray.instance != -1 || ray.primitive != -1)
      throw InputError(
          fmt::format("ray {}: instance {} and primitive {} of no shape; where shape is -1 they are -1 too", row,
                      ray.instance, ray.primitive));
    return -1;
  }
  const ShapeRange& shapes = shapes_beside(ray, row);
  const auto shape = shapes.first + static_cast<std::size_t>(ray.shape);
  if (ray.shape < 0 || static_cast<std::size_t>(ray.shape) >= shapes.count)
    throw InputError(fmt::format("ray {}: shape {} does not exist{} (0 to {}, or -1)", row, ray.shape,
                                 ray.instance < 0 ? "" : fmt::format(" in instance {}", ray.instance),
                                 static_cast<std::ptrdiff_t>(shapes.count) - 1));
  if (ray.primitive < 0 || ray.primitive >= first_ids[shape + 1] - first_ids[shape])
    throw InputError(fmt::format("ray {}: primitive {} of shape {} does not exist", row, ray.primitive, ray.shape));
  return static_cast<std::int32_t>(first_ids[shape]) + ray.primitive;
}

/// Compiled on first use: the traversal is most of a program, and few callers need both kernels.
cl::Kernel& Intersector::State::finder(bool any_hit) {
  std::optional<cl::Kernel>& kernel = finders.at(any_hit);
  if (kernel) return *kernel;
  const Stopwatch start;
  const ProgramSource text = source(any_hit);
  ProgramReport report;
  const cl::Program program = program_on(device, text, &report, is_cached);
  checked(device.info().text(), [&] {
    kernel = cl::Kernel(program, "find");
    if (!any_hit) describe = cl::Kernel(program, "describe");
    return CL_SUCCESS;
  });
  stats.seconds.program += start.seconds();
  stats.program = program_hash(text);
  stats.program_from_cache = report.from_cache;
  stats.program_bytes = report.binary_bytes;
  return *kernel;
}

/// Enqueues a kernel over `count` rays and waits for its end; the scene's buffers come first among its arguments.
void Intersector::State::run(cl::Kernel& kernel, const std::vector<cl::Buffer>& arguments, std::size_t count,
                             std::size_t rays_an_item) {
  checked(device.info().text(), [&] {
    cl_uint arg = 0;
    for (const cl::Buffer& buffer : {buffers.geometry, buffers.shading, buffers.index}) kernel.setArg(arg++, buffer);
    for (const cl::Buffer& buffer : arguments) kernel.setArg(arg++, buffer);
    kernel.setArg(arg++, static_cast<cl_ulong>(count));
    const std::size_t items = rays_at_once / rays_an_item;
    device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(blocks_of(count, rays_at_once) * items),
                                        cl::NDRange(group_size(device, kernel, items)));
    return device.queue().finish();
  });
}

/// A work-item reports it in its first ray, for all of its rays.
std::vector<std::size_t> Intersector::State::cut_rays(const cl::Buffer& found, std::size_t count, bool any_hit) const {
  std::vector<std::size_t> cut;
  if (!loop_turns) return cut;
  const auto lanes = static_cast<std::size_t>(stats.lanes);
  const std::size_t planes = any_hit ? 1 : layout::FOUND_INTS, plane = any_hit ? 0 : layout::FOUND_KIND;
  std::vector<std::int32_t> values(blocks_of(count, lanes) * lanes * planes);
  read_buffer(device, found, values.data(), values.size() * sizeof(std::int32_t));
  for (std::size_t i = 0; i < count; ++i)
    if (values[place_in_blocks(i - i % lanes, planes, lanes) + plane * lanes] == layout::FOUND_CUT) cut.push_back(i);
  return cut;
}

template <typename Real>
std::vector<std::size_t> Intersector::State::trace_chunk(const std::vector<Ray>& rays, std::size_t first,
                                                         std::size_t count, bool any_hit,
                                                         std::vector<double>& run_seconds, std::vector<Hit>& hits) {
  const auto lanes = static_cast<std::size_t>(stats.lanes);
  const std::size_t places = blocks_of(count, lanes) * lanes;
  const std::vector<Real> ray_reals = pack_rays<Real>(rays, first, count, lanes);
  std::vector<std::int32_t> left(places * layout::DEPARTED_INTS, -1);
  for (std::size_t i = 0; i < count; ++i) {
    std::int32_t* to = left.data() + place_in_blocks(i, layout::DEPARTED_INTS, lanes);
    to[layout::DEPARTED_ID * lanes] = left_id(rays[first + i], first + i);
    to[layout::DEPARTED_INSTANCE * lanes] = rays[first + i].instance;
  }

  std::uint64_t bytes = buffers.bytes;
  const auto counted = [&](std::size_t size, const char* what) {
    bytes += size;
    stats.device_bytes = std::max(stats.device_bytes, bytes);
    return allocate(device, size, what);
  };
  const Stopwatch upload;
  const cl::Buffer ray_buffer = counted(ray_reals.size() * sizeof(Real), "the rays");
  const cl::Buffer left_buffer = counted(left.size() * sizeof(std::int32_t), "the rays");
  const cl::Buffer t_buffer = counted(places * sizeof(Real), "the hits");
  const cl::Buffer found_buffer = counted(places * layout::FOUND_INTS * sizeof(std::int32_t), "the hits");
  write_buffer(device, ray_buffer, ray_reals.data(), ray_reals.size() * sizeof(Real));
  write_buffer(device, left_buffer, left.data(), left.size() * sizeof(std::int32_t));
  stats.seconds.upload += upload.seconds();

  cl::Kernel& find = finder(any_hit);
  for (double& seconds : run_seconds) {
    const Stopwatch start;
    run(find, {ray_buffer, left_buffer, t_buffer, found_buffer}, count, lanes);
    seconds += start.seconds();
  }
  std::vector<std::size_t> cut = cut_rays(found_buffer, count, any_hit);
  for (std::size_t& ray : cut) ray += first;
  if (any_hit) {
    take_any(found_buffer, first, count, hits);
    return cut;
  }

  const Stopwatch surface;
  const cl::Buffer hit_buffer = counted(places * layout::HIT_REALS * sizeof(Real), "the hits");
  const cl::Buffer id_buffer = counted(places * layout::HIT_INTS * sizeof(std::int32_t), "the hits");
  run(describe, {ray_buffer, left_buffer, t_buffer, found_buffer, hit_buffer, id_buffer}, count, lanes);
  stats.seconds.surface += surface.seconds();

  const Stopwatch readback;
  std::vector<Real> out(places * layout::HIT_REALS);
  std::vector<std::int32_t> ids(places * layout::HIT_INTS);
  read_buffer(device, hit_buffer, out.data(), out.size() * sizeof(Real));
  read_buffer(device, id_buffer, ids.data(), ids.size() * sizeof(std::int32_t));
  for (std::size_t i = 0; i < count; ++i) {
    const Real* reals = out.data() + place_in_blocks(i, layout::HIT_REALS, lanes);
    const std::int32_t* ints = ids.data() + place_in_blocks(i, layout::HIT_INTS, lanes);
    const auto real = [&](std::size_t k) { return static_cast<double>(reals[k * lanes]); };
    Hit& hit = hits[first + i];
    hit.t = real(layout::HIT_T);
    hit.u = real(layout::HIT_U);
    hit.v = real(layout::HIT_V);
    hit.normal = {real(layout::HIT_NORMAL), real(layout::HIT_NORMAL + 1), real(layout::HIT_NORMAL + 2)};
    hit.instance = ints[layout::HIT_INSTANCE * lanes];
    hit.shape = ints[layout::HIT_SHAPE * lanes];
    if (hit.instance >= 0) {
      const int group = group_of_instance[static_cast<std::size_t>(hit.instance)];
      hit.shape -= static_cast<std::int32_t>(shapes_of_group[static_cast<std::size_t>(group)].first);
    }
    hit.primitive = ints[layout::HIT_PRIMITIVE * lanes];
  }
  stats.seconds.readback += readback.seconds();
  return cut;
}

/// Traces rays that were cut short in launches of their own, with fewer and fewer rays, because work-items that run in
/// step share their turns.
template <typename Real>
void Intersector::State::trace_again(const std::vector<Ray>& rays, const std::vector<std::size_t>& which, bool any_hit,
                                     std::vector<Hit>& hits) {
  std::vector<Ray> few;
  for (const std::size_t ray : which) few.push_back(rays[ray]);
  std::vector<Hit> found(few.size());
  std::vector<double> run_seconds(1, 0.0);
  std::vector<std::size_t> cut = trace_chunk<Real>(few, 0, few.size(), any_hit, run_seconds, found);
  for (std::size_t i = 0; i < which.size(); ++i) hits[which[i]] = found[i];
  if (cut.empty()) return;
  if (which.size() == 1)
    throw NoDeviceError(
        fmt::format("{} ends the loops of a work-item after {} turns, and ray {} takes more in this scene; choose "
                    "another device (-d) or fewer shapes",
                    device.info().text(), loop_turns.value_or(0), which.front()));
  for (std::size_t& ray : cut) ray = which[ray];
  const auto half = cut.begin() + static_cast<std::ptrdiff_t>((cut.size() + 1) / 2);
  trace_again<Real>(rays, {cut.begin(), half}, any_hit, hits);
  if (half != cut.end()) trace_again<Real>(rays, {half, cut.end()}, any_hit, hits);
}

template <typename Real>
void Intersector::State::trace(const std::vector<Ray>& rays, bool any_hit, std::vector<double>& run_seconds,
                               std::vector<Hit>& hits) {
  for (std::size_t first = 0; first < rays.size(); first += chunk_rays) {
    const std::size_t count = std::min(chunk_rays, rays.size() - first);
    const std::vector<std::size_t> cut = trace_chunk<Real>(rays, first, count, any_hit, run_seconds, hits);
    if (!cut.empty()) trace_again<Real>(rays, cut, any_hit, hits);
  }
}

void Intersector::State::take_any(const cl::Buffer& found, std::size_t first, std::size_t count,
                                  std::vector<Hit>& hits) {
  const Stopwatch readback;
  std::vector<std::int32_t> is_hit(count);
  read_buffer(device, found, is_hit.data(), count * sizeof(std::int32_t));
  for (std::size_t i = 0; i < count; ++i)
    if (is_hit[i] > 0) hits[first + i].t = 0;
  stats.seconds.readback += readback.seconds();
}

Intersector::Intersector(const Device& device, const Scene& scene, const RenderSettings& settings)
    : state_(std::make_unique<State>(device, settings)) {
  require_settings(settings);
  if (std::vector<Diagnostic> problems = validate(scene); !problems.empty()) throw SceneError(problems);
  State& s = *state_;
  const Width width = wide_enough(width_on(device, settings), scene, settings);
  const Stopwatch start;
  const Features features = intersection_features(scene, settings);
  const auto [has_tree, acceleration] = choose_traversal(scene, features, settings, width, 1);
  // Where the device may end loops, each ray must take as few turns as possible.
  const bool packets = settings.coherent && width.lanes > 1 && !settings.loop_turns;
  s.source = [=, precision = settings.precision, has_tree = has_tree](bool any_hit) {
    const std::string root = fmt::format("kernels/intersect{}{}.cl", any_hit ? "_any" : "", packets ? "_packets" : "");
    return program_source(root, features, precision, width.lanes, width.tree, has_tree);
  };
  s.stats.seconds.program = start.seconds();
  const Stopwatch upload;
  s.buffers =
      upload_scene(device, scene, features, settings.precision, {width.lanes, UploadFrame{}, width.tree, acceleration});
  s.first_ids = first_ids(scene);
  s.shapes_of_group = ranges_of(scene);
  for (const Instance& instance : scene.instances) s.group_of_instance.push_back(instance.group);
  s.stats.seconds.bvh = s.buffers.tree.seconds;
  s.stats.seconds.upload = upload.seconds() - s.stats.seconds.bvh;
  s.stats.device_bytes = s.stats.scene_bytes = s.stats.host_bytes = s.buffers.bytes;
  s.stats.device = device.info().text();
  s.stats.precision = precision_name(settings.precision);
  s.stats.lanes = width.lanes;
  s.stats.tree_width = width.tree;
  s.stats.tree = s.buffers.tree;
  s.stats.disabled.assign(settings.disabled.begin(), settings.disabled.end());
  for (const FeatureReport& row : features.report)
    if (row.on) s.stats.features.push_back(row.name);
}
MemoryNeed Intersector::least_memory(const Device& device, const Scene& scene, const RenderSettings& settings) {
  require_settings(settings);
  const Features features = intersection_features(scene, settings);
  return strahl::least_memory(scene, features, settings.precision,
                              wide_enough(width_on(device, settings), scene, settings).lanes);
}

Intersector::~Intersector() = default;
Intersector::Intersector(Intersector&&) noexcept = default;
Intersector& Intersector::operator=(Intersector&&) noexcept = default;

const RunStats& Intersector::stats() const { return state_->stats; }

std::vector<Hit> Intersector::trace(const std::vector<Ray>& rays, bool any_hit, int repeat) {
  if (repeat < 1) throw UsageError(fmt::format("repeat is {}; rays are traced 1 time or more", repeat));
  State& s = *state_;
  std::vector<Hit> hits(rays.size());
  std::vector<double> run_seconds(static_cast<std::size_t>(repeat), 0.0);
  if (s.precision == Precision::fp64)
    s.trace<double>(rays, any_hit, run_seconds, hits);
  else
    s.trace<float>(rays, any_hit, run_seconds, hits);
  s.stats.seconds.kernel = median(run_seconds);
  s.stats.kernel_runs = std::move(run_seconds);
  s.stats.camera_rays = rays.size();
  return hits;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "bench/ten_spheres.h"

#include <fmt/format.h>

#include <cstring>
#include <functional>

#include "bench/race.h"
#include "image/file_bytes.h"
#include "opencl/program.h"
#include "opencl/tuned_width.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "packing/pack_camera.h"
#include "packing/scene_buffers.h"
#include "program/program_text.h"
#include "render/film.h"
#include "render/renderer.h"
#include "stopwatch.h"
#include "study/generated/scenes.h"

namespace strahl::bench {
namespace {

constexpr const char* minimal_kernel = "kernels/ten_spheres_minimal.cl";

/// The kernels of that file, on buffers of their own.
template <typename Real>
class Minimal {
 public:
  Minimal(const Device& device, const Scene& scene, const RenderSettings& settings, int lanes)
      : device_(device), side_(scene.film.width) {
    KernelFiles files = kernel_files();
    files[minimal_kernel] = read_file(STRAHL_BENCH_FOLDER "/kernels/ten_spheres_minimal.cl");
    program_ = build_program(device, program_source(files, minimal_kernel, features_of(scene, settings),
                                                    settings.precision, lanes, lanes, false));
    const UploadFrame frame = settings.precision == Precision::fast ? UploadFrame{} : camera_frame(scene);
    const std::size_t width = static_cast<std::size_t>(lanes), count = scene.shapes.size();
    blocks_ = static_cast<int>((count + width - 1) / width);
    std::vector<Real> spheres(static_cast<std::size_t>(blocks_) * 4 * width, Real{0}), radiance;
    std::vector<std::int32_t> ids(static_cast<std::size_t>(blocks_) * width, -1);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& sphere = std::get<Sphere>(scene.shapes[i].geometry);
      const Vec3 center = frame.point(sphere.center);
      Real* planes = &spheres[i / width * 4 * width + i % width];
      int plane = 0;
      for (const double value : {center.x, center.y, center.z, frame.scale * sphere.radius})
        planes[static_cast<std::size_t>(plane++) * width] = static_cast<Real>(value);
      ids[i] = static_cast<std::int32_t>(i);
      const Rgb& glow = *scene.shapes[i].radiance;
      for (const double value : {glow.r, glow.g, glow.b}) radiance.push_back(static_cast<Real>(value));
    }
    std::vector<Real> camera;
    for (const double value : camera_reals(scene.camera, scene.film, frame)) camera.push_back(static_cast<Real>(value));
    camera_ = upload(camera);
    spheres_ = upload(spheres);
    ids_ = upload(ids);
    radiance_ = upload(radiance);
    film_bytes_ = pixels() * layout::FILM_CHANNELS * layout::FILM_SUM_WORDS * sizeof(std::int64_t);
    film_ = allocate(device, film_bytes_, "the film");
  }

  double run(const char* name) {
    cl::Kernel& kernel = kernels_.try_emplace(name, cl::Kernel(program_, name)).first->second;
    cl_uint arg = 0;
    for (const cl::Buffer* buffer : {&camera_, &spheres_, &ids_, &radiance_, &film_}) kernel.setArg(arg++, *buffer);
    for (const int value : {side_, side_, blocks_}) kernel.setArg(arg++, value);
    device_.queue().enqueueFillBuffer(film_, cl_long{0}, 0, film_bytes_);
    device_.queue().finish();
    const WorkGroup group;
    const Stopwatch start;
    device_.queue().enqueueNDRangeKernel(
        kernel, cl::NullRange, cl::NDRange(static_cast<std::size_t>(side_), static_cast<std::size_t>(side_)),
        cl::NDRange(static_cast<std::size_t>(group.x), static_cast<std::size_t>(group.y)));
    device_.queue().finish();
    return start.seconds();
  }

  Image picture() {
    FilmSums film({FilmKind::pixels, side_, side_, {1, 1, 0}});
    read_buffer(device_, film_, film.words.data(), film_bytes_);
    film.add_samples({0, 0, side_, side_, 0, 1});
    return film.mean();
  }

 private:
  std::size_t pixels() const { return static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_); }
  template <typename Number>
  cl::Buffer upload(const std::vector<Number>& numbers) {
    const cl::Buffer buffer = allocate(device_, numbers.size() * sizeof(Number), "ten spheres");
    write_buffer(device_, buffer, numbers.data(), numbers.size() * sizeof(Number));
    return buffer;
  }

  Device device_;
  int side_;
  cl::Program program_;
  std::map<std::string, cl::Kernel> kernels_;
  int blocks_ = 0;
  std::size_t film_bytes_ = 0;
  cl::Buffer camera_, spheres_, ids_, radiance_, film_;
};

std::size_t differing(const Image& a, const Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.data.size(); i += 3)
    count += std::memcmp(&a.data[i], &b.data[i], 3 * sizeof(float)) != 0 ? 1 : 0;
  return count;
}

template <typename Real>
TenSpheres race(const Device& device, const RenderSettings& settings, int side, int rounds) {
  const Scene scene = ten_glowing_spheres(side);
  RenderSettings everything = settings;
  everything.generic = true;
  Renderer own(device, scene, settings), generic(device, scene, everything);
  const RenderResult expected = own.render();
  TenSpheres result;
  result.precision = settings.precision;
  result.lanes = expected.stats.lanes;
  result.pixels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  Minimal<Real> minimal(device, scene, settings, result.lanes);
  minimal.run("lanes");
  if (const std::size_t wrong = differing(minimal.picture(), expected.color); wrong > 0)
    throw Error(
        fmt::format("{}: {} of {} pixels of the kernel for ten spheres are not strahl's; its time means nothing",
                    precision_name(settings.precision), wrong, result.pixels));
  minimal.run("scalar");
  result.scalar_differs = differing(minimal.picture(), expected.color);
  if (result.scalar_differs * 100 > result.pixels)
    throw Error(fmt::format("{}: {} of {} pixels of the scalar kernel are not strahl's; its time means nothing",
                            precision_name(settings.precision), result.scalar_differs, result.pixels));
  static_cast<void>(generic.render());
  const std::vector<std::vector<double>> seconds =
      take_turns({[&] { return own.render().stats.seconds.kernel; }, [&] { return minimal.run("lanes"); },
                  [&] { return minimal.run("scalar"); }, [&] { return generic.render().stats.seconds.kernel; }},
                 rounds);
  result.strahl = seconds[0];
  result.minimal_lanes = seconds[1];
  result.minimal_scalar = seconds[2];
  result.generic = seconds[3];
  return result;
}

}  // namespace

bool TenSpheres::is_scalar_faster() const {
  return precision == Precision::fast && median(minimal_scalar) < median(minimal_lanes);
}

Scene ten_glowing_spheres(int side) {
  Scene scene = ten_spheres();
  scene.integrator.name = "emission";
  scene.lights.clear();
  std::erase_if(scene.shapes, [](const Shape& shape) { return !std::holds_alternative<Sphere>(shape.geometry); });
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const double share = static_cast<double>(i) / 8;
    scene.shapes[i].radiance = Rgb{0.25 + 0.5 * share, 1 - 0.5 * share, 0.5};
  }
  scene.film.width = scene.film.height = side;
  scene.sampler.kind = SamplerKind::centre;
  scene.sampler.sample_count = 1;
  return scene;
}

TenSpheres time_ten_spheres(const Device& device, Precision precision, int side, int rounds) {
  RenderSettings settings;
  settings.precision = precision;
  settings.passes = 1;
  return precision == Precision::fp64 ? race<double>(device, settings, side, rounds)
                                      : race<float>(device, settings, side, rounds);
}

}  // namespace strahl::bench

// SPDX-License-Identifier: MIT
#include "bench/peers/embree.h"

#include <fmt/format.h>
#include <immintrin.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "bench/peers/embree_scene.h"
#include "stopwatch.h"

namespace strahl::bench {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t chunk = 64;

struct FloatRay {
  float o[3], t_min, d[3], t_max;
};

FloatRay float_ray(const Ray& ray) {
  const auto f = [](double x) { return static_cast<float>(x); };
  return {{f(ray.origin.x), f(ray.origin.y), f(ray.origin.z)},
          f(ray.t_min),
          {f(ray.direction.x), f(ray.direction.y), f(ray.direction.z)},
          f(ray.t_max)};
}

/// Calls work(first, last) for chunks of [0, count), whichever thread is free.
template <typename Work>
void in_chunks(std::size_t count, unsigned threads, Work work) {
  std::atomic<std::size_t> next = 0;
  const auto run = [&] {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    for (std::size_t first; (first = next.fetch_add(chunk)) < count;) work(first, std::min(first + chunk, count));
  };
  std::vector<std::thread> others;
  for (unsigned i = 0; i < threads; ++i) others.emplace_back(run);
  for (std::thread& thread : others) thread.join();
}

RTCDevice new_device(unsigned threads) {
  RTCDevice device = rtcNewDevice(fmt::format("threads={}", threads).c_str());
  if (device == nullptr)
    throw Error(fmt::format("Embree does not start: error {}", static_cast<int>(rtcGetDeviceError(nullptr))));
  return device;
}

/// What every way of asking shares: the scene, the threads.
class Embree : public Contender {
 public:
  Embree(const Scene& scene, const EmbreeSettings& settings)
      : settings_(settings),
        device_(new_device(settings.threads)),
        scene_(device_.get(), scene, settings.robust, settings.points || settings.packet > 1) {}

  [[nodiscard]] std::string program() const override {
    const auto version = rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_VERSION);
    return fmt::format("Embree {}.{}.{}", version / 10000, version / 100 % 100, version % 100);
  }
  [[nodiscard]] std::string variant() const override {
    std::string text = std::to_string(settings_.packet);
    if (settings_.packet > 1) text += " coherent";
    if (settings_.points && settings_.packet == 1) text += " points";
    if (settings_.robust) text += " robust";
    return text;
  }
  [[nodiscard]] double build_seconds() const override { return scene_.build_seconds(); }
  [[nodiscard]] std::vector<double> distances() override { return {t_.begin(), t_.end()}; }

 protected:
  [[nodiscard]] RTCScene scene() const { return scene_.handle(); }
  [[nodiscard]] unsigned threads() const { return settings_.threads; }

  std::vector<float> t_;
  bool any_hit_ = false;

 private:
  EmbreeSettings settings_;
  EmbreeDevice device_;
  EmbreeScene scene_;
};

class SingleRays : public Embree {
 public:
  using Embree::Embree;

  void load(const RaySet& set) override {
    rays_.clear();
    for (const Ray& ray : set.rays) rays_.push_back(float_ray(ray));
    t_.assign(rays_.size(), 0);
    any_hit_ = set.any_hit();
  }

  double trace() override {
    const Stopwatch start;
    if (any_hit_)
      in_chunks(rays_.size(), threads(), [this](std::size_t first, std::size_t last) { occlude(first, last); });
    else
      in_chunks(rays_.size(), threads(), [this](std::size_t first, std::size_t last) { intersect(first, last); });
    return start.seconds();
  }

 private:
  static void put(const FloatRay& from, RTCRay& to) {
    to.org_x = from.o[0];
    to.org_y = from.o[1];
    to.org_z = from.o[2];
    to.tnear = from.t_min;
    to.dir_x = from.d[0];
    to.dir_y = from.d[1];
    to.dir_z = from.d[2];
    to.time = 0;
    to.tfar = from.t_max;
    to.mask = ~0U;
    to.id = to.flags = 0;
  }

  void intersect(std::size_t first, std::size_t last) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = first; i < last; ++i) {
      RTCRayHit ray_hit;
      put(rays_[i], ray_hit.ray);
      ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      ray_hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene(), &context, &ray_hit);
      t_[i] = ray_hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? infinity : ray_hit.ray.tfar;
    }
  }

  void occlude(std::size_t first, std::size_t last) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = first; i < last; ++i) {
      RTCRay ray;
      put(rays_[i], ray);
      rtcOccluded1(scene(), &context, &ray);
      t_[i] = ray.tfar < 0 ? 0 : infinity;
    }
  }

  std::vector<FloatRay> rays_;
};

/// What differs between packets of 8 and of 16.
struct Packet8 {
  static constexpr std::size_t size = 8;
  using Ray = RTCRay8;
  using RayHit = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
  static constexpr auto occlude = rtcOccluded8;
};
struct Packet16 {
  static constexpr std::size_t size = 16;
  using Ray = RTCRay16;
  using RayHit = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
  static constexpr auto occlude = rtcOccluded16;
};

/// The rays lie ready in packets; a run copies each, because Embree writes into it.
template <typename Packet>
class Packets : public Embree {
 public:
  using Embree::Embree;

  void load(const RaySet& set) override {
    count_ = set.rays.size();
    any_hit_ = set.any_hit();
    t_.assign(count_, 0);
    packets_.assign((count_ + Packet::size - 1) / Packet::size, {});
    for (std::size_t i = 0; i < packets_.size() * Packet::size; ++i) {
      typename Packet::Ray& packet = packets_[i / Packet::size];
      const std::size_t lane = i % Packet::size;
      const FloatRay ray = float_ray(set.rays[std::min(i, count_ - 1)]);
      packet.org_x[lane] = ray.o[0];
      packet.org_y[lane] = ray.o[1];
      packet.org_z[lane] = ray.o[2];
      packet.tnear[lane] = ray.t_min;
      packet.dir_x[lane] = ray.d[0];
      packet.dir_y[lane] = ray.d[1];
      packet.dir_z[lane] = ray.d[2];
      packet.tfar[lane] = ray.t_max;
      packet.mask[lane] = ~0U;
    }
  }

  double trace() override {
    const Stopwatch start;
    in_chunks(packets_.size() * Packet::size, threads(), [this](std::size_t first, std::size_t last) {
      for (std::size_t i = first / Packet::size; i < last / Packet::size; ++i) answer(i);
    });
    return start.seconds();
  }

 private:
  void answer(std::size_t index) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[Packet::size];
    std::fill_n(valid, Packet::size, -1);
    const std::size_t first = index * Packet::size, lanes = std::min(Packet::size, count_ - first);
    if (any_hit_) {
      alignas(64) typename Packet::Ray ray = packets_[index];
      Packet::occlude(valid, scene(), &context, &ray);
      for (std::size_t lane = 0; lane < lanes; ++lane) t_[first + lane] = ray.tfar[lane] < 0 ? 0 : infinity;
      return;
    }
    alignas(64) typename Packet::RayHit ray_hit;
    ray_hit.ray = packets_[index];
    std::fill_n(ray_hit.hit.geomID, Packet::size, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(ray_hit.hit.instID[0], Packet::size, RTC_INVALID_GEOMETRY_ID);
    Packet::intersect(valid, scene(), &context, &ray_hit);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      t_[first + lane] = ray_hit.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID ? infinity : ray_hit.ray.tfar[lane];
  }

  std::size_t count_ = 0;
  std::vector<typename Packet::Ray> packets_;
};

}  // namespace

bool has_embree() { return true; }

std::unique_ptr<Contender> embree_contender(const Scene& scene, const EmbreeSettings& settings) {
  switch (settings.packet) {
    case 1:
      return std::make_unique<SingleRays>(scene, settings);
    case 8:
      return std::make_unique<Packets<Packet8>>(scene, settings);
    case 16:
      return std::make_unique<Packets<Packet16>>(scene, settings);
    default:
      throw Error(fmt::format("Embree has packets of 1, 8 and 16 rays, not {}", settings.packet));
  }
}

}  // namespace strahl::bench

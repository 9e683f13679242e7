// SPDX-License-Identifier: MIT
// Every index of a packed scene, flipped in turn: either check_packed refuses it, or paths traced through the scene
// read nothing beyond the buffers and come to an end. The buffers end where memory does: behind them, or before them,
// lie pages that nobody may touch. A child process traces, since that is how such a read ends.
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstring>
#include <random>

#include "kinds/integrators.h"
#include "packing/check_packed.h"
#include "physics/transport_scenes.h"
#include "scene/loader.h"

using namespace strahl;
using namespace strahl::test;

namespace {

constexpr std::size_t page_bytes = 4096;
/// More than any int leads to, in doubles.
constexpr std::size_t beyond = std::size_t{40} << 30;

enum class Flush { with_end, with_begin };

/// A copy of numbers with `beyond` bytes on both sides that end the process if they are read.
class Guarded {
 public:
  Guarded(const void* from, std::size_t bytes, Flush flush)
      : held_((bytes + page_bytes - 1) / page_bytes * page_bytes) {
    whole_ = mmap(nullptr, held_ + 2 * beyond, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    REQUIRE(whole_ != MAP_FAILED);
    char* const first = static_cast<char*>(whole_) + beyond;
    if (held_ > 0) REQUIRE(mprotect(first, held_, PROT_READ | PROT_WRITE) == 0);
    at_ = flush == Flush::with_end ? first + (held_ - bytes) : first;
    if (bytes > 0) std::memcpy(at_, from, bytes);
  }
  ~Guarded() { munmap(whole_, held_ + 2 * beyond); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;
  [[nodiscard]] char* data() const { return at_; }

 private:
  std::size_t held_;
  void* whole_;
  char* at_;
};

template <class T>
Guarded guarded(const std::vector<T>& values, Flush flush) {
  return {values.data(), values.size() * sizeof(T), flush};
}

struct Flip {
  std::size_t at;
  std::int32_t value;
};

/// At most so many places of a scene, those that come first, which are the tables' headers, and others evenly.
std::vector<Flip> flips_of(const std::vector<std::int32_t>& index, std::size_t most) {
  std::mt19937 engine(17);
  std::vector<Flip> flips;
  const std::size_t first = std::min<std::size_t>(index.size(), 120);
  const std::size_t step = std::max<std::size_t>(1, (index.size() - first) / std::max<std::size_t>(1, most - first));
  for (std::size_t at = 0; at < index.size(); at += at < first ? 1 : step) {
    const auto bits = static_cast<std::uint32_t>(index[at]);
    const auto anywhere = static_cast<std::uint32_t>(engine()),
               nearby = static_cast<std::uint32_t>(engine() % index.size());
    for (const std::uint32_t value :
         {bits + 1, bits - 1, bits ^ 0x80000000U, 0x80000000U, 0xffffffffU, anywhere, nearby})
      if (value != bits) flips.push_back({at, static_cast<std::int32_t>(value)});
  }
  return flips;
}

/// What a child process tells, also one that does not come back.
struct FlipProgress {
  std::size_t flip;
  std::size_t traced;
};

struct FlipOutcome {
  std::size_t flips = 0, traced = 0;
  std::vector<std::string> faults;
};

std::vector<GivenRay> rays_of(const Scene& scene) {
  std::mt19937_64 engine(23);
  std::vector<GivenRay> rays;
  const Transform& world = scene.camera.world_from_camera;
  for (int i = 0; i < 6; ++i) {
    const Vec3 towards = world.vector({unit_number(engine) - 0.5, unit_number(engine) - 0.5, 1.5});
    rays.push_back({triad(world.translation()), triad(normalized(towards)), 0, 1e30});
  }
  return rays;
}

template <class Real>
class Flipping {
 public:
  Flipping(const Scene& scene, const TransportTier& tier) : scene_(scene), tier_(tier), rays_(rays_of(scene)) {
    RenderSettings settings;
    settings.generic = true;
    features_ = features_of(scene, settings);
    options_ = {tier.lanes, UploadFrame{}, 0};
    packed_ = pack_scene<Real>(scene, features_, options_);
  }
  [[nodiscard]] std::string fault() const { return fault_of_packed(packed_, scene_, features_, options_); }
  [[nodiscard]] const std::vector<std::int32_t>& index() const { return packed_.index; }

  /// is_checked: flips that check_packed refuses are not traced.
  FlipOutcome run(const std::vector<Flip>& flips, Flush flush, bool is_checked = true) {
    const Guarded geometry = guarded(packed_.geometry, flush), shading = guarded(packed_.shading, flush);
    const Guarded index = guarded(packed_.index, flush);
    const TierBuffers buffers{geometry.data(), shading.data(), reinterpret_cast<const std::int32_t*>(index.data())};
    auto* const told = static_cast<FlipProgress*>(
        mmap(nullptr, page_bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    REQUIRE(told != MAP_FAILED);
    *told = {};
    FlipOutcome outcome;
    while (told->flip < flips.size() && outcome.faults.size() < 5) {
      const pid_t child = fork();
      REQUIRE(child >= 0);
      if (child == 0) {
        for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(fault, SIG_DFL);
        for (; told->flip < flips.size(); ++told->flip)
          told->traced += trace(flips[told->flip], buffers, reinterpret_cast<std::int32_t*>(index.data()), is_checked);
        _exit(0);
      }
      int status = 0;
      waitpid(child, &status, 0);
      if (status == 0) continue;
      const Flip& flip = flips[told->flip++];
      outcome.faults.push_back("index " + std::to_string(flip.at) + ", " + std::to_string(packed_.index[flip.at]) +
                               " to " + std::to_string(flip.value) +
                               (WIFSIGNALED(status) ? ": signal " + std::to_string(WTERMSIG(status)) : ": exit"));
    }
    outcome.flips = told->flip;
    outcome.traced = told->traced;
    munmap(told, page_bytes);
    return outcome;
  }

 private:
  bool trace(const Flip& flip, const TierBuffers& buffers, std::int32_t* index, bool is_checked) {
    const std::int32_t was = packed_.index[flip.at];
    packed_.index[flip.at] = index[flip.at] = flip.value;
    const bool is_sound = !is_checked || fault().empty();
    if (is_sound) {
      // Of the processor's time: whoever takes more does not come to an end.
      const itimerval limit{{0, 0}, {20, 0}}, none{};
      setitimer(ITIMER_VIRTUAL, &limit, nullptr);
      if (kinds::integrator(scene_.integrator.name).from_lights)
        static_cast<void>(tier_.splats(buffers, 16));
      else
        for (const GivenRay& ray : rays_) static_cast<void>(tier_.radiance(buffers, ray, 2));
      setitimer(ITIMER_VIRTUAL, &none, nullptr);
    }
    packed_.index[flip.at] = index[flip.at] = was;
    return is_sound;
  }

  const Scene& scene_;
  const TransportTier& tier_;
  std::vector<GivenRay> rays_;
  Features features_;
  PackOptions options_;
  PackedScene<Real> packed_;
};

const bool is_long = std::getenv("STRAHL_ALL_FLIPS") != nullptr;

/// As many places of a scene as this run may take.
std::size_t most_places() { return is_long ? 1U << 30 : 140; }

template <class Real>
void flip_all(const Scene& scene, const TransportTier& tier) {
  Flipping<Real> flipping(scene, tier);
  REQUIRE(flipping.fault().empty());
  const std::vector<Flip> flips = flips_of(flipping.index(), most_places());
  std::size_t tried = 0, traced = 0;
  for (const Flush flush : {Flush::with_end, Flush::with_begin}) {
    std::vector<Flip> some;
    // Every flip both ways takes long.
    for (std::size_t i = 0; i < flips.size(); ++i)
      if (is_long || (i % 2 == 0) == (flush == Flush::with_end)) some.push_back(flips[i]);
    const FlipOutcome outcome = flipping.run(some, flush);
    for (const std::string& fault : outcome.faults) UNSCOPED_INFO(fault);
    CHECK(outcome.faults.empty());
    tried += outcome.flips;
    traced += outcome.traced;
  }
  // Both happen.
  CHECK(traced > 0);
  CHECK(traced < tried);
  if (is_long)
    WARN(tier.name << " x " << tier.lanes << ": " << tried << " flips of " << flipping.index().size() << " ints, "
                   << traced << " of them traced");
}

void flip_every_tier(const Scene& scene, const std::vector<TransportTier>& tiers) {
  for (const TransportTier& tier : tiers) {
    if (std::string(tier.name) == "double")
      flip_all<double>(scene, tier);
    else
      flip_all<float>(scene, tier);
  }
}

Scene shipped(const std::string& name) { return load_scene(STRAHL_SOURCE_DIR "/scenes/" + name).scene; }

/// Packs to thousands of ints at most.
const std::vector<std::string> few_scenes = {"lecture/lit.xml", "instances/mushrooms.xml", "lights/screen.xml",
                                             "materials/blendbsdf.xml", "textures/mesh_attribute.xml"};
const std::vector<std::string> more_scenes = {
    "lights/stage.xml",        "lights/mesh.xml",          "lights/envmap.xml",     "lights/sunsky.xml",
    "lights/projector.xml",    "lights/caustic.xml",       "materials/coating.xml", "materials/mask.xml",
    "materials/normalmap.xml", "materials/dielectric.xml", "textures/bitmap.xml",   "shapes/mesh-ply.xml"};

}  // namespace

TEST_CASE("a flipped index is refused, or does no harm") {
  std::vector<std::string> scenes = few_scenes;
  if (is_long) scenes.insert(scenes.end(), more_scenes.begin(), more_scenes.end());
  std::vector<TransportTier> tiers = transport_robust();
  for (const std::string& name : scenes) {
    INFO(name);
    if (is_long)
      flip_every_tier(shipped(name), tiers);
    else
      flip_every_tier(shipped(name), {tiers.front()});
    std::rotate(tiers.begin(), tiers.begin() + 1, tiers.end());
  }
}

TEST_CASE("what is packed is sound, whatever the program leaves out") {
  for (const std::string& name : few_scenes)
    for (const std::string& integrator : kinds::integrator_names())
      for (const bool is_generic : {false, true}) {
        INFO(name << ", " << integrator << (is_generic ? ", generic" : ""));
        Scene scene = shipped(name);
        scene.integrator.name = integrator;
        RenderSettings settings;
        settings.generic = is_generic;
        const Features features = features_of(scene, settings);
        const PackOptions options{8, UploadFrame{{1, 2, 3}, 0.5}, 0};
        CHECK(fault_of_packed(pack_scene<float>(scene, features, options), scene, features, options).empty());
      }
}

TEST_CASE("media with a flipped index") {
  for (const char* name : {"media/candle.xml", "media/smoke.xml", "media/fog.xml"}) {
    if (!is_long && name == std::string("media/smoke.xml")) break;
    INFO(name);
    flip_every_tier(shipped(name), transport_media());
  }
}

TEST_CASE("what is read beyond the buffers is seen") {
  const Scene scene = shipped("lecture/lit.xml");
  const TransportTier tier = transport_robust().front();
  Flipping<float> flipping(scene, tier);
  for (const Flush flush : {Flush::with_end, Flush::with_begin}) {
    const std::int32_t materials = flipping.index()[layout::HEADER_MATERIALS];
    CHECK(flipping.run({{layout::HEADER_MATERIALS, materials}}, flush, false).faults.empty());
    CHECK(flipping.run({{layout::HEADER_MATERIALS, 0x7fffffff}}, flush, false).faults.size() == 1);
    CHECK(flipping.run({{layout::HEADER_MATERIALS, -0x7fffffff}}, flush, false).faults.size() == 1);
  }
}

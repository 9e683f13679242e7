// SPDX-License-Identifier: MIT
// Every index of a packed scene, flipped in turn: either check_packed refuses it, or paths traced through the scene
// read nothing beyond the buffers and come to an end. The buffers end where memory does: behind them, or before them,
// lie pages that nobody may touch. A child process traces, since that is how such a read ends.
//
// STRAHL_ALL_FLIPS=1 flips every index of the scenes of scenes/, STRAHL_ALL_FLIPS=2/4 every fourth flip from the
// second on: four such runs are one.
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>

#include "kinds/integrators.h"
#include "packing/check_packed.h"
#include "physics/transport_scenes.h"
#include "scene/loader.h"
#include "scene/sky/daylight.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const char* const all_flips = std::getenv("STRAHL_ALL_FLIPS");
const bool is_long = all_flips != nullptr;

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
  std::size_t changed;
};

struct FlipOutcome {
  std::size_t flips = 0, traced = 0;
  std::size_t changed = 0;  ///< Traced, with another light along a path than without: surely read.
  std::vector<std::string> faults;
};

std::vector<GivenRay> rays_of(const Scene& scene) {
  std::mt19937_64 engine(23);
  std::vector<GivenRay> rays;
  const Transform& world = scene.camera.world_from_camera;
  for (int i = 0; i < (is_long ? 64 : 6); ++i) {
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

  /// Each flip in buffers of each of `flushes`. is_checked: flips that check_packed refuses are not traced.
  FlipOutcome run(const std::vector<Flip>& flips, const std::vector<Flush>& flushes, bool is_checked = true) {
    std::vector<std::unique_ptr<Placed>> places;
    for (const Flush flush : flushes) places.push_back(std::make_unique<Placed>(packed_, flush));
    if (light_.empty()) light_ = light_of(places.front()->buffers());
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
        for (; told->flip < flips.size(); ++told->flip) trace(flips[told->flip], places, is_checked, *told);
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
    outcome.changed = told->changed;
    munmap(told, page_bytes);
    return outcome;
  }

 private:
  /// The packed scene between pages that nobody may touch.
  struct Placed {
    Placed(const PackedScene<Real>& packed, Flush flush)
        : geometry(guarded(packed.geometry, flush)),
          shading(guarded(packed.shading, flush)),
          index(guarded(packed.index, flush)) {}
    [[nodiscard]] std::int32_t* ints() const { return reinterpret_cast<std::int32_t*>(index.data()); }
    [[nodiscard]] TierBuffers buffers() const { return {geometry.data(), shading.data(), ints()}; }
    Guarded geometry, shading, index;
  };

  /// What the paths bring, as bits: also of numbers that are none.
  std::string light_of(const TierBuffers& buffers) const {
    std::string light;
    const auto add = [&](const auto& found) {
      light.append(reinterpret_cast<const char*>(found.data()), found.size() * sizeof found.front());
    };
    if (kinds::integrator(scene_.integrator.name).from_lights)
      add(tier_.splats(buffers, is_long ? 256 : 16));
    else
      for (const GivenRay& ray : rays_) add(tier_.radiance(buffers, ray, 2));
    return light;
  }

  void trace(const Flip& flip, const std::vector<std::unique_ptr<Placed>>& places, bool is_checked,
             FlipProgress& told) {
    const std::int32_t was = packed_.index[flip.at];
    packed_.index[flip.at] = flip.value;
    if (!is_checked || fault().empty()) {
      bool is_changed = false;
      for (const std::unique_ptr<Placed>& place : places) {
        place->ints()[flip.at] = flip.value;
        // Of the processor's time: whoever takes more does not come to an end.
        const itimerval limit{{0, 0}, {20, 0}}, none{};
        setitimer(ITIMER_VIRTUAL, &limit, nullptr);
        is_changed |= light_of(place->buffers()) != light_;
        setitimer(ITIMER_VIRTUAL, &none, nullptr);
        place->ints()[flip.at] = was;
      }
      ++told.traced;
      told.changed += is_changed ? 1 : 0;
    }
    packed_.index[flip.at] = was;
  }

  const Scene& scene_;
  const TransportTier& tier_;
  std::vector<GivenRay> rays_;
  Features features_;
  PackOptions options_;
  PackedScene<Real> packed_;
  std::string light_;  ///< Without a flip.
};

/// As many places of a scene as this run may take.
std::size_t most_places() { return is_long ? 1U << 30 : 140; }

/// This run's share of all flips.
std::vector<Flip> own(const std::vector<Flip>& flips) {
  std::size_t first = 1, step = 1;
  if (is_long && std::strchr(all_flips, '/') != nullptr) REQUIRE(std::sscanf(all_flips, "%zu/%zu", &first, &step) == 2);
  REQUIRE((first >= 1 && first <= step));
  std::vector<Flip> some;
  for (std::size_t i = first - 1; i < flips.size(); i += step) some.push_back(flips[i]);
  return some;
}

template <class Real>
void flip_all(const Scene& scene, const TransportTier& tier) {
  Flipping<Real> flipping(scene, tier);
  REQUIRE(flipping.fault().empty());
  const std::vector<Flip> flips = own(flips_of(flipping.index(), most_places()));
  FlipOutcome all;
  const auto run = [&](const std::vector<Flip>& some, const std::vector<Flush>& flushes) {
    const FlipOutcome outcome = flipping.run(some, flushes);
    for (const std::string& fault : outcome.faults) UNSCOPED_INFO(fault);
    CHECK(outcome.faults.empty());
    all.flips += outcome.flips;
    all.traced += outcome.traced;
    all.changed += outcome.changed;
  };
  if (is_long) {
    run(flips, {Flush::with_end, Flush::with_begin});
  } else {  // Every flip both ways takes long.
    std::vector<Flip> even, odd;
    for (std::size_t i = 0; i < flips.size(); ++i) (i % 2 == 0 ? even : odd).push_back(flips[i]);
    run(even, {Flush::with_end});
    run(odd, {Flush::with_begin});
  }
  // All of these happen.
  CHECK(all.changed > 0);
  CHECK(all.traced > all.changed);
  CHECK(all.flips > all.traced);
  if (is_long)
    WARN(tier.name << " x " << tier.lanes << ": " << all.flips << " flips of " << flipping.index().size() << " ints, "
                   << all.traced << " of them traced, of which " << all.changed << " changed a path");
}

void flip_every_tier(const Scene& scene, const std::vector<TransportTier>& tiers) {
  for (const TransportTier& tier : tiers) {
    if (std::string(tier.name) == "double")
      flip_all<double>(scene, tier);
    else
      flip_all<float>(scene, tier);
  }
}

/// What light paths bring to the film is told of its first pixel.
void show_in_one_pixel(Scene& scene) { scene.film.width = scene.film.height = 1; }

Scene shipped(const std::string& name) {
  Scene scene = load_scene(STRAHL_SOURCE_DIR "/scenes/" + name).scene;
  // A day's sky has 131,072 texels and each an entry in the table that they are drawn with: 2,000 rays would hardly
  // draw one of them twice. So it is tried with 512, each of which is drawn.
  for (Light& entry : scene.lights)
    if (auto* const light = std::get_if<EnvironmentLight>(&entry.emitter);
        light != nullptr && name == "lights/sunsky.xml")
      light->texels = Sky(3, normalized(Vec3{-0.6, 0.6, 0.65})).image(32);
  if (kinds::integrator(scene.integrator.name).from_lights) show_in_one_pixel(scene);
  return scene;
}

/// Packs to thousands of ints at most.
const std::vector<std::string> few_scenes = {"lecture/lit.xml",         "instances/mushrooms.xml",
                                             "lights/screen.xml",       "lights/caustic.xml",
                                             "materials/blendbsdf.xml", "textures/mesh_attribute.xml"};

/// Scenes of scenes/, by their names there; those with media are apart. Without accuracy/: spheres, planes and a mesh
/// that others have as well, far from where rays meet them, or between mirrors that throw light back and forth without
/// end.
std::vector<std::string> all_scenes(bool has_media) {
  std::vector<std::string> names;
  const std::filesystem::path folder = STRAHL_SOURCE_DIR "/scenes";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path path = entry.path().lexically_relative(folder);
    if (path.extension() == ".xml" && *path.begin() != "accuracy" && shipped(path).media.empty() != has_media)
      names.push_back(path);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("a flipped index is refused, or does no harm") {
  std::vector<TransportTier> tiers = transport_robust();
  for (const std::string& name : is_long ? all_scenes(false) : few_scenes) {
    INFO(name);
    if (is_long) WARN(name);
    if (is_long)
      flip_every_tier(shipped(name), tiers);
    else
      flip_every_tier(shipped(name), {tiers.front()});
    std::rotate(tiers.begin(), tiers.begin() + 1, tiers.end());
  }
}

TEST_CASE("a flipped index leads no integrator astray") {
  if (!is_long) return;
  for (const char* name : {"lecture/lit.xml", "lights/caustic.xml", "textures/mesh_attribute.xml"})
    for (const std::string& integrator : kinds::integrator_names()) {
      INFO(name << ", " << integrator);
      WARN(name << ", " << integrator);
      Scene scene = shipped(name);
      scene.integrator.name = integrator;
      if (kinds::integrator(integrator).from_lights) show_in_one_pixel(scene);
      flip_every_tier(scene, transport_robust());
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
  for (const std::string& name : is_long ? all_scenes(true) : std::vector<std::string>{"media/candle.xml"}) {
    INFO(name);
    if (is_long) WARN(name);
    flip_every_tier(shipped(name), transport_media());
  }
}

TEST_CASE("what is read beyond the buffers is seen") {
  const Scene scene = shipped("lecture/lit.xml");
  const TransportTier tier = transport_robust().front();
  Flipping<float> flipping(scene, tier);
  for (const Flush flush : {Flush::with_end, Flush::with_begin}) {
    const std::int32_t materials = flipping.index()[layout::HEADER_MATERIALS];
    CHECK(flipping.run({{layout::HEADER_MATERIALS, materials}}, {flush}, false).faults.empty());
    CHECK(flipping.run({{layout::HEADER_MATERIALS, 0x7fffffff}}, {flush}, false).faults.size() == 1);
    CHECK(flipping.run({{layout::HEADER_MATERIALS, -0x7fffffff}}, {flush}, false).faults.size() == 1);
  }
}

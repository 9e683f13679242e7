// SPDX-License-Identifier: MIT
// A render that goes on from the film of an interrupted one, and parts that add up, have every bit of one run: picture,
// AOVs, told error; with other passes, lanes and bands, on another device.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/film_state.h"
#include "render/pictures.h"

namespace strahl::test {
namespace {

const std::filesystem::path cornell_box = scene_folder / "cornell/cornell-box.xml";

/// No multiple of any work-group's size; two sequences with halves of 8 and 8.
Scene picture(int spp = 32) { return small_scene(cornell_box, 29, 23, spp); }

RenderSettings settings_of(Precision precision = Precision::robust) {
  RenderSettings settings = all_aovs(precision);
  settings.error_map = true;
  settings.passes = 5;
  return settings;
}

/// The states after all launches of a render, or after every n-th.
std::vector<FilmState> states_of(Renderer& renderer, const RenderGoal& goal, int every = 1) {
  std::vector<FilmState> states;
  FilmKeeper keeper;
  int launches = 0;
  keeper.is_due = [&] { return launches++ % every == 0; };
  keeper.keep = [&](FilmState state) { states.push_back(std::move(state)); };
  static_cast<void>(renderer.render({}, goal, &keeper));
  return states;
}

RenderResult resumed(Renderer& renderer, const FilmState& state, const RenderGoal& goal) {
  FilmKeeper keeper;
  keeper.begin_with = &state;
  return renderer.render({}, goal, &keeper);
}

bool is_told_alike(const std::optional<ErrorEstimate>& a, const std::optional<ErrorEstimate>& b) {
  return a && b && a->rmse == b->rmse && a->rmse_low == b->rmse_low && a->rmse_high == b->rmse_high &&
         a->relmse == b->relmse;
}

bool are_one(const RenderResult& a, const RenderResult& b) {
  return same_bits(a, b) && same_bits(a.standard_error, b.standard_error) && is_told_alike(a.error, b.error);
}

int least_of(const FilmState& state) { return *std::min_element(state.film.samples.begin(), state.film.samples.end()); }

TEST_CASE("from any launch on, one pass or seven, lanes or none") {
  require_pocl_and_rusticl();
  const Device device = Device::open("pocl");
  RenderSettings seven = settings_of();
  seven.passes = 7;
  Renderer renderer(device, picture(), seven);
  const RenderResult expected = renderer.render();
  REQUIRE(expected.error);
  // One that does not know yet how much fits into a launch.
  Renderer slow(device, picture(), seven);
  const std::vector<FilmState> states = states_of(slow, {}, 3);
  // In the midst of rows and of ranges of samples.
  REQUIRE(std::any_of(states.begin(), states.end(), [](const FilmState& s) {
    return least_of(s) < *std::max_element(s.film.samples.begin(), s.film.samples.end());
  }));
  REQUIRE(least_of(states.front()) == 0);
  RenderSettings one_lane = settings_of();
  one_lane.lanes = 1;
  one_lane.passes = 2;
  Renderer other(device, picture(), one_lane);
  for (const FilmState& state : states) {
    INFO("least samples " << least_of(state));
    CHECK(are_one(expected, resumed(renderer, state, {})));
    CHECK(are_one(expected, resumed(other, state, {})));
  }
}

TEST_CASE("on another device") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl"), picture(8), settings_of());
  const RenderResult expected = renderer.render();
  const std::vector<FilmState> states = states_of(renderer, {});
  REQUIRE(states.size() > 2);
  Renderer other(Device::open("llvmpipe"), picture(8), settings_of());
  CHECK(are_one(expected, resumed(other, states[states.size() / 2], {})));
}

TEST_CASE("in double", "[slow]") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl", {true}), picture(8), settings_of(Precision::fp64));
  const RenderResult expected = renderer.render();
  for (const FilmState& state : states_of(renderer, {})) CHECK(are_one(expected, resumed(renderer, state, {})));
}

TEST_CASE("a film in bands") {
  require_pocl_and_rusticl();
  const Device whole = Device::open("pocl");
  Renderer renderer(whole, picture(), settings_of());
  const RenderResult expected = renderer.render();
  // Five rows beside the scene, and a quarter for the ring of samples.
  const std::uint64_t row = 29 * (208 + 160);
  Renderer banded(Device::open("pocl", {false, renderer.stats().scene_bytes + 7 * row}), picture(), settings_of());
  REQUIRE(banded.stats().device_bytes < renderer.stats().device_bytes);
  CHECK(are_one(expected, banded.render()));
  const std::vector<FilmState> states = states_of(banded, {}, 3);
  REQUIRE(states.size() > 4);
  for (const FilmState& state : states) {
    CHECK(are_one(expected, resumed(banded, state, {})));
    CHECK(are_one(expected, resumed(renderer, state, {})));
  }
  CHECK_THROWS_WITH(Renderer(Device::open("pocl", {false, renderer.stats().scene_bytes + row / 2}), picture()),
                    Catch::Matchers::Contains("a row of the picture takes"));
}

TEST_CASE("one sum a pixel, which stays on the device") {
  require_pocl_and_rusticl();
  RenderSettings settings;
  settings.estimate_error = false;
  settings.passes = 3;
  Renderer renderer(Device::open("pocl"), picture(6), settings);
  const RenderResult expected = renderer.render();
  for (const FilmState& state : states_of(renderer, {})) CHECK(same_bits(expected, resumed(renderer, state, {})));
}

TEST_CASE("an error as the goal ends it at the same sample") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl"), picture(), settings_of());
  RenderGoal goal;
  goal.max_error = 0.06;
  const RenderResult expected = renderer.render({}, goal);
  REQUIRE(expected.ending == Ending::error);
  for (const FilmState& state : states_of(renderer, goal, 4)) {
    const RenderResult result = resumed(renderer, state, goal);
    CHECK(result.ending == Ending::error);
    CHECK(result.stats.spp == expected.stats.spp);
    CHECK(are_one(expected, result));
  }
}

TEST_CASE("an error that is reached already ends it at once") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl"), picture(), settings_of());
  RenderGoal tight, loose;
  tight.max_error = 0.03;
  loose.max_error = 0.06;
  const int enough = renderer.render({}, loose).stats.spp;
  int looked_at = 0;
  for (const FilmState& state : states_of(renderer, tight, 4)) {
    const int most = *std::max_element(state.film.samples.begin(), state.film.samples.end());
    if (most < enough) continue;
    const RenderResult result = resumed(renderer, state, loose);
    CHECK(result.ending == Ending::error);
    CHECK(result.stats.spp == most);
    ++looked_at;
  }
  CHECK(looked_at > 0);
}

TEST_CASE("what is finished is finished, and goes on to more samples") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl"), picture(), settings_of());
  FilmKeeper keeper;
  std::optional<FilmState> last;
  keeper.keep_last = [&](FilmState state) { last = std::move(state); };
  const RenderResult expected = renderer.render({}, {}, &keeper);
  REQUIRE(last);
  const RenderResult again = resumed(renderer, *last, {});
  CHECK(are_one(expected, again));
  CHECK(again.stats.camera_rays == 0);
  RenderGoal more;
  more.spp = 40;  // Divided among the sums as 32 are.
  CHECK(are_one(renderer.render({}, more), resumed(renderer, *last, more)));
  more.spp = 64;
  CHECK_THROWS_AS(resumed(renderer, *last, more), InputError);
  more.spp = 16;
  CHECK_THROWS_AS(resumed(renderer, *last, more), InputError);
}

/// Of a render of `spp` samples that the callback stops after so many launches.
FilmState stopped_after(Renderer& renderer, int launches, int spp) {
  FilmState stopped;
  FilmKeeper keeper;
  keeper.keep_last = [&](FilmState state) { stopped = std::move(state); };
  RenderGoal goal;
  goal.spp = spp;
  static_cast<void>(renderer.render([&](const Progress&) { return --launches > 0; }, goal, &keeper));
  return stopped;
}

TEST_CASE("a deadline ends it soon, however long the pass was that was under way") {
  require_pocl_and_rusticl();
  Scene scene = picture();
  scene.sampler.kind = SamplerKind::independent;  // Any number of samples is divided alike.
  RenderSettings settings = settings_of();
  settings.passes.reset();
  const bool are_shared = GENERATE(true, false);
  if (!are_shared) settings.disabled = without_sharing;
  Renderer renderer(Device::open("pocl"), scene, settings);
  const FilmState state = stopped_after(renderer, 3, max_spp);
  REQUIRE(state.position.done == max_spp);
  // Launches of whole rows take few samples of all pixels.
  REQUIRE(least_of(state) <= (are_shared ? max_spp / 2 : 0));
  RenderGoal goal;
  goal.deadline = later(Clock::now(), 1);
  const RenderResult result = resumed(renderer, state, goal);
  CHECK(std::chrono::duration<double>(Clock::now() - *goal.deadline).count() < 0.5);
  CHECK(result.ending == Ending::deadline);
  CHECK(result.stats.least_spp > *std::max_element(state.film.samples.begin(), state.film.samples.end()));
  CHECK(result.stats.most_spp - result.stats.least_spp <= 1);
  RenderGoal error;
  error.max_error = 0.06;
  const RenderResult reached = resumed(renderer, state, error);
  CHECK(reached.ending == Ending::error);
  CHECK(reached.stats.most_spp == reached.stats.least_spp);
  CHECK(reached.stats.spp < 1000);
}

TEST_CASE("in passes by the clock it goes on to the same picture, in bands too") {
  require_pocl_and_rusticl();
  Scene scene = picture();
  scene.sampler.kind = SamplerKind::independent;
  Renderer renderer(Device::open("pocl"), scene, settings_of());
  const RenderResult expected = renderer.render();
  const std::uint64_t row = 29 * (208 + 160);
  Renderer banded(Device::open("pocl", {false, renderer.stats().scene_bytes + 7 * row}), scene, settings_of());
  RenderGoal goal;
  goal.spp = 32;
  goal.deadline = later(Clock::now(), 1000);
  for (const FilmState& state : states_of(banded, {}, 5)) {
    CHECK(are_one(expected, resumed(banded, state, goal)));
    CHECK(are_one(expected, resumed(renderer, state, goal)));
  }
}

TEST_CASE("no time for a single sample leaves an empty film") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl"), picture(), settings_of());
  const RenderResult expected = renderer.render();
  RenderGoal goal;
  goal.deadline = Clock::now();
  FilmKeeper keeper;
  std::optional<FilmState> last;
  keeper.keep_last = [&](FilmState state) { last = std::move(state); };
  static_cast<void>(renderer.render({}, goal, &keeper));
  REQUIRE(last);
  CHECK(least_of(*last) == 0);
  for (const std::int64_t word : last->film.words) REQUIRE(word == 0);
}

TEST_CASE("launches are told apart from what the host does alone") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl"), picture(), settings_of());
  FilmKeeper keeper;
  bool are_under_way = false;
  int kept = 0, told = 0, passes = 0;
  keeper.launches = [&](bool now) {
    passes += now && !are_under_way ? 1 : 0;
    are_under_way = now;
  };
  keeper.is_due = [&] {
    CHECK(are_under_way);
    return ++told % 2 == 0;
  };
  keeper.keep = keeper.keep_last = [&](const FilmState&) {
    CHECK_FALSE(are_under_way);
    ++kept;
  };
  keeper.is_done = [&] { CHECK_FALSE(are_under_way); };
  RenderGoal goal;
  goal.max_error = 1e-9;
  goal.spp = 32;
  const auto progress = [&](const Progress&) {
    CHECK(are_under_way);
    return true;
  };
  CHECK(renderer.render(progress, goal, &keeper).ending == Ending::samples);
  CHECK(kept > 1);
  // Each look at the error, each film that is kept, is followed by launches; the last pass by none.
  CHECK(passes >= kept);
  CHECK_FALSE(are_under_way);
  // Whatever ends it.
  kept = 0;
  keeper.is_due = {};
  const auto stop = [&](const Progress&) { return false; };
  CHECK(renderer.render(stop, goal, &keeper).ending == Ending::stopped);
  CHECK(kept == 1);
  // In a pass that an earlier run began, too.
  const FilmState state = stopped_after(renderer, 1, 32);
  REQUIRE(least_of(state) < state.position.done);
  keeper.begin_with = &state;
  CHECK(renderer.render(progress, {}, &keeper).ending == Ending::samples);
  CHECK_FALSE(are_under_way);
}

TEST_CASE("no memory to keep a film in is told, and the picture is the same") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl"), picture(8), settings_of());
  const RenderResult expected = renderer.render();
  FilmKeeper keeper;
  int kept = 0, not_kept = 0, not_kept_last = 0;
  keeper.is_due = [] { return true; };
  keeper.spare = []() -> FilmState { throw std::bad_alloc(); };
  keeper.keep = keeper.keep_last = [&](const FilmState&) { ++kept; };
  CHECK_THROWS_AS(renderer.render({}, {}, &keeper), std::bad_alloc);
  keeper.no_memory = [&](bool is_last) { ++(is_last ? not_kept_last : not_kept); };
  CHECK(are_one(expected, renderer.render({}, {}, &keeper)));
  CHECK(kept == 0);
  CHECK(not_kept > 1);
  CHECK(not_kept_last == 1);
}

TEST_CASE("parts add up in any order") {
  require_pocl_and_rusticl();
  for (const SamplerKind sampler : {SamplerKind::sobol, SamplerKind::independent}) {
    Scene scene = picture(37);
    scene.sampler.kind = sampler;
    Renderer renderer(Device::open("pocl"), scene, settings_of());
    const RenderResult whole = renderer.render();
    std::vector<FilmState> parts;
    FilmKeeper keeper;
    keeper.keep_last = [&](FilmState state) { parts.push_back(std::move(state)); };
    for (const auto& [first, end] : {std::pair(0, 1), std::pair(1, 14), std::pair(14, 20), std::pair(20, 37)}) {
      RenderGoal goal;
      goal.samples = SampleRange{first, end - first};
      const RenderResult part = renderer.render({}, goal, &keeper);
      CHECK(part.stats.least_spp == end - first);
      CHECK(part.error.has_value() == (end - first >= 4));
    }
    FilmSums sum = parts[2].film;
    sum.first_sample = 0;
    for (const int i : {3, 0, 1}) {
      sum.add_words(0, parts[static_cast<std::size_t>(i)].film.words);
      for (std::size_t at = 0; at < sum.samples.size(); ++at)
        sum.samples[at] += parts[static_cast<std::size_t>(i)].film.samples[at];
    }
    CHECK(same_bits(whole.color, sum.mean()));
    CHECK(is_told_alike(whole.error, estimate_error(sum)));
    CHECK(same_bits(whole.standard_error, standard_error(sum)));
  }
  Renderer renderer(Device::open("pocl"), picture(), settings_of());
  RenderGoal goal;
  goal.samples = SampleRange{16, 17};
  CHECK_THROWS_AS(renderer.render({}, goal), UsageError);
}

TEST_CASE("a part is told of by itself") {
  require_pocl_and_rusticl();
  RenderGoal goal;
  goal.seed = 77;
  const Image truth = Renderer(Device::open("pocl"), picture(4096), settings_of()).render({}, goal).color;
  Renderer renderer(Device::open("pocl"), picture(256), settings_of());
  goal.samples = SampleRange{96, 64};
  double told = 0, squared = 0;
  for (std::uint32_t seed = 0; seed < 16; ++seed) {
    goal.seed = seed;
    const RenderResult part = renderer.render({}, goal);
    REQUIRE(part.error);
    told += std::pow(part.error->rmse, 2) * static_cast<double>(truth.data.size());
    for (std::size_t i = 0; i < truth.data.size(); ++i)
      squared += std::pow(static_cast<double>(part.color.data[i]) - static_cast<double>(truth.data[i]), 2);
  }
  CHECK(told == Approx(squared).epsilon(0.3));
}

TEST_CASE("a part that has one half of each sequence is told an interval, too") {
  require_pocl_and_rusticl();
  Renderer renderer(Device::open("pocl"), picture(256), settings_of());
  RenderGoal goal;
  goal.samples = SampleRange{0, 64};
  const RenderResult part = renderer.render({}, goal);
  REQUIRE(part.error);
  CHECK(part.error->rmse_low < 0.97 * part.error->rmse);
  CHECK(part.error->rmse_high > 1.03 * part.error->rmse);
}

}  // namespace
}  // namespace strahl::test

// SPDX-License-Identifier: MIT
// Where no thread can be begun any more, a picture is finished all the same.
#include <pthread.h>

#include <catch2/catch.hpp>
#include <system_error>
#include <thread>

#include "render/film_parts.h"
#include "render/pictures.h"

namespace strahl::test {
namespace {

/// No thread with the default attributes can be begun while this lives: no address space holds its stack.
class NoThreads {
 public:
  NoThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t endless;
    pthread_attr_init(&endless);
    pthread_attr_setstacksize(&endless, std::size_t{1} << 60);
    pthread_setattr_default_np(&endless);
    pthread_attr_destroy(&endless);
  }
  ~NoThreads() {
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

 private:
  pthread_attr_t before_{};
};

}  // namespace

TEST_CASE("a finished picture needs no thread more") {
  require_pocl();
  RenderSettings settings;
  settings.error_map = true;
  Renderer renderer(Device::open("pocl"), small_scene(scene_folder / "cornell/cornell-box.xml", 128, 128, 8), settings);
  REQUIRE(film_parts(128, std::size_t{128} * 24 * sizeof(std::int64_t), 2).size() > 1);
  const RenderResult expected = renderer.render();
  const NoThreads none;
  REQUIRE_THROWS_AS(std::thread([] {}), std::system_error);
  RenderGoal goal;
  CHECK(same_bits(Renderer(Device::open("pocl"), renderer.scene(), settings).render().color, expected.color));
  for (const bool has_deadline : {false, true}) {
    if (has_deadline) goal.deadline = later(Clock::now(), 60);
    goal.spp = 8;
    const RenderResult result = renderer.render({}, goal);
    CHECK(same_bits(result.color, expected.color));
    CHECK(same_bits(result.standard_error, expected.standard_error));
    REQUIRE(result.error);
  }
}

}  // namespace strahl::test

// SPDX-License-Identifier: MIT
#include "kinds/integrators.h"

#include <array>
#include <stdexcept>

namespace strahl::kinds {
namespace {

namespace rows {
constexpr IntegratorFacts emission{.name = "emission", .shows_emission = true, .is_noiseless = true};
constexpr IntegratorFacts depth{.name = "depth", .is_noiseless = true, .is_length = true};
constexpr IntegratorFacts normals{.name = "normals", .reads_shading = true, .is_noiseless = true};
constexpr IntegratorFacts direct{.name = "direct",
                                 .lamps = Lamps::taken,
                                 .follows = Follows::one_way,
                                 .shows_emission = true,
                                 .reads_shading = true};
constexpr IntegratorFacts whitted{.name = "whitted",
                                  .lamps = Lamps::taken,
                                  .follows = Follows::mirrors,
                                  .shows_emission = true,
                                  .reads_shading = true};
constexpr IntegratorFacts path{
    .name = "path", .lamps = Lamps::drawn, .follows = Follows::paths, .shows_emission = true, .reads_shading = true};
constexpr IntegratorFacts volpath{.name = "volpath",
                                  .lamps = Lamps::drawn,
                                  .follows = Follows::paths,
                                  .shows_emission = true,
                                  .reads_shading = true,
                                  .goes_through = true};
constexpr IntegratorFacts ao{.name = "ao", .reads_shading = true, .asks_openness = true};
constexpr IntegratorFacts ptracer{.name = "ptracer",
                                  .lamps = Lamps::drawn,
                                  .follows = Follows::paths,
                                  .shows_emission = true,
                                  .reads_shading = true,
                                  .from_lights = true};
constexpr IntegratorFacts bdpt{.name = "bdpt",
                               .lamps = Lamps::drawn,
                               .follows = Follows::paths,
                               .shows_emission = true,
                               .reads_shading = true,
                               .from_lights = true,
                               .from_camera = true};

}  // namespace rows

constexpr std::array all{
#define INTEGRATOR(name) rows::name,
#include "../../cl/integrators/integrators.def"
#undef INTEGRATOR
};

}  // namespace

const IntegratorFacts& integrator(const std::string& name) {
  for (const IntegratorFacts& facts : all)
    if (name == facts.name) return facts;
  throw std::logic_error("integrators.def has no " + name);
}

const std::vector<std::string>& integrator_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const IntegratorFacts& facts : all) found.emplace_back(facts.name);
    return found;
  }();
  return names;
}

}  // namespace strahl::kinds

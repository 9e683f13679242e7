// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>

#include "kinds/entries.h"
#include "kinds/lights.h"
#include "packing/cl_layout.h"
#include "packing/entry_numbers.h"
#include "packing/packed_ranges.h"

namespace strahl {
namespace {

const std::map<std::string, int> reals_of_areas = {
#define AREA(name, reals) {#name, reals},
#include "../../cl/areas/areas.def"
#undef AREA
};

template <typename Real>
class Lights {
 public:
  Lights(PackedRanges<Real>& ranges, const PackedFacts& facts) : ranges_(ranges), facts_(facts) {
    EntryNumbers numbers(facts.features);
    for (const Light& light : facts.scene.lights) {
      const std::string kind = light_kind(light);
      reals_[numbers("lights", kind)] =
          static_cast<std::int64_t>(kinds::light_reals(light, facts.options.frame).size());
    }
    for (const auto& [name, reals] : reals_of_areas)
      if (const int kind = facts.features.entry_index("areas", name); kind >= 0) areas_[kind] = {name, reals};
    area_ = facts.features.entry_index("lights", "area");
    beams_ = facts.features.entry_index("lights", "directionalarea");
    envmap_ = facts.features.entry_index("lights", "envmap");
  }

  void run() {
    const std::int64_t count = ranges_.at(layout::HEADER_LIGHT_COUNT);
    const auto most = static_cast<std::int64_t>(facts_.scene.lights.size() + facts_.parts.size());
    if (!ranges_.within(count, 0, most + 1, "the number of lights")) return;
    const std::int64_t taken = ranges_.at(layout::HEADER_LIGHTS_TAKEN), first = ranges_.at(layout::HEADER_LIGHTS);
    ranges_.within(taken, 0, count + 1, "the number of lights that are taken");
    std::int64_t rows = count;
    for (const int field : {layout::HEADER_BACKGROUND, layout::HEADER_SUN}) {
      const std::int64_t row = ranges_.at(field);
      // One that rays only find stands behind those that are counted.
      if (!ranges_.within(row, -1, most, "the light from afar")) return;
      rows = std::max(rows, row + 1);
    }
    if (!ranges_.index(first, rows * layout::LIGHT_INTS, "the lights")) return;
    for (std::int64_t i = 0; i < rows && ranges_.fault().empty(); ++i) light(first + i * layout::LIGHT_INTS, i);
    ranges_.require(
        ranges_.at(layout::HEADER_CHOOSER) == facts_.features.entry_index("choosers", facts_.features.light_chooser),
        "the chooser of lights");
    if (count - taken >= 2 && ranges_.fault().empty()) chooser(count - taken);
  }

 private:
  void light(std::int64_t row, std::int64_t i) {
    const int kind = ranges_.at(row + layout::LIGHT_KIND);
    ranges_.within(ranges_.at(row + layout::LIGHT_ALIKE), 0, i + 1, "the light that is like light", i);
    ranges_.within(ranges_.at(row + layout::LIGHT_TEXTURE), -1, facts_.texture_rows, "the texture of light", i);
    if (kind >= 0 && (kind == area_ || kind == beams_)) return area(row, i);
    const auto known = reals_.find(kind);
    if (!ranges_.require(known != reals_.end() && kind >= 0, "the kind of light", i)) return;
    if (kind == envmap_)
      environment(row, i);
    else
      ranges_.shading(ranges_.at(row + layout::LIGHT_REALS), known->second, "the parameters of light", i);
  }

  void area(std::int64_t row, std::int64_t i) {
    const auto known = areas_.find(ranges_.at(row + layout::LIGHT_AREA));
    if (!ranges_.require(known != areas_.end(), "the area of light", i)) return;
    const std::int64_t items = ranges_.at(row + layout::LIGHT_ITEMS), part = ranges_.at(row + layout::LIGHT_PART);
    if (!ranges_.require(items >= 1, "the items of light", i)) return;
    ranges_.shading(ranges_.at(row + layout::LIGHT_REALS), layout::AREA_ITEMS + items * known->second.reals,
                    "the parameters of light", i);
    choices(ranges_.at(row + layout::LIGHT_CHOICE), items, "the choices of light", i);
    if (!ranges_.within(part, 0, static_cast<std::int64_t>(facts_.parts.size()), "the part of light", i)) return;
    if (ranges_.at(row + layout::LIGHT_TEXTURE) < 0) return;
    const bool is_flat = known->second.name == "triangle" || known->second.name == "parallelogram";
    const std::int64_t reals = is_flat ? 6 * items : known->second.name == "sphere" ? 9 : 0;
    if (reals > 0) ranges_.shading(ranges_.at(row + layout::LIGHT_UVS), reals, "the texture coordinates of light", i);
    // What its items have of a mesh is read by their numbers.
    if (ranges_.at(ranges_.at(layout::HEADER_PARTS) + part * layout::PART_INTS + layout::PART_ATTRIBUTES) != -1)
      ranges_.require(items <= facts_.parts[static_cast<std::size_t>(part)].primitives, "the part of light", i);
  }

  void environment(std::int64_t row, std::int64_t i) {
    const std::int64_t image = ranges_.at(row + layout::LIGHT_IMAGE);
    check_image(ranges_, image);
    if (!ranges_.fault().empty()) return;
    const std::int64_t width = ranges_.at(image + layout::IMAGE_WIDTH),
                       rows = ranges_.at(image + layout::IMAGE_HEIGHT) - 1;
    if (!ranges_.require(rows >= 1, "the rows of light", i)) return;
    ranges_.shading(ranges_.at(row + layout::LIGHT_REALS), layout::ENVMAP_ROWS + rows, "the parameters of light", i);
    const std::int64_t at = ranges_.at(row + layout::LIGHT_CHOICE);
    choices(at, rows, "the choices of light", i);
    for (std::int64_t k = 0; k < rows && ranges_.fault().empty(); ++k)
      choices(at + (rows + k * width) * layout::CHOICE_INTS, width, "the choices of light", i);
  }

  void choices(std::int64_t at, std::int64_t count, const char* what, std::int64_t which) {
    if (!ranges_.index(at, count * layout::CHOICE_INTS, what, which)) return;
    for (std::int64_t i = 0; i < count; ++i)
      if (!ranges_.within(ranges_.at(at + i * layout::CHOICE_INTS + layout::CHOICE_GUIDE), 0, count, what, which))
        return;
  }

  void chooser(std::int64_t lights) {
    const std::int64_t chances = ranges_.at(layout::HEADER_CHANCES), at = ranges_.at(layout::HEADER_CHOICES);
    if (facts_.features.light_chooser == "power") {
      ranges_.shading(chances, lights, "the rarities of lights");
      choices(at, lights, "the choices of lights", -1);
    }
    if (facts_.features.light_chooser == "each")
      ranges_.shading(chances, lights * layout::LIGHT_CHILD_REALS, "the reaches of lights");
    if (facts_.features.light_chooser != "tree") return;
    const std::int64_t nodes = lights - 1, links = at + lights;
    ranges_.shading(chances, 2 * nodes * layout::LIGHT_CHILD_REALS, "the tree of lights");
    if (!ranges_.index(at, lights + 2 * nodes, "the tree of lights")) return;
    // A child comes behind its parent, so every way ends.
    for (std::int64_t i = 0; i < 2 * nodes; ++i) {
      const std::int64_t link = ranges_.at(links + i);
      ranges_.require(link >= 0 ? i / 2 < link && link < nodes : -1 - link < lights, "a link of the tree of lights", i);
    }
  }

  struct Area {
    std::string name;
    std::int64_t reals = 0;
  };

  PackedRanges<Real>& ranges_;
  const PackedFacts& facts_;
  std::map<int, std::int64_t> reals_;  ///< Of each kind of light of the scene.
  std::map<int, Area> areas_;
  int area_ = -1, beams_ = -1, envmap_ = -1;
};

}  // namespace

template <typename Real>
void check_lights(PackedRanges<Real>& ranges, const PackedFacts& facts) {
  if (ranges.fault().empty()) Lights<Real>(ranges, facts).run();
}

template void check_lights(PackedRanges<float>&, const PackedFacts&);
template void check_lights(PackedRanges<double>&, const PackedFacts&);

}  // namespace strahl

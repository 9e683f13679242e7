// SPDX-License-Identifier: MIT
#include "study/stress.h"

#include <fmt/format.h>

#include <map>

#include "image/metrics.h"
#include "kinds/integrators.h"
#include "render/renderer.h"
#include "study/contact_sheet.h"
#include "study/transformed.h"

namespace strahl {
namespace {

constexpr double widest_lamp = 1e-2, lamp_distance = 2;

Scene stressed(const Scene& scene, const Stress& stress) {
  if (stress.light != 1) return brightened(scene, stress.light);
  if (stress.far != 0) return with_lamp(scene, stress.far, widest_lamp);
  if (stress.lamp != 0) return with_lamp(scene, lamp_distance, stress.lamp);
  return translated(scaled(scene, stress.scale), {stress.offset, stress.offset, stress.offset});
}

/// What the picture would be with exact numbers: that of the scene as it is, or, with the same lamp, the reference's
/// own, since another lamp lights a bit otherwise.
Stress calm(const Stress& stress) { return stress.far != 0 || stress.lamp != 0 ? stress : Stress{}; }

/// What the picture is divided by: a distance grows with the scene, light with the emitters, and what depends on
/// neither stays.
double unit_of(const Scene& scene, const Stress& stress) {
  const std::string& name = scene.integrator.name;
  if (kinds::integrator(name).is_length) return stress.scale;
  return name == "normals" || name == "ao" ? 1 : stress.light;
}

Image picture(const Device& device, const Scene& scene, Precision precision) {
  RenderSettings settings;
  settings.precision = precision;
  return Renderer(device, scene, settings).render().color;
}

}  // namespace

std::string Stress::text() const {
  if (offset != 0) return fmt::format("offset {:g}", offset);
  if (light != 1) return fmt::format("light {:g}", light);
  if (far != 0) return fmt::format("far {:g}", far);
  if (lamp != 0) return fmt::format("lamp {:g}", lamp);
  return scale == 1 ? "as it is" : fmt::format("scale {:g}", scale);
}

const std::vector<Stress>& all_stresses() {
  static const std::vector<Stress> stresses{
      {1e-6},           {1e-3},          {},           {1e3},         {1e6}, {1, 1e3}, {1, 1e5}, {1, 1e7},
      {.light = 1e-10}, {.light = 1e10}, {.far = 1e7}, {.lamp = 1e-7}};
  return stresses;
}

StressStudy study_stress(const Device& device, const Scene& scene, const StressProgress& progress) {
  StressStudy study;
  study.tiers = {Precision::fast, Precision::stable, Precision::robust};
  if (device.info().fp64)
    study.tiers.push_back(Precision::fp64);
  else
    study.reference = Precision::robust;
  const int total = static_cast<int>(study.tiers.size() * all_stresses().size());
  int done = 0;
  std::map<std::string, Image> references;
  for (const Stress& stress : all_stresses()) {
    const Stress reference = calm(stress);
    if (!references.contains(reference.text()))
      references[reference.text()] = picture(device, stressed(scene, reference), study.reference);
  }
  for (const Precision tier : study.tiers) {
    std::vector<StressCell>& row = study.cells.emplace_back();
    for (const Stress& stress : all_stresses()) {
      Image image = picture(device, stressed(scene, stress), tier);
      const double unit = unit_of(scene, stress);
      for (float& value : image.data) value = static_cast<float>(value / unit);
      const double rmse = compare_images(image, references.at(calm(stress).text()), Metric::rmse);
      row.push_back({std::move(image), rmse});
      if (progress) progress(++done, total);
    }
  }
  return study;
}

Image stress_sheet(const StressStudy& study) {
  std::vector<std::string> columns;
  for (const Stress& stress : all_stresses()) columns.push_back(stress.text());
  std::vector<SheetRow> rows;
  for (std::size_t i = 0; i < study.tiers.size(); ++i) {
    SheetRow row{precision_name(study.tiers[i]), {}};
    for (const StressCell& cell : study.cells[i]) row.tiles.push_back({cell.picture, fmt::format("{:.2g}", cell.rmse)});
    rows.push_back(std::move(row));
  }
  return contact_sheet(columns, rows);
}

}  // namespace strahl

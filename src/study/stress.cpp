// SPDX-License-Identifier: MIT
#include "study/stress.h"

#include <fmt/format.h>

#include "image/metrics.h"
#include "render/renderer.h"
#include "study/contact_sheet.h"
#include "study/transformed.h"

namespace strahl {
namespace {

Scene stressed(const Scene& scene, const Stress& stress) {
  return translated(scaled(scene, stress.scale), {stress.offset, stress.offset, stress.offset});
}

Image picture(const Device& device, const Scene& scene, Precision precision) {
  RenderSettings settings;
  settings.precision = precision;
  return Renderer(device, scene, settings).render().color;
}

}  // namespace

std::string Stress::text() const {
  if (offset != 0) return fmt::format("offset {:g}", offset);
  return scale == 1 ? "as it is" : fmt::format("scale {:g}", scale);
}

const std::vector<Stress>& all_stresses() {
  static const std::vector<Stress> stresses{{1e-6, 0}, {1e-3, 0}, {1, 0},   {1e3, 0},
                                            {1e6, 0},  {1, 1e3},  {1, 1e5}, {1, 1e7}};
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
  const Image reference = picture(device, scene, study.reference);
  for (const Precision tier : study.tiers) {
    std::vector<StressCell>& row = study.cells.emplace_back();
    for (const Stress& stress : all_stresses()) {
      Image image = picture(device, stressed(scene, stress), tier);
      const double rmse = compare_images(image, reference, Metric::rmse);
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

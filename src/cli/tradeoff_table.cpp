// SPDX-License-Identifier: MIT
#include "cli/tradeoff_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "settings/sampler_name.h"

namespace strahl::cli {
namespace {

/// What rows of samples have in common.
std::string words(const TradeoffSetting& setting) {
  const std::string depth = !setting.max_depth       ? ""
                            : *setting.max_depth < 0 ? "no limit"
                                                     : fmt::format("depth {}", *setting.max_depth);
  return fmt::format("{:<7} {:<12} {:<9}{}", precision_name(setting.precision), sampler_name(setting.sampler), depth,
                     setting.generic ? " generic" : "");
}

std::string reference_line(const TradeoffReference& reference) {
  const std::string what =
      reference.setting
          ? fmt::format("{}, {} samples a pixel", precision_name(reference.setting->precision), reference.setting->spp)
          : fmt::format("\"{}\"", reference.source);
  const std::string error = reference.rmse ? fmt::format("its own RMSE {:.2g}", *reference.rmse) : "its error unknown";
  return fmt::format("against {}; {}\n", what, error);
}

std::string front(const TradeoffStudy& study) {
  std::vector<const TradeoffPoint*> points;
  for (const TradeoffPoint& point : study.points)
    if (point.pareto) points.push_back(&point);
  std::sort(points.begin(), points.end(),
            [](const auto* a, const auto* b) { return a->seconds.kernel < b->seconds.kernel; });
  std::string text = fmt::format("{:>9} {:>9} {:>10} {:>21} {:>9} {:>9}  Pareto front\n", "kernel s", "wall s", "RMSE",
                                 "95 %", "bias^2", "variance");
  for (const TradeoffPoint* point : points)
    text += fmt::format("{:>9.4f} {:>9.3f} {:>10.3g} {:>21} {:>9.2g} {:>9.2g}  {:>4} spp  {}\n", point->seconds.kernel,
                        point->seconds.wall, point->error.rmse(),
                        fmt::format("{:.3g} to {:.3g}", point->error.rmse_low(), point->error.rmse_high()),
                        point->error.bias2, point->error.variance, point->setting.spp, words(point->setting));
  return text;
}

std::string slope(const PowerLaw& law) {
  return fmt::format("{:>6.2f} ({:.2f} to {:.2f})", law.slope, law.slope_low, law.slope_high);
}

std::string slopes(const TradeoffStudy& study) {
  if (study.fits.empty()) return "";
  std::string text =
      fmt::format("\n{:<24} {:<24} slope of log RMSE, 95 %\n", "against kernel seconds", "against samples");
  for (const TradeoffFit& fit : study.fits)
    text += fmt::format("{:<24} {:<24} {}\n", slope(fit.seconds), fit.samples ? slope(*fit.samples) : "",
                        words(fit.setting));
  return text;
}

}  // namespace

std::string tradeoff_table(const TradeoffStudy& study) {
  return reference_line(study.reference) + front(study) + slopes(study);
}

}  // namespace strahl::cli

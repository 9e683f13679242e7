// SPDX-License-Identifier: MIT
#include "study/tradeoff/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "errors.h"
#include "settings/sampling.h"

namespace strahl {
namespace {

using Depth = std::optional<int>;

/// For comparison: no limit is the deepest.
int reach(const Depth& depth) { return !depth || *depth < 0 ? std::numeric_limits<int>::max() : *depth; }

bool is_shallower(const Depth& a, const Depth& b) { return reach(a) < reach(b); }

template <class T>
bool lists(const std::vector<T>& values, const T& value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

/// As the axis has them, each once.
template <class T>
void drop_repeats(std::vector<T>& values) {
  std::vector<T> once;
  for (const T& value : values)
    if (!lists(once, value)) once.push_back(value);
  values = once;
}

void settle(TradeoffAxes& axes, const IntegratorSettings& integrator) {
  if (axes.depths.empty()) axes.depths = {has_depth(integrator) ? Depth(integrator.max_depth) : Depth()};
  for (const Depth& depth : axes.depths)
    if (depth.has_value() != has_depth(integrator))
      throw UsageError(
          fmt::format("integrator {} has no max_depth that could be varied: leave --depth out", integrator.name));
  if (axes.precisions.empty() || axes.samplers.empty() || axes.spps.empty())
    throw UsageError("a study needs at least one precision, one sampler and one number of samples");
  for (const int spp : axes.spps)
    if (spp < 1 || spp > max_spp) throw UsageError(fmt::format("--spp takes 1 to {}, not {}", max_spp, spp));
  std::sort(axes.spps.begin(), axes.spps.end());
  std::stable_sort(axes.depths.begin(), axes.depths.end(), is_shallower);
  drop_repeats(axes.spps);
  drop_repeats(axes.depths);
  drop_repeats(axes.precisions);
  drop_repeats(axes.samplers);
}

}  // namespace

std::vector<std::optional<int>> default_depths(const IntegratorSettings& integrator) {
  if (!has_depth(integrator)) return {Depth()};
  const Depth own = integrator.max_depth;
  std::vector<Depth> depths;
  for (const Depth& depth : {Depth(2), Depth(4), Depth(8)})
    if (is_shallower(depth, own)) depths.push_back(depth);
  depths.push_back(own);
  return depths;
}

TradeoffPlan plan_tradeoff(const IntegratorSettings& integrator, TradeoffAxes axes, Precision reference_precision,
                           int reference_spp) {
  settle(axes, integrator);
  const Depth own = has_depth(integrator) ? Depth(integrator.max_depth) : Depth();
  TradeoffPlan plan;
  plan.centre = {lists(axes.precisions, Precision::robust) ? Precision::robust : axes.precisions.back(),
                 axes.samplers.front(), lists(axes.depths, own) ? own : axes.depths.back(), axes.spps.back(), false};
  plan.reference = plan.centre;
  plan.reference.precision = reference_precision;
  plan.reference.sampler = SamplerKind::sobol;
  plan.reference.spp = reference_spp;
  plan.reference.max_depth = std::max(own, axes.depths.back(), is_shallower);

  const auto add_row = [&](TradeoffSetting setting) {
    for (const int spp : axes.spps) {
      setting.spp = spp;
      plan.settings.push_back(setting);
    }
  };
  TradeoffSetting setting = plan.centre;
  for (const Precision precision : axes.precisions)
    for (const SamplerKind sampler : axes.samplers) {
      setting.precision = precision;
      setting.sampler = sampler;
      add_row(setting);
    }
  for (const Depth& depth : axes.depths)
    for (const SamplerKind sampler : axes.samplers) {
      setting = plan.centre;
      setting.max_depth = depth;
      setting.sampler = sampler;
      if (depth != plan.centre.max_depth) add_row(setting);
    }
  setting = plan.centre;
  setting.generic = true;
  if (axes.generic) add_row(setting);
  return plan;
}

}  // namespace strahl

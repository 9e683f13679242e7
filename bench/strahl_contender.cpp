// SPDX-License-Identifier: MIT
#include "bench/strahl_contender.h"

#include <fmt/format.h>

namespace strahl::bench {
namespace {

std::string variant_of(const RenderSettings& settings) {
  std::string text = precision_name(settings.precision);
  if (settings.bvh_width) text += fmt::format(" {} wide", *settings.bvh_width);
  if (settings.coherent) text += " coherent";
  return text;
}

}  // namespace

StrahlContender::StrahlContender(const Device& device, const Scene& scene, const RenderSettings& settings)
    : variant_(variant_of(settings)), intersector_(device, scene, settings) {}

double StrahlContender::trace() {
  hits_ = intersector_.trace(set_->rays, set_->any_hit());
  return intersector_.stats().seconds.kernel;
}

std::vector<double> StrahlContender::distances() {
  std::vector<double> all;
  all.reserve(hits_.size());
  for (const Hit& hit : hits_) all.push_back(hit.t);
  return all;
}

}  // namespace strahl::bench

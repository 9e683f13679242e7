// SPDX-License-Identifier: MIT
#pragma once

#include "bench/contender.h"

namespace strahl::bench {

/// The kernel's time from launch to finish, by the same code as `strahl intersect`.
class StrahlContender : public Contender {
 public:
  StrahlContender(const Device& device, const Scene& scene, const RenderSettings& settings);

  [[nodiscard]] std::string program() const override { return "strahl"; }
  [[nodiscard]] std::string variant() const override { return variant_; }
  void load(const RaySet& set) override { set_ = &set; }
  double trace() override;
  [[nodiscard]] std::vector<double> distances() override;
  [[nodiscard]] double build_seconds() const override { return intersector_.stats().seconds.bvh; }
  [[nodiscard]] const std::vector<Hit>& hits() const { return hits_; }

 private:
  std::string variant_;
  Intersector intersector_;
  const RaySet* set_ = nullptr;
  std::vector<Hit> hits_;
};

}  // namespace strahl::bench

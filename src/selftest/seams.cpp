// SPDX-License-Identifier: MIT
#include "selftest/seams.h"

#include <cmath>

#include "packing/pack_shapes.h"
#include "selftest/tally.h"

namespace strahl::selftest {

std::vector<ClosedSurface> surfaces_of(const std::string& kind) {
  std::vector<ClosedSurface> surfaces;
  for (auto& [name, surface] : closed_surfaces()) {
    const bool is_mesh = std::holds_alternative<Mesh>(surface.scene.shapes.front().geometry);
    if (kind == (is_mesh ? "triangle" : "parallelogram")) surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

namespace {

/// A device that is asked may answer anything.
bool is_primitive(int answer, std::size_t count) { return answer >= 0 && static_cast<std::size_t>(answer) < count; }

}  // namespace

void ask_seams(Probe& probe, const std::string& kind, const ClosedSurface& surface, std::size_t rays,
               std::uint64_t seed, Seams& seams) {
  Question whole;
  whole.kind = kind;
  primitive_planes(surface.scene.shapes.front().geometry, UploadFrame{}, [&](std::span<const double> planes) {
    for (const double x : planes) whole.planes.push_back(to_float(x));
  });
  // So many questions at a time that all copies of the surface are a few megabytes.
  const std::size_t batch = std::max<std::size_t>(1, (std::size_t{1} << 20) / whole.planes.size());
  const std::size_t planes = static_cast<std::size_t>(planes_of(kind));
  const std::vector<Ray> aimed = rays_at_seams(surface, rays, seed);
  for (std::size_t first = 0; first < aimed.size(); first += batch) {
    std::vector<Question> questions(std::min(batch, aimed.size() - first), whole);
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const Ray& ray = aimed[first + i];
      questions[i].ray = {ray.origin, ray.direction, ray.t_min, ray.t_max};
      questions[i].expected = Expected::hit;
    }
    const std::vector<Answer> answers = probe.ask(questions);
    std::vector<Question> without;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      if (!std::isfinite(answers[i].t) || !is_primitive(answers[i].primitive, whole.planes.size() / planes)) {
        if (seams.wrong() == 0) seams.first_wrong = text_of(questions[i], answers[i]);
        ++seams.leaks;
        continue;
      }
      Question& rest = without.emplace_back(std::move(questions[i]));
      const auto begin = rest.planes.begin() + answers[i].primitive * static_cast<std::ptrdiff_t>(planes);
      rest.planes.erase(begin, begin + static_cast<std::ptrdiff_t>(planes));
      rest.expected = Expected::miss;
    }
    const std::vector<Answer> again = probe.ask(without);
    for (std::size_t i = 0; i < without.size(); ++i) {
      if (std::isinf(again[i].t) && again[i].t > 0) continue;  // A miss; what is no number is none.
      if (seams.wrong() == 0) seams.first_wrong = text_of(without[i], again[i]);
      ++seams.doubles;
    }
    seams.rays += std::min(batch, aimed.size() - first);
  }
}

}  // namespace strahl::selftest

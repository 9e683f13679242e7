// SPDX-License-Identifier: MIT
// Means over the microfacets that a direction sees, by the midpoints of a grid; what is reflected or refracted into
// another microfacet is lost, as in Mitsuba. The polynomial goes through the means at Chebyshev's nodes; where light is
// reflected totally from a critical angle on, which no polynomial of the cosine follows, it is near the means in the
// variable that suits them best.
#include "kinds/rough_boundary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <tuple>

#include "kinds/polynomial_fit.h"

namespace strahl::kinds {
namespace {

/// Steps of the slope's size and of its direction.
constexpr int steps = 64;

double fresnel(double c, double eta) {
  const double t2 = 1 - (1 - c) * (1 + c) / (eta * eta);
  if (t2 <= 0) return 1;
  const double t = std::sqrt(t2), s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
  return (s * s + p * p) / 2;
}

/// The share of microfacets that a direction of that cosine sees, as the kernels' values have it.
double masking(MicrofacetKind kind, double alpha, double cosine) {
  const double c = std::fabs(cosine), across = alpha * std::sqrt(std::max(0.0, (1 - c) * (1 + c)));
  if (kind == MicrofacetKind::ggx) return 2 * c / (c + std::hypot(c, across));
  if (c >= 1.6 * across) return 1;
  const double a = c / across;
  return (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
}

/// The cosines between a microfacet's normal and a direction, and between it and the surface's; how much of the surface
/// that the direction sees is like it.
struct Facet {
  double cosine, upright, weight;
};

/// Of a grid, by its place (u, phi); the direction has that cosine. GGX: J. Dupuy, A. Benyoub, "Sampling Visible GGX
/// Normals with Spherical Caps", HPG 2023. Beckmann: by slopes.
Facet facet_at(MicrofacetKind kind, double alpha, double cosine, double u, double phi) {
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  if (kind == MicrofacetKind::ggx) {
    const double size = std::hypot(alpha * sine, cosine), x = alpha * sine / size, z = cosine / size;
    // The share of facets that are steeper. Of a smooth surface those that reflect totally are few, and need many
    // steps.
    const double steeper = u * u * u;
    const double below = (1 - steeper) * (1 + z), around = std::sqrt(std::max(below * (2 - below), 0.0));
    const double mx = alpha * (around * std::cos(phi) + x), my = alpha * around * std::sin(phi);
    const double mz = steeper * (1 + z), length = std::hypot(mx, my, mz);
    return {(sine * mx + cosine * mz) / length, mz / length, 3 * u * u};
  }
  const double r = 4.5 * u, length = std::hypot(alpha * r, 1), c = (sine * alpha * r * std::cos(phi) + cosine) / length;
  return {c, 1 / length, std::max(c, 0.0) * length * r * std::exp(-r * r)};
}

/// The mean of what goes through (or is reflected) of light that comes at that cosine.
double mean_share(MicrofacetKind kind, double alpha, double eta, double cosine, bool is_through) {
  double sum = 0, weights = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      // Half of the directions around: the other half is alike.
      const Facet m = facet_at(kind, alpha, cosine, (i + 0.5) / steps, std::numbers::pi * (j + 0.5) / steps);
      weights += m.weight;
      if (m.cosine <= 0) continue;
      const double c = std::min(m.cosine, 1.0), reflected = fresnel(c, eta);
      const double depth = std::sqrt(std::max(0.0, 1 - (1 - c) * (1 + c) / (eta * eta)));
      const double z = is_through ? (c / eta - depth) * m.upright - cosine / eta : 2 * c * m.upright - cosine;
      if (is_through ? z >= 0 : z <= 0) continue;
      sum += m.weight * (is_through ? 1 - reflected : reflected) * masking(kind, alpha, z);
    }
  return weights > 0 ? sum / weights : 0;
}

/// Coefficients of the polynomial through n values at Chebyshev's nodes of [-1, 1], the highest power first.
template <std::size_t n>
std::array<double, n> through_nodes(const std::array<double, n>& values) {
  std::array<double, n> powers{}, last{}, current{};
  last[0] = 1;
  current[1] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += values[i] * std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / n);
    const double coefficient = (k == 0 ? 1.0 : 2.0) * sum / n;
    const std::array<double, n>& chebyshev = k == 0 ? last : current;
    for (std::size_t i = 0; i < n; ++i) powers[n - 1 - i] += coefficient * chebyshev[i];
    if (k == 0) continue;
    std::array<double, n> next{};
    for (std::size_t i = 0; i < n; ++i) next[i] = (i > 0 ? 2 * current[i - 1] : 0) - last[i];
    last = current;
    current = next;
  }
  return powers;
}

double variable(const RoughBoundary& boundary, double eta, double cosine) {
  double y = cosine;
  if (boundary.soft > 0) {
    const double q = 1 - (1 - cosine) * (1 + cosine) / (eta * eta);
    const double larger = std::sqrt((std::fabs(q) + std::hypot(q, boundary.soft)) / 2);
    y = q < 0 ? boundary.soft / (2 * larger) : larger;
  }
  return ((1 + 2 * boundary.spread) * y - boundary.spread) / (y + boundary.spread);
}

/// Evenly spread cosines, and more and more of them towards the critical angle.
std::vector<double> cosines_about(double critical) {
  constexpr int even = 64, near = 32;
  std::vector<double> cosines;
  for (int i = 0; i <= even; ++i) cosines.push_back(std::max(static_cast<double>(i) / even, 1e-4));
  for (int i = 0; i < near; ++i) {
    const double step = std::pow((i + 0.5) / near, 3);
    cosines.push_back(critical * (1 - step));
    cosines.push_back(critical + (1 - critical) * step);
  }
  return cosines;
}

void fit_thinner(MicrofacetKind kind, double alpha, double eta, RoughBoundary& boundary) {
  const std::vector<double> cosines = cosines_about(std::sqrt((1 - eta) * (1 + eta)));
  std::vector<double> values, importance, x(cosines.size());
  for (const double cosine : cosines) {
    values.push_back(mean_share(kind, alpha, eta, cosine, true));
    // Little light is shallow. Of nearly equal indices the critical angle is, which must not spoil the rest.
    importance.push_back(std::clamp(cosine / 0.1, 0.1, 1.0));
  }
  PolynomialFit best;
  for (const double soft : {0.0, 1e-4, 1e-3, 3e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 3.0})
    for (const double spread : {0.05, 0.1, 0.2, 0.5}) {
      const RoughBoundary tried{{}, spread, soft, 0};
      std::transform(cosines.begin(), cosines.end(), x.begin(),
                     [&](double cosine) { return variable(tried, eta, cosine); });
      const PolynomialFit fit = polynomial_near(x, values, importance);
      if (!(fit.most_off < best.most_off)) continue;
      best = fit;
      boundary.through = fit.terms;
      boundary.spread = spread;
      boundary.soft = soft;
    }
}

void fit_denser(MicrofacetKind kind, double alpha, double eta, RoughBoundary& boundary) {
  std::array<double, 9> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(values.size()));
    values[i] = mean_share(kind, alpha, eta, 0.5 * (1 + x) / (2 - x), true);  // x = (2 c - 0.5) / (c + 0.5)
  }
  boundary.through = through_nodes(values);
}

RoughBoundary computed(MicrofacetKind kind, double alpha, double eta) {
  RoughBoundary boundary;
  if (eta < 1)
    fit_thinner(kind, alpha, eta, boundary);
  else
    fit_denser(kind, alpha, eta, boundary);
  // Mitsuba's sum over 64 cosines, ends included.
  constexpr int cosines = 64;
  for (int i = 0; i < cosines; ++i) {
    const double cosine = std::max(1e-6, i / (cosines - 1.0));
    boundary.inner += 2.0 / cosines * cosine * mean_share(kind, alpha, 1 / eta, cosine, false);
  }
  // The cosines' weights add up to 1 + 3e-8, which of a very dense inside is more than all.
  boundary.inner = std::min(boundary.inner, largest_inner_reflectance);
  return boundary;
}

}  // namespace

double share_through(const RoughBoundary& boundary, double eta, double cosine) {
  return share_of_polynomial(boundary.through, variable(boundary, eta, cosine));
}

RoughBoundary rough_boundary(MicrofacetKind kind, double alpha, double eta) {
  static std::mutex lock;
  static std::map<std::tuple<MicrofacetKind, double, double>, RoughBoundary> known;
  const std::lock_guard guard(lock);
  const auto [found, is_new] = known.try_emplace({kind, alpha, eta});
  if (is_new) found->second = computed(kind, std::max(alpha, 1e-4), eta);
  return found->second;
}

double smooth_inner_reflectance(double eta) {
  constexpr double largest_eta_of_fit = 3;
  // W. Egan, T. Hilgeman, "Spectral Reflectance of Particulate Materials", Applied Optics 12(8), 1973; E. d'Eon,
  // G. Irving, "A Quantized-Diffusion Model for Rendering Translucent Materials", SIGGRAPH 2011.
  const auto fit = [](double from_within) {
    return 0.0636 / from_within + from_within * (from_within * -1.4399 + 0.7099) + 0.6681;
  };
  const double from_within = 1 / eta;
  // The fit is above 1 from 3.85 on. What is let out is in proportion to 1 / eta^2, but for what of diffuse light from
  // outside is let in, which varies slowly.
  if (eta > largest_eta_of_fit) {
    const double share = largest_eta_of_fit / eta;
    return std::min(1 - (1 - fit(1 / largest_eta_of_fit)) * share * share, largest_inner_reflectance);
  }
  if (from_within < 1) return fit(from_within);
  return ((((-1.36881 * eta + 4.98554) * eta - 7.80989) * eta + 6.75335) * eta - 3.4793) * eta + 0.919317;
}

}  // namespace strahl::kinds

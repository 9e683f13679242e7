// SPDX-License-Identifier: MIT
// How far picture A is from reference B: linear RGB, all pixels and channels, unclamped unless stated.
#pragma once

#include <string>
#include <vector>

#include "image/flip.h"
#include "image/image.h"

namespace strahl {

/// mse = mean((a-b)^2) · rmse = sqrt(mse) · mae = mean|a-b| · relmse = mean((a-b)^2 / (b^2 + 1e-2)) ·
/// psnr = 10 log10(1 / mse) on sRGB-encoded values clamped to [0, 1], in dB (inf where equal) ·
/// ssim = mean over channels of the structural similarity of such values, 1 where equal (ssim.h) ·
/// flip = mean LDR-FLIP of values clamped to [0, 1] (flip.h) · hdrflip = mean HDR-FLIP of values from 0 on
/// (hdr_flip.h).
enum class Metric { mse, rmse, mae, relmse, psnr, ssim, flip, hdrflip };

[[nodiscard]] Metric metric_from_name(const std::string& name);  ///< Throws UsageError that lists the names.
[[nodiscard]] const char* metric_name(Metric metric);
[[nodiscard]] const std::vector<Metric>& all_metrics();
[[nodiscard]] bool more_is_better(Metric metric);  ///< psnr and ssim.
void require_map(Metric metric);            ///< Of metric_map and metric_heatmap; a UsageError lists who has one.
[[nodiscard]] bool is_seen(Metric metric);  ///< Whether it depends on pixels per degree: flip and hdrflip.

/// Why no picture like this one can be measured so, as one sentence; empty where it can be. ssim needs 11 x 11 pixels;
/// flip and hdrflip need R, G and B, or one channel of grey.
[[nodiscard]] std::string metric_obstacle(const Image& image, Metric metric);

/// Throws InputError where sizes or colour channels differ, there are none, either holds NaN, infinities (says where)
/// or another number of values than it has pixels and channels, or the metric has an obstacle; UsageError for pixels
/// per degree outside of 1 ... 1000.
[[nodiscard]] double compare_images(const Image& a, const Image& reference, Metric metric,
                                    double pixels_per_degree = default_pixels_per_degree);

/// A term of relmse.
[[nodiscard]] double relative_square(double a, double reference);

/// Each pixel's mae, relmse, ssim (means over channels), flip or hdrflip. Throws as compare_images does, and UsageError
/// for the other metrics.
[[nodiscard]] Channel metric_map(const Image& a, const Image& reference, Metric metric,
                                 double pixels_per_degree = default_pixels_per_degree);

/// The map in false colours: mae in inferno, scaled to the largest difference; the root of relmse in inferno, from
/// 10^-3 to 1 on a logarithmic scale; 1 - ssim in inferno and flip in magma, both from 0 to 1. The metadata says which,
/// and the largest difference.
[[nodiscard]] Image metric_heatmap(const Image& a, const Image& reference, Metric metric,
                                   double pixels_per_degree = default_pixels_per_degree);

/// The heat map of mae: per-pixel mean |a - b| over channels.
[[nodiscard]] Image difference_heatmap(const Image& a, const Image& reference);

}  // namespace strahl

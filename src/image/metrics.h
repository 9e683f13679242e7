// SPDX-License-Identifier: MIT
// How far picture A is from reference B: linear RGB, all pixels and channels, unclamped unless stated.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace strahl {

/// mse = mean((a-b)^2) · rmse = sqrt(mse) · mae = mean|a-b| · relmse = mean((a-b)^2 / (b^2 + 1e-2)) ·
/// psnr = 10 log10(1 / mse) on sRGB-encoded values clamped to [0, 1], in dB (inf where equal).
enum class Metric { mse, rmse, mae, relmse, psnr };

[[nodiscard]] Metric metric_from_name(const std::string& name);  ///< Throws UsageError that lists the names.
[[nodiscard]] const char* metric_name(Metric metric);
[[nodiscard]] const std::vector<Metric>& all_metrics();

/// Throws InputError where sizes or colour channels differ, or either holds NaN or infinities (says where).
[[nodiscard]] double compare_images(const Image& a, const Image& reference, Metric metric);

/// Per-pixel mean |a - b| over channels as a false-colour RGB picture (perceptually ordered map, scaled to the
/// largest difference, which goes into the metadata).
[[nodiscard]] Image difference_heatmap(const Image& a, const Image& reference);

}  // namespace strahl

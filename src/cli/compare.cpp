// SPDX-License-Identifier: MIT
// `strahl compare`: how far picture A is from reference B.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/picture_files.h"
#include "image/metrics.h"

namespace strahl::cli {
namespace {

constexpr const char* kFooter = R"(
B is the reference. mse, rmse, mae and relmse compare linear values, psnr (dB, inf: equal) sRGB values from 0 to 1.

Examples:
  strahl compare out.exr reference.exr
  strahl compare out.png reference.png --metric rmse --fail-above 0.01
  strahl compare out.exr reference.exr --heatmap difference.png

Exit code 7 where --fail-above fails; for psnr, where more is better, that is a value below the bound.)";

struct CompareOptions {
  std::string a, b;
  std::vector<std::string> metrics;
  std::string heatmap;
  std::optional<double> bound;
  bool json = false;
};

/// Worse than the bound; a value that is not a number always is.
bool fails(Metric metric, double value, double bound) {
  return metric == Metric::psnr ? !(value >= bound) : !(value <= bound);
}

ExitCode compare(const CompareOptions& options) {
  std::vector<Metric> metrics;
  for (const std::string& name : options.metrics) metrics.push_back(metric_from_name(name));
  if (options.bound && metrics.size() != 1)
    throw UsageError("--fail-above needs exactly one --metric to hold its value against");
  if (metrics.empty()) metrics = all_metrics();
  const PictureFiles heatmap{options.heatmap, {}, false};
  if (!options.heatmap.empty()) require_writable(heatmap);

  const Image a = read_image(options.a);
  const Image b = read_image(options.b);
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text;
  bool failed = false;
  for (const Metric metric : metrics) {
    const double value = compare_images(a, b, metric);
    json[metric_name(metric)] = std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
    text += fmt::format("{:<6} {}\n", metric_name(metric), value);
    failed = failed || (options.bound && fails(metric, value, *options.bound));
  }
  if (!options.heatmap.empty()) static_cast<void>(write_image(difference_heatmap(a, b), options.heatmap));
  print(options.json ? json.dump(2) + "\n" : text);
  return failed ? ExitCode::check_failed : ExitCode::ok;
}

}  // namespace

Command add_compare(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  app.add_option("A", options->a, "Picture: .png, .exr or .pfm")->required()->type_name("FILE");
  app.add_option("B", options->b, "The reference")->required()->type_name("FILE");
  app.add_option("--metric", options->metrics, "mse, rmse, mae, relmse or psnr; repeatable; default: all")
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--heatmap", options->heatmap, "Write |A - B| of each pixel in false colours")->type_name("FILE");
  app.add_option("--fail-above", options->bound, "Exit with 7 where the metric is worse than X")->type_name("X");
  app.add_flag("--json", options->json, "For programs");
  app.footer(kFooter);
  return [options] { return compare(*options); };
}

}  // namespace strahl::cli

// SPDX-License-Identifier: MIT
// `strahl compare`: how far picture A is from reference B.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/distinct_files.h"
#include "cli/number_options.h"
#include "cli/picture_files.h"
#include "image/metrics.h"
#include "json_text.h"

namespace strahl::cli {
namespace {

constexpr const char* compare_footer = R"(
B is the reference. mse, rmse, mae and relmse compare linear values; psnr (dB, inf: equal) and ssim (1: equal) sRGB
values from 0 to 1; flip is the error that an eye sees at --ppd when it flips between the pictures, from 0 to 1, of
values up to 1; hdrflip is the same over all exposures that suit the reference.

Examples:
  strahl compare out.exr reference.exr
  strahl compare out.png reference.png --metric rmse --fail-above 0.01
  strahl compare out.exr reference.exr --heatmap difference.png
  strahl compare out.exr reference.exr --heatmap seen.png --heatmap-of flip

Exit code 7 where --fail-above fails; for psnr and ssim, where more is better, that is a value below the bound.)";

struct CompareOptions {
  std::string a, b;
  std::vector<std::string> metrics;
  std::string heatmap, heatmap_of;
  std::optional<double> bound, pixels_per_degree;
  bool json = false;
};

/// Worse than the bound; a value that is not a number always is.
bool fails(Metric metric, double value, double bound) {
  return more_is_better(metric) ? !(value >= bound) : !(value <= bound);
}

/// What the command line asks for.
struct Request {
  std::vector<Metric> metrics;
  Metric map = Metric::mae;
  double pixels_per_degree = default_pixels_per_degree;
};

Request requested(const CompareOptions& options) {
  Request request;
  for (const std::string& name : options.metrics) request.metrics.push_back(metric_from_name(name));
  if (options.bound && request.metrics.size() != 1)
    throw UsageError("--fail-above needs exactly one --metric to hold its value against");
  if (request.metrics.empty()) request.metrics = all_metrics();
  if (!options.heatmap_of.empty()) request.map = metric_from_name(options.heatmap_of);
  require_map(request.map);
  if (options.pixels_per_degree) {
    if (!is_seen(request.map) && std::none_of(request.metrics.begin(), request.metrics.end(), is_seen))
      throw UsageError("--ppd is for flip and hdrflip alone");
    request.pixels_per_degree = *options.pixels_per_degree;
  }
  return request;
}

ExitCode compare(const CompareOptions& options) {
  const Request request = requested(options);
  require_distinct({{"--heatmap", options.heatmap}}, {{"picture A", options.a}, {"the reference B", options.b}});
  if (!options.heatmap.empty()) require_writable(PictureFiles{options.heatmap, {}, false});

  const Image a = read_image(options.a);
  const Image b = read_image(options.b);
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text;
  bool failed = false;
  for (const Metric metric : request.metrics) {
    const char* name = metric_name(metric);
    const std::string obstacle = metric_obstacle(a, metric);
    if (options.metrics.empty() && !obstacle.empty()) {
      json[name] = nullptr;
      text += fmt::format("{:<7} not measured: {}\n", name, obstacle);
      continue;
    }
    const double value = compare_images(a, b, metric, request.pixels_per_degree);
    json[name] = std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
    text += fmt::format("{:<7} {}\n", name, value);
    failed = failed || (options.bound && fails(metric, value, *options.bound));
  }
  if (!options.heatmap.empty()) {
    static_cast<void>(write_image(metric_heatmap(a, b, request.map, request.pixels_per_degree), options.heatmap));
  }
  print(options.json ? json_text(json) : text);
  return failed ? ExitCode::check_failed : ExitCode::ok;
}

}  // namespace

Command add_compare(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  app.add_option("A", options->a, "Picture: .png, .exr or .pfm")->required()->type_name("FILE");
  app.add_option("B", options->b, "The reference")->required()->type_name("FILE");
  app.add_option("--metric", options->metrics,
                 "mse, rmse, mae, relmse, psnr, ssim, flip or hdrflip; repeatable; default: all")
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
  CLI::Option* heatmap =
      app.add_option("--heatmap", options->heatmap, "Write |A - B| of each pixel in false colours")->type_name("FILE");
  app.add_option("--heatmap-of", options->heatmap_of, "What instead: relmse, ssim, flip or hdrflip")
      ->type_name("NAME")
      ->needs(heatmap);
  require_between(
      app.add_option(
          "--ppd", options->pixels_per_degree,
          "Pixels per degree of sight, for flip and hdrflip; default: 67.02, 0.7 m before a display that is 0.7 m "
          "and 3840 pixels wide"),
      1, 1000)
      ->type_name("X");
  require_finite(app.add_option("--fail-above", options->bound, "Exit with 7 where the metric is worse than X"))
      ->type_name("X");
  app.add_flag("--json", options->json, "For programs");
  app.footer(compare_footer);
  return [options] { return compare(*options); };
}

}  // namespace strahl::cli

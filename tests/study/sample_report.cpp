// SPDX-License-Identifier: MIT
// Writes the report of a study that nobody made, for report_browser.py: times and errors that follow the laws of
// Monte Carlo, pictures of a ball with noise to match. sample_report FILE.html
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "image/file_bytes.h"
#include "image/image_io.h"
#include "study/report/html_report.h"

namespace {

using nlohmann::json;

constexpr int width = 96, height = 72;

/// Uniform in [-1, 1): the last bits of a multiplicative hash.
double noise(std::uint32_t seed, std::uint32_t index) {
  std::uint32_t x = seed * 747796405U + index * 2891336453U + 1U;
  for (int round = 0; round < 3; ++round) x = (x ^ x >> 16) * 0x45d9f3bU;
  return x / 2147483648.0 - 1;
}

double ball(int x, int y) {
  const double u = (x - 0.45 * width) / (0.36 * height), v = (y - 0.55 * height) / (0.36 * height),
               inside = 1 - u * u - v * v;
  if (inside > 0) return 0.04 + 0.8 * std::max(0.0, 0.5 * std::sqrt(inside) - 0.6 * v - 0.4 * u);
  return 0.25 + 0.2 * v * v * (v > 0 ? 0.3 : 0.1);
}

std::string png(const std::filesystem::path& folder, double spread, double bias, bool is_difference,
                std::uint32_t seed) {
  strahl::Image image;
  image.width = width;
  image.height = height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const auto index = static_cast<std::uint32_t>((y * width + x) * 3 + c);
        const double error = spread * 1.7 * noise(seed, index) - bias;
        const double tint = c == 0 ? 1 : c == 1 ? 0.85 : 0.7;
        const double value = is_difference ? 4 * std::fabs(error) * tint : ball(x, y) * tint + error;
        image.data.push_back(static_cast<float>(std::max(0.0, value)));
      }
    }
  }
  const std::string path = (folder / "sample_report.png").string();
  strahl::write_image(image, path);
  std::string bytes = strahl::read_file(path);
  std::filesystem::remove(path);
  return bytes;
}

struct Tier {
  const char* name;
  double cost, floor;
};

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: sample_report FILE.html\n", stderr);
    return 2;
  }
  const std::filesystem::path page = arguments[1];
  const std::filesystem::path folder = page.parent_path();
  std::map<std::string, std::string> pictures{{"reference.png", png(folder, 0, 0, false, 0)}};
  json points = json::array(), fits = json::array();
  std::uint32_t seed = 0;
  for (const Tier& tier : {Tier{"fast", 0.78, 6e-4}, {"stable", 0.9, 0}, {"robust", 1, 0}, {"double", 1.9, 0}}) {
    for (const std::string sampler : {"independent", "sobol"}) {
      for (const int depth : {2, 8}) {
        for (const bool generic : {false, true}) {
          if (generic && (std::string(tier.name) != "robust" || sampler != "sobol" || depth != 8)) continue;
          const double slope = (sampler == "sobol" ? -0.68 : -0.5) * (depth == 2 ? 0.4 : 1);
          for (const int spp : {1, 4, 16, 64, 256}) {
            ++seed;
            const double kernel = 0.004 + 0.0061 * spp * tier.cost * (depth == 2 ? 0.45 : 1) * (generic ? 1.28 : 1) *
                                              (1 + 0.02 * noise(7, seed));
            const double bias = (depth == 2 ? 0.021 : 0) + tier.floor;
            const double spread = 0.19 * std::pow(spp, sampler == "sobol" ? -0.64 : -0.5) * (1 + 0.03 * noise(9, seed));
            const double bias2 = bias * bias + 0.02 * spread * spread * noise(11, seed);
            const double mse = std::max(0.0, bias2) + spread * spread, rmse = std::sqrt(mse);
            const std::string id = std::string(tier.name) + "-" + sampler + "-d" + std::to_string(depth) + "-" +
                                   std::to_string(spp) + "spp-" + (generic ? "generic" : "specialised");
            points.push_back({{"id", id},
                              {"precision", tier.name},
                              {"sampler", sampler},
                              {"max_depth", depth},
                              {"spp", spp},
                              {"generic", generic},
                              {"seeds", 3},
                              {"seconds",
                               {{"program", generic ? 0.42 : 0.31},
                                {"bvh", 0.0004},
                                {"upload", 0.0011},
                                {"kernel", kernel},
                                {"wall", kernel + 0.34 + (generic ? 0.11 : 0)}}},
                              {"mse", mse},
                              {"bias2", bias2},
                              {"variance", spread * spread},
                              {"rmse", rmse},
                              {"rmse_low", rmse * 0.94},
                              {"rmse_high", rmse * 1.07},
                              {"relmse", mse * 7.1},
                              {"psnr", -10 * std::log10(mse)},
                              {"ssim", 1 / (1 + 60 * mse)},
                              {"flip", 0.9 * rmse / (rmse + 0.12)},
                              {"pareto", false},
                              {"picture", "points/" + id + ".png"},
                              {"difference", "points/" + id + ".difference.png"}});
            pictures["points/" + id + ".png"] = png(folder, spread, bias, false, seed);
            pictures["points/" + id + ".difference.png"] = png(folder, spread, bias, true, seed);
          }
          fits.push_back({{"precision", tier.name},
                          {"sampler", sampler},
                          {"max_depth", depth},
                          {"generic", generic},
                          {"slope", slope},
                          {"slope_low", slope - 0.03},
                          {"slope_high", slope + 0.03},
                          {"factor", depth == 2           ? 0.03
                                     : sampler == "sobol" ? 0.007
                                                          : 0.015},
                          {"points", 5},
                          {"samples_slope", slope},
                          {"samples_slope_high", slope + 0.02}});
        }
      }
    }
  }
  for (json& point : points) {
    point["pareto"] = std::none_of(points.begin(), points.end(), [&](const json& other) {
      return other["seconds"]["kernel"] < point["seconds"]["kernel"] && other["rmse"] <= point["rmse"];
    });
  }
  const json study{{"strahl", STRAHL_VERSION},
                   {"scene", "scenes/sample/ball <of> \"paper\" & light.xml"},
                   {"name", "A ball that nobody rendered"},
                   {"device", "an imaginary device"},
                   {"command", "strahl tradeoff scenes/sample/ball.xml -o ball"},
                   {"width", width},
                   {"height", height},
                   {"reference",
                    {{"precision", "double"},
                     {"sampler", "sobol"},
                     {"spp", 4096},
                     {"max_depth", -1},
                     {"seconds", 41.2},
                     {"rmse", 0.0012},
                     {"rmse_low", 0.0011},
                     {"rmse_high", 0.0013},
                     {"picture", "reference.png"}}},
                   {"points", points},
                   {"fits", fits}};
  std::ofstream file(page, std::ios::binary);
  file << strahl::html_report(study.dump(), pictures);
  file.close();
  if (!file) {
    std::fprintf(stderr, "cannot write %s\n", page.c_str());
    return 1;
  }
  return 0;
}

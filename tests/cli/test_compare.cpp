// SPDX-License-Identifier: MIT
// `strahl compare` on pictures whose differences are known.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

/// Every channel `value`.
std::string picture(const Folder& folder, const std::string& name, float value, int width = 4, int height = 2) {
  strahl::Image image;
  image.width = width;
  image.height = height;
  image.data.assign(image.index(0, height, 0), value);
  strahl::write_image(image, folder.path(name));
  return name;
}

std::string large(const Folder& folder, const std::string& name, float value) {
  return picture(folder, name, value, 16, 16);
}

}  // namespace

TEST_CASE("all metrics are printed, and as JSON") {
  const Folder folder;
  const std::string a = picture(folder, "a.exr", 0.75F);
  const std::string b = picture(folder, "b.pfm", 0.25F);
  const Outcome json = folder.run({"compare", a, b, "--json"});
  REQUIRE(json.code == 0);
  const Json values = Json::parse(json.out);
  CHECK(values.size() == 8);
  CHECK(values.at("mse").get<double>() == Approx(0.25));
  CHECK(values.at("rmse").get<double>() == Approx(0.5));
  CHECK(values.at("mae").get<double>() == Approx(0.5));
  CHECK(values.at("relmse").get<double>() == Approx(0.25 / (0.0625 + 0.01)));
  CHECK(values.at("psnr").get<double>() > 0);
  CHECK(values.at("ssim").is_null());  // 4 x 2 pixels are too few.
  CHECK(values.at("flip").get<double>() > 0);
  CHECK(values.at("hdrflip").get<double>() > 0);
  CHECK(contains(folder.run({"compare", a, b}).out, "ssim    not measured: ssim's window needs 11 x 11 pixels"));

  const Outcome text = folder.run({"compare", a, b, "--metric", "rmse", "--metric", "mae"});
  CHECK(text.out == "rmse    0.5\nmae     0.5\n");
}

TEST_CASE("equal pictures: psnr is inf, null in JSON") {
  const Folder folder;
  const std::string a = picture(folder, "a.exr", 0.5F);
  CHECK(Json::parse(folder.run({"compare", a, a, "--json"}).out).at("psnr").is_null());
  CHECK(contains(folder.run({"compare", a, a}).out, "psnr    inf"));
}

TEST_CASE("--fail-above decides the exit code") {
  const Folder folder;
  const std::string a = picture(folder, "a.exr", 0.75F);
  const std::string b = picture(folder, "b.exr", 0.25F);
  const auto code = [&](const std::string& metric, const std::string& bound) {
    return folder.run({"compare", a, b, "--metric", metric, "--fail-above", bound}).code;
  };
  CHECK(code("rmse", "0.5") == 0);
  CHECK(code("rmse", "0.49") == 7);
  CHECK(code("psnr", "1") == 0);  // More is better: worse is below.
  CHECK(code("psnr", "60") == 7);
  CHECK(code("mse", "-1") == 7);
  CHECK(code("mse", "nan") != 0);
  CHECK(folder.run({"compare", a, b, "--fail-above", "1"}).code == 2);
  CHECK(folder.run({"compare", a, b, "--fail-above", "1", "--metric", "mse,mae"}).code == 2);
  CHECK(folder.run({"compare", a, b, "--metric", "lpips"}).code == 2);
  CHECK(folder.run({"compare", a, b, "--metric", "ssim"}).code == 3);  // Too small for it, and asked for by name.

  const std::string dark = large(folder, "dark.exr", 0.1F);
  const std::string light = large(folder, "light.exr", 0.9F);
  const auto of_large = [&](const std::string& metric, const std::string& bound) {
    return folder.run({"compare", dark, light, "--metric", metric, "--fail-above", bound}).code;
  };
  CHECK(of_large("ssim", "0.1") == 0);  // More is better here, too.
  CHECK(of_large("ssim", "0.99") == 7);
  CHECK(of_large("flip", "0.99") == 0);
  CHECK(of_large("flip", "0.1") == 7);
}

TEST_CASE("pictures that cannot be compared are unusable input") {
  const Folder folder;
  const std::string a = picture(folder, "a.exr", 0.75F);
  const std::string nan = picture(folder, "nan.exr", std::numeric_limits<float>::quiet_NaN());
  CHECK(folder.run({"compare", a, nan, "--metric", "mse", "--fail-above", "1"}).code == 3);
  CHECK(folder.run({"compare", a, "missing.exr"}).code == 3);
  strahl::Image opacity{4, 2, {"A"}, std::vector<float>(8, 0.5F), {}};
  strahl::write_image(opacity, folder.path("opacity.exr"));
  const Outcome without_colours = folder.run({"compare", "opacity.exr", "opacity.exr"});
  CHECK(without_colours.code == 3);
  CHECK(contains(without_colours.err, "no colour channels to compare: A"));
  CHECK(folder.run({"compare", a, folder.file("text.png", "no picture")}).code == 3);
}

TEST_CASE("the heatmap is a picture of the same size, checked for first") {
  const Folder folder;
  const std::string a = picture(folder, "a.exr", 0.75F);
  const std::string b = picture(folder, "b.exr", 0.25F);
  REQUIRE(folder.run({"compare", a, b, "--heatmap", "heat.png"}).code == 0);
  const strahl::Image heat = strahl::read_image(folder.path("heat.png"));
  CHECK(heat.width == 4);
  CHECK(heat.height == 2);
  CHECK(folder.run({"compare", "missing.exr", b, "--heatmap", "missing/heat.png"}).code == 1);
  CHECK(folder.run({"compare", a, b, "--heatmap", "heat.txt"}).code == 2);
}

TEST_CASE("the heatmap may be of a metric that has a value a pixel") {
  const Folder folder;
  const std::string a = large(folder, "a.exr", 0.75F);
  const std::string b = large(folder, "b.exr", 0.25F);
  for (const char* metric : {"mae", "relmse", "ssim", "flip", "hdrflip"}) {
    REQUIRE(folder.run({"compare", a, b, "--heatmap", "heat.png", "--heatmap-of", metric}).code == 0);
    CHECK(strahl::read_image(folder.path("heat.png")).metadata.at("metric") == metric);
  }
  CHECK(folder.run({"compare", a, b, "--heatmap-of", "flip"}).code == 2);
  CHECK(folder.run({"compare", a, b, "--heatmap", "no.png", "--heatmap-of", "psnr"}).code == 2);
  CHECK(folder
            .run({"compare", picture(folder, "small.exr", 1), picture(folder, "small.pfm", 1), "--heatmap", "no.png",
                  "--heatmap-of", "ssim"})
            .code == 3);
  const std::vector<std::string> files = folder.files();
  CHECK(std::count(files.begin(), files.end(), "no.png") == 0);
}

TEST_CASE("--ppd says how near the eye is") {
  const Folder folder;
  const std::string a = large(folder, "a.exr", 0.75F);
  strahl::Image dot = strahl::read_image(folder.path(a));
  dot.at(8, 8, 1) = 0.25F;
  strahl::write_image(dot, folder.path("dot.exr"));
  const auto seen = [&](const std::string& ppd) {
    const Outcome outcome = folder.run({"compare", "dot.exr", a, "--metric", "flip", "--ppd", ppd, "--json"});
    return Json::parse(outcome.out).at("flip").get<double>();
  };
  CHECK(seen("30") < seen("120"));  // More pixels get a share of what the eye blurs.
  CHECK(folder.run({"compare", a, a, "--metric", "flip", "--ppd", "0"}).code == 2);
  for (const char* most : {"1", "1000"})
    CHECK(folder.run({"compare", a, a, "--metric", "flip", "--ppd", most}).code == 0);
  CHECK(folder.run({"compare", a, a, "--metric", "mse", "--ppd", "67"}).code == 2);
}

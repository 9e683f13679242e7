// SPDX-License-Identifier: MIT
// `strahl compare` on pictures whose differences are known.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

/// 4 x 2 pixels, every channel `value`.
std::string picture(const Folder& folder, const std::string& name, float value) {
  strahl::Image image;
  image.width = 4;
  image.height = 2;
  image.data.assign(24, value);
  strahl::write_image(image, folder.path(name));
  return name;
}

}  // namespace

TEST_CASE("all metrics are printed, and as JSON") {
  const Folder folder;
  const std::string a = picture(folder, "a.exr", 0.75F);
  const std::string b = picture(folder, "b.pfm", 0.25F);
  const Outcome json = folder.run({"compare", a, b, "--json"});
  REQUIRE(json.code == 0);
  const Json values = Json::parse(json.out);
  CHECK(values.size() == 5);
  CHECK(values.at("mse").get<double>() == Approx(0.25));
  CHECK(values.at("rmse").get<double>() == Approx(0.5));
  CHECK(values.at("mae").get<double>() == Approx(0.5));
  CHECK(values.at("relmse").get<double>() == Approx(0.25 / (0.0625 + 0.01)));
  CHECK(values.at("psnr").get<double>() > 0);

  const Outcome text = folder.run({"compare", a, b, "--metric", "rmse", "--metric", "mae"});
  CHECK(text.out == "rmse   0.5\nmae    0.5\n");
}

TEST_CASE("equal pictures: psnr is inf, null in JSON") {
  const Folder folder;
  const std::string a = picture(folder, "a.exr", 0.5F);
  CHECK(Json::parse(folder.run({"compare", a, a, "--json"}).out).at("psnr").is_null());
  CHECK(contains(folder.run({"compare", a, a}).out, "psnr   inf"));
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
  CHECK(folder.run({"compare", a, b, "--metric", "ssim"}).code == 2);
}

TEST_CASE("pictures that cannot be compared are unusable input") {
  const Folder folder;
  const std::string a = picture(folder, "a.exr", 0.75F);
  const std::string nan = picture(folder, "nan.exr", std::numeric_limits<float>::quiet_NaN());
  CHECK(folder.run({"compare", a, nan, "--metric", "mse", "--fail-above", "1"}).code == 3);
  CHECK(folder.run({"compare", a, "missing.exr"}).code == 3);
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

// SPDX-License-Identifier: MIT
// `strahl stress` on a device: the sheet, the table, the JSON. 3 s.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image/image_io.h"

using namespace strahl_test;

TEST_CASE("a sheet, a table and JSON") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const Outcome outcome = folder.run({"stress", "scene.xml", "--width", "24", "--spp", "1", "--json", "out.json"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(folder.files() == std::vector<std::string>{"out.json", "scene.stress.png", "scene.xml"});
  CHECK(contains(outcome.out, "RMSE against double"));
  CHECK(contains(outcome.out, "offset 1e+07"));
  CHECK(contains(outcome.err, "scene.stress.png"));
  const auto json = nlohmann::json::parse(read_text(folder.path("out.json")));
  CHECK(json["stresses"].size() == 12);
  REQUIRE(json["tiers"].size() == 4);
  CHECK(json["tiers"][2]["precision"] == "robust");
  CHECK(json["tiers"][3]["rmse"][2] == 0.0);
  CHECK(strahl::read_image(folder.path("scene.stress.png")).width > 8 * 24);
}

TEST_CASE("JSON in the table's place, of any name; a sheet that cannot be written costs no time") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const std::string room = "r\xfcm.xml";  // ISO 8859-1
  folder.file(room, glowing_sphere);
  const Outcome outcome =
      folder.run({"stress", room, "--width", "8", "--spp", "1", "-q", "--json", "-", "-o", "sheet.png"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(nlohmann::json::parse(outcome.out)["scene"] == "r\uFFFDm");
  CHECK(outcome.err.empty());
  CHECK(folder.run({"stress", "scene.xml", "-o", "nowhere/sheet.png"}).code == 1);
  CHECK(folder.run({"stress", "scene.xml", "-o", "sheet.jpg"}).code == 2);
}

TEST_CASE("the whole picture, whatever crop window the scene has") {
  const Folder folder;
  std::string cropped = glowing_sphere;
  const std::string film_end = "</film>";
  cropped.insert(cropped.find(film_end),
                 "<integer name=\"crop_offset_x\" value=\"20\"/><integer name=\"crop_offset_y\" value=\"4\"/>"
                 "<integer name=\"crop_width\" value=\"12\"/><integer name=\"crop_height\" value=\"8\"/>");
  folder.file("whole.xml", glowing_sphere);
  folder.file("cropped.xml", cropped);
  const auto sheet_of = [&](const std::string& scene) {
    const Outcome outcome = folder.run({"stress", scene, "--width", "16", "--spp", "1", "-q", "-o", "sheet.exr"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(contains(outcome.err, "crop window is not taken") == (scene == "cropped.xml"));
    return strahl::read_image(folder.path("sheet.exr"));
  };
  // Of a width at which the window would lie outside.
  const strahl::Image whole = sheet_of("whole.xml"), cropped_sheet = sheet_of("cropped.xml");
  CHECK(cropped_sheet.width == whole.width);
  CHECK(cropped_sheet.data == whole.data);
}

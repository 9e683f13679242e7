// SPDX-License-Identifier: MIT
// What counts as a number, and which of two values holds. No device is needed: none is called so, and the exit code 4
// says that everything before it was right.
#include <catch2/catch.hpp>

#include "cli/program.h"

using namespace strahl_test;

namespace {

Outcome render_with(const Folder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{folder.file("scene.xml", glowing_sphere), "-d", "no-such-device"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return folder.run(arguments);
}

}  // namespace

TEST_CASE("an option that takes a number takes no NaN, no infinity and nothing out of its range") {
  const Folder folder;
  struct Wrong {
    const char* option;
    const char* value;
    const char* says;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {"--max-error", "nan", "--max-error: must be a finite number > 0, not \"nan\""},
           {"--max-error", "inf", "must be a finite number > 0"},
           {"--max-error", "0", "must be a finite number > 0"},
           {"--max-error", "-1", "must be a finite number > 0"},
           {"--max-error", "1e-400", "must be a finite number > 0"},
           {"--max-error", "much", "must be a finite number > 0"},
           {"--exposure", "nan", "--exposure: must be a number from -64 to 64, not \"nan\""},
           {"--exposure", "65", "must be a number from -64 to 64"},
           {"--time", "nan", "--time: must be a finite time > 0"},
           {"--time", "inf", "must be a finite time > 0"},
           {"--time", "1e308h", "must be a finite time > 0"},
           {"--time", "0", "must be a finite time > 0"},
       }) {
    INFO(wrong.option << " " << wrong.value);
    const Outcome outcome = render_with(folder, {wrong.option, wrong.value});
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, wrong.says));
    CHECK(outcome.err.size() < 300);
  }
  for (const std::vector<std::string>& right : std::vector<std::vector<std::string>>{
           {"--max-error", "1e-3"}, {"--exposure", "-1.5"}, {"--time", "5"}, {"--time", "1.5h"}, {"--time", "16ms"}})
    CHECK(render_with(folder, right).code == 4);
}

TEST_CASE("a side that follows from the other is refused where it would be too long") {
  const Folder folder;
  CHECK(render_with(folder, {"--height", "49152"}).code == 4);
  const Outcome outcome = render_with(folder, {"--height", "65536"});
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, "the width would be 87381 pixels, more than 65536; ask for fewer"));
  CHECK(render_with(folder, {"--height", "65536", "--width", "8"}).code == 4);
  CHECK(contains(render_with(folder, {"--width", "1", "--pixel", "9,9"}).err, "1 x 1 pixels"));
}

TEST_CASE("whole numbers are decimal, with zeros in front too, and the intervals of explain hold no NaN") {
  const Folder folder;
  // The picture's size is told where --pixel lies outside of it.
  const Outcome wide = render_with(folder, {"--width", "0512", "--height", "010", "--pixel", "9999,0"});
  INFO(wide.err);
  CHECK(contains(wide.err, "512 x 10 pixels"));
  for (const char* seed : {"008", "-0", "+7", "0", "0000", "2147483647"})
    CHECK(render_with(folder, {std::string("--seed=") + seed}).code == 4);
  CHECK(render_with(folder, {"--lanes", "010"}).code == 2);
  CHECK(render_with(folder, {"--lanes", "08", "--png-bits", "016", "--max-depth=-01"}).code == 4);
  for (const char* wrong : {"0x10", "1e3", "8.0", "-", " 8", "2147483648", "99999999999999999999"}) {
    const Outcome outcome = render_with(folder, {std::string("--seed=") + wrong});
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "--seed: "));
  }
  const auto explained = [&](const char* option, const char* value) {
    return folder.run({"explain", "scene.xml", "--cost", option, value, "-d", "no-such-device"});
  };
  CHECK(contains(explained("--pilot", "nan").err, "--pilot: must be a number from 0.01 to 3600, not \"nan\""));
  CHECK(contains(explained("--error-share", "nan").err, "--error-share: must be a number from 1e-06 to 1"));
  CHECK(explained("--pilot", "0.5").code == 4);
}

TEST_CASE("a bound that no value can be held against is refused") {
  const Folder folder;
  folder.file("a.pfm", "Pf\n1 1\n-1.0\n" + std::string(4, '\0'));
  const auto compared = [&](const char* option, const char* value) {
    return folder.run({"compare", "a.pfm", "a.pfm", "--metric", "rmse", option, value});
  };
  for (const char* bound : {"nan", "inf", "-inf", "few"}) {
    const Outcome outcome = compared("--fail-above", bound);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "--fail-above: must be a finite number"));
  }
  CHECK(compared("--fail-above", "0").code == 0);
  CHECK(compared("--fail-above", "-1").code == 7);
  CHECK(contains(compared("--ppd", "nan").err, "--ppd: must be"));
  for (const char* ppd : {"0.5", "1000.5", "1e10"}) CHECK(contains(compared("--ppd", ppd).err, "--ppd: must be"));
}

TEST_CASE("of two values the last holds") {
  const Folder folder;
  const auto says = [&](const std::vector<std::string>& more) { return render_with(folder, more).err; };
  // The device's name is told, and the picture's size where --pixel lies outside of it.
  CHECK(contains(says({"-d", "another"}), "\"another\""));
  CHECK(contains(says({"--width", "8", "--pixel", "100,0", "--width", "64"}), "64 x 48"));
  CHECK(render_with(folder, {"--spp", "4", "--spp", "8", "--time", "x", "--time", "1s", "--max-error", "1",
                             "--max-error", "2", "--precision", "fast", "--precision", "double"})
            .code == 4);
  CHECK(render_with(folder, {"-o", "missing/a.png", "-o", "b.png"}).code == 4);
  // Lists keep all of their values.
  CHECK(contains(says({"--aov", "colour", "--aov", "depth"}), "colour"));
  CHECK(contains(says({"-D", "first", "-D", "b=1"}), "\"first\""));
  CHECK(contains(folder.run({"explain", "scene.xml", "--lanes", "1", "--lanes", "8"}).out, "8 lanes"));
  // Two scenes are no option given twice.
  CHECK(render_with(folder, {"other.xml"}).code == 2);
}

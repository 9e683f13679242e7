// SPDX-License-Identifier: MIT
// Where the result cannot be written, nothing is computed: there is no such device, and nobody finds out.
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "cli/program.h"

using namespace strahl_test;

namespace {

Outcome render_to(const Folder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{folder.file("scene.xml", glowing_sphere), "-d", "no-such-device"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return folder.run(arguments);
}

}  // namespace

TEST_CASE("outputs that cannot be written fail before a device is looked for") {
  const Folder folder;
  mkdir(folder.path("folder.png").c_str(), 0700);
  mkdir(folder.path("layers.depth.png").c_str(), 0700);
  const Outcome layer = render_to(folder, {"-o", "layers.png", "--aov", "depth"});
  CHECK(layer.code == 1);
  CHECK(contains(layer.err, "layers.depth.png"));
  CHECK(render_to(folder, {}).code == 4);  // The device is looked for once the output is right.
  for (const std::vector<std::string>& outputs : std::vector<std::vector<std::string>>{
           {"-o", "missing/out.png"},
           {"-o", "folder.png"},
           {"-o", "scene.xml/out.png"},
           {"-o", "out.png", "--stats", "missing/stats.json"},
           {"-o", "out.png", "--dump-kernel", "missing/kernel.cl"},
       }) {
    INFO(outputs.back());
    const Outcome outcome = render_to(folder, outputs);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "strahl: error: "));
    CHECK(contains(outcome.err, outputs.back()));
  }
  CHECK(folder.files() == std::vector<std::string>{"folder.png", "layers.depth.png", "scene.xml"});
}

TEST_CASE("of frames it is each of theirs that must be writable, and not the name that they are made from") {
  const Folder folder;
  const std::vector<std::string> frames{"-o", "f.png", "--aov", "depth", "--time", "1s", "--frames", "12"};
  mkdir(folder.path("f.png").c_str(), 0700);
  mkdir(folder.path("f.0013.png").c_str(), 0700);
  mkdir(folder.path("f.0002x.png").c_str(), 0700);
  CHECK(render_to(folder, frames).code == 4);
  for (const std::string name : {"f.0002.png", "f.0012.depth.png"}) {
    INFO(name);
    mkdir(folder.path(name).c_str(), 0700);
    const Outcome outcome = render_to(folder, frames);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, name + "\": it is a folder"));
    rmdir(folder.path(name).c_str());
  }
  CHECK(render_to(folder, {"-o", "missing/f.png", "--time", "1s", "--frames", "2"}).code == 1);
}

TEST_CASE("a folder without permission fails before a device is looked for") {
  if (geteuid() == 0) return;  // Root may write anywhere.
  const Folder folder;
  mkdir(folder.path("closed").c_str(), 0500);
  CHECK(render_to(folder, {"-o", "closed/out.png"}).code == 1);
}

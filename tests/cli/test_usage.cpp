// SPDX-License-Identifier: MIT
// Help, version, and the exit code 2 of what cannot be parsed.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "cli/program.h"

using namespace strahl_test;

TEST_CASE("the program's help lists commands, examples and exit codes") {
  const Folder folder;
  const Outcome help = folder.run({"--help"});
  REQUIRE(help.code == 0);
  REQUIRE(help.err.empty());
  for (const char* part : {"render", "intersect", "devices", "explain", "compare",
                           "Examples:", "Exit codes:", "4  no suitable OpenCL device", "129, 130, 143"})
    CHECK(contains(help.out, part));
}

TEST_CASE("every command has help with examples") {
  const Folder folder;
  for (const char* command : {"render", "intersect", "devices", "explain", "compare"}) {
    INFO(command);
    const Outcome help = folder.run({command, "--help"});
    CHECK(help.code == 0);
    CHECK(contains(help.out, "Examples:"));
    CHECK(contains(help.out, std::string("strahl ") + command));
  }
}

TEST_CASE("tradeoff's help names every integrator whose depth can be varied") {
  const Folder folder;
  CHECK(contains(folder.run({"tradeoff", "--help"}).out, "max_depth of whitted, path, volpath, ptracer, bdpt;"));
}

TEST_CASE("help says which commands an option has an effect in") {
  const Folder folder;
  const std::string explain = folder.run({"explain", "--help"}).out;
  CHECK(contains(explain, "auto, "));
  CHECK(contains(explain, "`render` prints its linear R G B"));
  CHECK(contains(explain, "(render, intersect)"));
}

TEST_CASE("render's help names every option that the documentation has") {
  const Folder folder;
  const std::string help = folder.run({"render", "--help"}).out;
  for (const char* option :
       {"-o,--output",   "-d,--device", "-D",           "-q",           "-v",       "--strict",      "--precision",
        "--spp",         "--seed",      "--integrator", "--max-depth",  "--width",  "--height",      "--crop",
        "--pixel",       "--sampler",   "--exposure",   "--png-bits",   "--aov",    "--stats",       "--stats-detail",
        "--dump-kernel", "--generic",   "--lanes",      "--work-group", "--passes", "--no-progress", "--disable",
        "--bvh-width",   "--accel",     "--time",       "--max-error",  "--frames", "--sensor",      "--root"}) {
    INFO(option);
    CHECK(contains(help, std::string("  ") + option));
    const std::string name = option;
    const std::string spelled = name.substr(name.find(',') == std::string::npos ? 0 : name.find(',') + 1);
    CHECK(contains(read_text(STRAHL_SOURCE_DIR "/docs/cli.md"), "`" + spelled));
  }
}

TEST_CASE("the version is printed") {
  const Folder folder;
  const Outcome version = folder.run({"--version"});
  CHECK(version.code == 0);
  CHECK(version.out == "strahl " STRAHL_VERSION "\n");
}

TEST_CASE("what cannot be parsed is exit code 2, with the remedy") {
  const Folder folder;
  const std::string scene = folder.file("scene.xml", glowing_sphere);
  struct Wrong {
    std::vector<std::string> arguments;
    const char* says;
  };
  const std::vector<Wrong> all{
      {{}, "--help"},
      {{"rendr", scene}, "did you mean \"render\"?"},
      {{"render"}, "strahl render --help"},
      {{"render", scene, "--sp", "4"}, "did you mean \"--spp\"?"},
      {{scene, "--spp", "0"}, "--spp"},
      {{scene, "--spp", "many"}, "--spp"},
      {{scene, "--width", "65537"}, "--width"},
      {{scene, "--png-bits", "12"}, "--png-bits"},
      {{scene, "--lanes", "4"}, "--lanes"},
      {{scene, "--lanes", "16", "--precision", "double"}, "1 or 8 lanes"},
      {{scene, "--work-group", "8by8"}, "--work-group takes"},
      {{scene, "--aov", "colour"}, "depth, normal, position"},
      {{scene, "--disable", "EMISION"}, "did you mean \"EMISSION\"?"},
      {{scene, "--disable", "integrators/path"}, "--integrator takes another one"},
      {{scene, "--precision", "half"}, "--precision"},
      {{scene, "--integrator", "normls"}, "did you mean \"normals\"?"},
      {{scene, "-o", "out.jpg"}, "png"},
      {{scene, "-o", ""}, "--output: must not be empty"},
      {{scene, "--stats", ""}, "--stats: must not be empty"},
      {{scene, "-D", "novalue"}, "name=value"},
      {{scene, "--crop", "0,0,8"}, "x0,y0,x1,y1"},
      {{scene, "--crop", "0,0,33,8"}, "outside the picture of 32 x 24"},
      {{scene, "--crop", "8,8,8,9"}, "empty"},
      {{scene, "--pixel", "32,0"}, "outside the picture of 32 x 24"},
      {{scene, "--pixel", "1,1", "--crop", "0,0,2,2"}, "excludes"},
      {{scene, "-q", "-v"}, "excludes"},
      {{scene, "--stats-detail"}, "--stats"},
      {{"intersect", scene, "--rays", "r.npy"}, "--output"},
      {{"compare", "a.png"}, "B"},
  };
  for (const Wrong& wrong : all) {
    std::string line;
    for (const std::string& argument : wrong.arguments) line += argument + " ";
    INFO(line);
    const Outcome outcome = folder.run(wrong.arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.rfind("strahl: error: ", 0) == 0);
    CHECK(contains(outcome.err, wrong.says));
  }
  CHECK(folder.files() == std::vector<std::string>{"scene.xml"});
}

TEST_CASE("a scene that cannot be used is exit code 3, its lines as they are") {
  const Folder folder;
  folder.file("broken.xml", "<scene version=\"3.0.0\">\n  <shape type=\"sphere\"\n</scene>\n");
  const Outcome broken = folder.run({"broken.xml"});
  CHECK(broken.code == 3);
  CHECK(contains(broken.err, "broken.xml:"));
  CHECK(contains(broken.err, ": error: "));
  CHECK_FALSE(contains(broken.err, "strahl: error:"));
  CHECK(folder.run({"missing.xml"}).code == 3);
}

TEST_CASE("a result that cannot be printed is a failure, no crash") {
  const Folder folder;
  const std::string full = "/dev/full";
  REQUIRE(std::filesystem::exists(full));
  folder.file("a.pfm", "Pf\n1 1\n-1.0\n" + std::string(4, '\0'));
  const std::string quoted = std::string("exec ") + STRAHL_PROGRAM + " compare a.pfm a.pfm ";
  const auto in_shell = [&](const std::string& redirection) {
    const std::string line = "cd " + folder.path("") + " && (" + quoted + redirection + ")";
    return WEXITSTATUS(std::system(line.c_str()));
  };
  CHECK(in_shell(">/dev/null") == 0);
  CHECK(in_shell(">/dev/full 2>/dev/null") == 1);
  CHECK(in_shell(">&- 2>&-") == 1);
  CHECK(in_shell(">/dev/null 2>&- --heatmap h.png") == 0);
}

TEST_CASE("a closed stream's number goes to no file") {
  const Folder folder;
  folder.file("a.pfm", "Pf\n1 1\n-1.0\n" + std::string(4, '\0'));
  // Reads what the program itself has as its standard output: /dev/null, not nothing and not a.pfm.
  std::filesystem::create_symlink("/proc/self/fd/1", folder.path("stdout.pfm"));
  const std::string program = STRAHL_PROGRAM;
  const std::string line =
      "cd " + folder.path("") + " && " + program + " compare stdout.pfm a.pfm >&- 2>said; test $? -eq 3";
  CHECK(std::system(line.c_str()) == 0);
  CHECK(contains(read_text(folder.path("said")), "it is a device"));
}

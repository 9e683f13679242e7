// SPDX-License-Identifier: MIT
// Checkpoints, parts and snapshots as a user has them: the program is killed, interrupted, given other options and
// damaged files; pictures come out with the bits of one run, or one message says why not.
#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include "checkpoint/checkpoint.h"
#include "cli/program.h"
#include "cli/same_picture.h"
#include "image/image_io.h"

using namespace strahl_test;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

const std::string cornell = STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml";

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Of the scene with these options; long enough to be killed in its midst.
std::vector<std::string> render_of(const std::string& spp = "256") {
  return {cornell, "--width", "64", "--spp", spp, "-d", "pocl", "--no-progress", "--brief"};
}

Outcome succeed(const Folder& folder, const std::vector<std::string>& arguments) {
  Outcome outcome = folder.run(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.signal == 0);
  REQUIRE(outcome.code == 0);
  return outcome;
}

/// Refused with `code`, and every one of the words said; no file more than there was.
void refuse(const Folder& folder, const std::vector<std::string>& arguments, int code,
            const std::vector<std::string>& words) {
  const std::vector<std::string> before = folder.files();
  const Outcome outcome = folder.run(arguments);
  INFO(outcome.err);
  CHECK(outcome.code == code);
  for (const std::string& word : words) CHECK(contains(outcome.err, word));
  CHECK(folder.files() == before);
}

void keep_only(const Folder& folder, const std::string& kept) {
  for (const std::string& name : folder.files())
    if (name != kept) fs::remove(folder.path(name));
}

void wait_for(const std::string& path) {
  for (int i = 0; i < 6000 && !fs::exists(path); ++i) std::this_thread::sleep_for(5ms);
}

}  // namespace

TEST_CASE("killed at any moment, again and again, it ends with the same picture") {
  const Folder folder;
  succeed(folder, render_of("600") + std::vector<std::string>{"-o", "one.exr"});
  const auto start = std::chrono::steady_clock::now();
  succeed(folder, render_of("600") + std::vector<std::string>{"-o", "one.exr"});
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;

  const char* many = std::getenv("STRAHL_KILLS");
  const int kills = many != nullptr ? std::atoi(many) : 3;
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> share(0.05, 0.95);
  int killed = 0, resumed = 0;
  for (int kill_number = 0; kill_number < kills; ++kill_number) {
    INFO("kill " << kill_number);
    keep_only(folder, "one.exr");
    // As a script would: resumed where there is something to resume.
    const auto attempt = [&](double seconds) {
      const bool is_there = fs::exists(folder.path("c.ckpt"));
      if (is_there) ++resumed;
      return folder.run(render_of("600") + std::vector<std::string>{"-o", "out.exr", "--every", "50ms",
                                                                    is_there ? "--resume" : "--checkpoint", "c.ckpt"},
                        {}, [&](pid_t child) {
                          if (seconds <= 0) return;
                          std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
                          kill(child, SIGKILL);
                        });
    };
    for (int i = 0; i < 2; ++i)
      if (attempt(share(random) * whole.count()).signal == SIGKILL) ++killed;
    const Outcome last = attempt(0);
    INFO(last.err);
    REQUIRE(last.code == 0);
    require_same_picture(folder, "one.exr", "out.exr");
  }
  CHECK(killed > 0);
  CHECK(resumed > 0);
  if (many != nullptr) WARN(kills << " renders, killed " << killed << " times, resumed " << resumed << " times");
}

TEST_CASE("interrupted, it keeps picture and checkpoint, and goes on with other passes and lanes") {
  const Folder folder;
  const std::vector<std::string> options = render_of("512") + std::vector<std::string>{"--aov", "depth,shape_id"};
  succeed(folder, options + std::vector<std::string>{"-o", "one.exr"});
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    INFO("signal " << signal);
    keep_only(folder, "one.exr");
    const Outcome stopped = folder.run(options + std::vector<std::string>{"-o", "part.exr", "--checkpoint", "c.ckpt",
                                                                          "--every", "1h", "--snapshot-every", "1ms"},
                                       {}, [&](pid_t child) {
                                         wait_for(folder.path("part.snapshot.exr"));  // In its midst, on any machine.
                                         kill(child, signal);
                                       });
    INFO(stopped.err);
    REQUIRE(stopped.code == 128 + signal);
    CHECK(contains(stopped.err, "--resume goes on from there"));
    CHECK(strahl::read_image(folder.path("part.exr")).metadata.count("incomplete") == 1);
    std::vector<std::string> resume{"-o", "out.exr", "--resume", "c.ckpt"};
    // One lane takes ten times as long.
    if (signal == SIGINT) resume = resume + std::vector<std::string>{"--passes", "3", "--lanes", "1", "--paths", "one"};
    succeed(folder, options + resume);
    require_same_picture(folder, "one.exr", "out.exr");
  }
}

TEST_CASE("a snapshot on demand and by the clock") {
  const Folder folder;
  const bool on_demand = GENERATE(true, false);
  const std::vector<std::string> clock =
      on_demand ? std::vector<std::string>{} : std::vector<std::string>{"--snapshot-every", "100ms"};
  const Outcome outcome = folder.run(
      render_of("1000000") + std::vector<std::string>{"-o", "out.png", "--aov", "normal", "--dump-kernel", "k"} + clock,
      {}, [&](pid_t child) {
        wait_for(folder.path("k"));
        std::this_thread::sleep_for(300ms);
        if (on_demand) kill(child, SIGUSR1);
        wait_for(folder.path("out.snapshot.normal.png"));
        kill(child, SIGKILL);
      });
  CHECK(outcome.signal == SIGKILL);
  const strahl::Image image = strahl::read_image(folder.path("out.snapshot.png"));
  CHECK(image.width == 64);
  CHECK(image.metadata.at("incomplete") == "snapshot");
  CHECK(fs::exists(folder.path("out.snapshot.normal.png")));
  CHECK_FALSE(fs::exists(folder.path("out.png")));
}

TEST_CASE("a snapshot of a picture whose samples nobody knows beforehand states those that it has") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);  // Whose own number of samples is 1.
  const Outcome outcome = folder.run({"scene.xml", "-o", "out.exr", "--time", "60s", "--snapshot-every", "500ms", "-q"},
                                     {}, [&](pid_t child) {
                                       wait_for(folder.path("out.snapshot.exr"));
                                       kill(child, SIGKILL);
                                     });
  CHECK(outcome.signal == SIGKILL);
  CHECK(std::stoi(strahl::read_image(folder.path("out.snapshot.exr")).metadata.at("spp")) > 8);
}

TEST_CASE("what does not fit is refused, and named") {
  const Folder folder;
  const std::string text = read_text(cornell);
  folder.file("a.xml", text);
  const auto options = [&](const std::string& scene) {
    return std::vector<std::string>{scene, "--width", "16", "--spp", "8", "-d", "pocl", "-q", "-o", "x.exr"};
  };
  succeed(folder, options("a.xml") + std::vector<std::string>{"--checkpoint", "c.ckpt"});
  const auto resumed = [&](const std::vector<std::string>& more, const std::string& scene = "a.xml") {
    return options(scene) + more + std::vector<std::string>{"--resume", "c.ckpt"};
  };
  refuse(folder, resumed({"--seed", "7"}), 3, {"the seed is 0 there and 7 here", "render without --resume"});
  refuse(folder, resumed({"--width", "17"}), 3, {"the picture's size is 16x16 there and 17x17 here"});
  refuse(folder, resumed({"--spp", "64"}), 3, {"--spp"});
  refuse(folder, resumed({"--no-error"}), 3, {"--no-error"});
  refuse(folder, resumed({"--precision", "stable"}), 3, {"--precision is robust there and stable here"});
  refuse(folder, resumed({"--aov", "depth"}), 3, {"--aov is none there and depth here"});
  refuse(folder, resumed({"--samples", "4:8", "--checkpoint", "d.ckpt"}), 3, {"begin at 0 and not at 4"});
  // The version may be the same, and what it shows of a scene another.
  strahl::Checkpoint other = strahl::read_checkpoint(folder.path("c.ckpt"));
  const auto sources = std::find_if(other.header.identity.parts.begin(), other.header.identity.parts.end(),
                                    [](const auto& part) { return part.name == "the hash of its host's sources"; });
  REQUIRE(sources != other.header.identity.parts.end());
  CHECK(sources->value.size() == 16);
  sources->value = "0123456789abcdef";
  strahl::write_checkpoint(folder.path("other.ckpt"), other);
  refuse(folder, options("a.xml") + std::vector<std::string>{"--resume", "other.ckpt"}, 3,
         {"the hash of its host's sources is 0123456789abcdef there and"});
  folder.file("b.xml", text + "<!-- another -->\n");
  refuse(folder, resumed({}, "b.xml"), 3, {"the hash of file 1 (b.xml) is"});
  // The same scene elsewhere is the same scene.
  fs::create_directory(folder.path("elsewhere"));
  folder.file("elsewhere/c.xml", text);
  succeed(folder, resumed({}, "elsewhere/c.xml"));

  refuse(folder, options("a.xml") + std::vector<std::string>{"--resume", "none.ckpt"}, 3, {"there is no such file"});
  refuse(folder, options("a.xml") + std::vector<std::string>{"--resume", "b.xml"}, 3, {"is no checkpoint"});
  const std::string bytes = read_text(folder.path("c.ckpt"));
  folder.file("cut.ckpt", bytes.substr(0, bytes.size() - 9));
  refuse(folder, options("a.xml") + std::vector<std::string>{"--resume", "cut.ckpt"}, 3, {"is damaged: it has"});
  std::string flipped = bytes;
  flipped[bytes.size() - 100] ^= 1;
  folder.file("flipped.ckpt", flipped);
  refuse(folder, options("a.xml") + std::vector<std::string>{"--resume", "flipped.ckpt"}, 3,
         {"is damaged", "checksum"});
  refuse(folder, options("a.xml") + std::vector<std::string>{"--checkpoint", "x.exr"}, 2, {"are one file"});
  refuse(folder, options("a.xml") + std::vector<std::string>{"--checkpoint", "no/c.ckpt"}, 1, {"does not exist"});
}

TEST_CASE("of a value that is defined twice the last one is the picture's") {
  const Folder folder;
  std::string text = glowing_sphere;
  text.replace(text.find("4, 2, 1"), 7, "$c, 2, 1");
  folder.file("s.xml", text);
  const auto with = [](const std::vector<std::string>& defines, const char* keep) {
    std::vector<std::string> line{"s.xml", "-d", "pocl", "-q", "-o", "x.exr", keep, "c.ckpt"};
    for (const std::string& define : defines) line.insert(line.end(), {"-D", define});
    return line;
  };
  succeed(folder, with({"c=1", "c=3"}, "--checkpoint"));
  refuse(folder, with({"c=3", "c=1"}, "--resume"), 3, {"-D is c=3 there and c=1 here"});
  succeed(folder, with({"c=3"}, "--resume"));
}

TEST_CASE("another camera is another picture, whatever it is called") {
  const Folder folder;
  std::string text = glowing_sphere;
  text.replace(text.find("</scene>"), 0, "<sensor type=\"perspective\" id=\"side\"/>");
  folder.file("s.xml", text);
  const auto with = [](const char* sensor, const char* keep) {
    return std::vector<std::string>{"s.xml", "-d", "pocl", "-q", "-o", "x.exr", keep, "c.ckpt", "--sensor", sensor};
  };
  succeed(folder, with("1", "--checkpoint"));
  succeed(folder, with("side", "--resume"));
  refuse(folder, with("0", "--resume"), 3, {"--sensor is 1 there and 0 here"});
}

TEST_CASE("a value that is not UTF-8 is gone on with, and told apart from others") {
  const Folder folder;
  std::string text = glowing_sphere;
  text.replace(text.find("type=\"sphere\""), 13, "type=\"sphere\" id=\"$name\"");
  folder.file("s.xml", text);
  const auto with = [](const std::string& name, const char* keep) {
    return std::vector<std::string>{"s.xml", "-d", "pocl", "-q", "-o", "x.exr", keep, "c.ckpt", "-D", "name=" + name};
  };
  succeed(folder, with("b\xe4ll\\", "--checkpoint"));
  succeed(folder, with("b\xe4ll\\", "--resume"));
  refuse(folder, with("b\xf6ll\\", "--resume"), 3, {"-D is name=b\\xe4ll\\x5c there and name=b\\xf6ll\\x5c here"});
  refuse(folder, with("b\\xe4ll\\", "--resume"), 3, {"-D is"});
  succeed(folder, with("b\xe4ll", "--checkpoint"));
  refuse(folder, with("b\\xe4ll", "--resume"), 3, {"-D is"});
  succeed(folder, with("b\xc3\xa4ll\\", "--checkpoint"));
  succeed(folder, with("b\xc3\xa4ll\\", "--resume"));
}

TEST_CASE("usage of what keeps a render") {
  const Folder folder;
  folder.file("s.xml", glowing_sphere);
  refuse(folder, {"s.xml", "--samples", "0:4"}, 2, {"--checkpoint"});
  refuse(folder, {"s.xml", "--samples", "4:4", "--checkpoint", "c"}, 2, {"--samples takes A:B"});
  refuse(folder, {"s.xml", "--samples", "0:4x", "--checkpoint", "c"}, 2, {"--samples takes A:B"});
  refuse(folder, {"s.xml", "--samples", "0:4", "--time", "1s", "--checkpoint", "c"}, 2, {"--samples", "--time"});
  refuse(folder, {"s.xml", "--every", "never", "--checkpoint", "c"}, 2, {"--every: must be a finite time"});
  refuse(folder, {"s.xml", "--snapshot-every", "0s"}, 2, {"--snapshot-every: must be a finite time"});
  refuse(folder, {"s.xml", "--frames", "2", "--time", "1s", "--checkpoint", "c"}, 2, {"--frames", "checkpoint"});
  refuse(folder, {"s.xml", "--dry-run", "--checkpoint", "c"}, 2, {"--dry-run"});
  refuse(folder, {"s.xml", "--dry-run", "--watchdog", "5s"}, 2, {"--watchdog", "--dry-run"});
  refuse(folder, {"s.xml", "--dry-run", "-o", "o.png", "--snapshot-every", "5s"}, 2, {"--dry-run"});
  refuse(folder, {"s.xml", "--every", "10s"}, 2, {"--every", "--checkpoint"});
  refuse(folder, {"s.xml", "--snapshot-every", "1s", "--samples", "0:4", "--checkpoint", "c"}, 2, {"-o"});
  refuse(folder, {"s.xml", "--snapshot-every", "1s", "--pixel", "0,0"}, 2, {"-o"});
  refuse(folder, {"s.xml", "--snapshot-every", "1s", "--frames", "2", "--time", "1s"}, 2, {"--frames"});
  // Neither is opened: for a pipe that would be to wait for its other end.
  REQUIRE(::mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  refuse(folder, {"s.xml", "--checkpoint", "pipe"}, 2, {"a checkpoint is a file", "pipe"});
  refuse(folder, {"s.xml", "--checkpoint", "/dev/null"}, 2, {"a checkpoint is a file"});
  refuse(folder, {"s.xml", "--checkpoint", "/dev/stdout"}, 2, {"a checkpoint is a file"});
  refuse(folder, {"s.xml", "--resume", "pipe"}, 3, {"a checkpoint is a file"});
  refuse(folder, {"merge", "-o", "x.exr"}, 2, {"parts is required"});
}

TEST_CASE("parts become the picture of one run; what overlaps or is missing is named") {
  const Folder folder;
  const std::vector<std::string> options = {cornell, "--width", "24", "--spp", "40",
                                            "-d",    "pocl",    "-q", "--aov", "normal"};
  succeed(folder, options + std::vector<std::string>{"-o", "one.exr", "--error-map", "map.exr"});
  const auto part = [&](const std::string& range, const std::string& name) {
    succeed(folder, options + std::vector<std::string>{"--samples", range, "--checkpoint", name});
  };
  part("0:10", "a.ckpt");
  part("10:11", "b.ckpt");
  part("11:32", "c.ckpt");
  part("32:40", "d.ckpt");
  CHECK(folder.files() == std::vector<std::string>{"a.ckpt", "b.ckpt", "c.ckpt", "d.ckpt", "map.exr", "one.exr"});
  succeed(folder, {"merge", "c.ckpt", "a.ckpt", "d.ckpt", "b.ckpt", "-o", "sum.exr", "--error-map", "sum-map.exr"});
  require_same_picture(folder, "one.exr", "sum.exr");
  require_same_picture(folder, "map.exr", "sum-map.exr");
  // By a larger part.
  succeed(folder, {"merge", "c.ckpt", "b.ckpt", "-o", "bc.ckpt"});
  succeed(folder, {"merge", "d.ckpt", "bc.ckpt", "a.ckpt", "-o", "again.exr"});
  require_same_picture(folder, "one.exr", "again.exr");

  refuse(folder, {"merge", "a.ckpt", "b.ckpt", "d.ckpt", "-o", "x.exr"}, 3,
         {"samples 11:32 are missing", "--samples 11:32"});
  refuse(folder, {"merge", "b.ckpt", "c.ckpt", "d.ckpt", "-o", "x.exr"}, 3, {"samples 0:10 are missing"});
  refuse(folder, {"merge", "a.ckpt", "bc.ckpt", "-o", "x.exr"}, 3, {"samples 32:40 are missing"});
  refuse(folder, {"merge", "a.ckpt", "bc.ckpt", "c.ckpt", "-o", "x.exr"}, 3, {"bc.ckpt", "c.ckpt", "overlap"});
  refuse(folder, {"merge", "a.ckpt", "a.ckpt", "-o", "x.ckpt"}, 3, {"overlap"});
  succeed(folder,
          options + std::vector<std::string>{"--seed", "3", "--samples", "10:40", "--checkpoint", "other.ckpt"});
  refuse(folder, {"merge", "a.ckpt", "other.ckpt", "-o", "x.exr"}, 3,
         {"not of one picture", "the seed is 0 there and 3"});
  refuse(folder, {"merge", "a.ckpt", "one.exr", "-o", "x.exr"}, 3, {"one.exr", "is no checkpoint"});
  refuse(folder, {"merge", "a.ckpt", "bc.ckpt", "-o", "a.ckpt"}, 2, {"written over"});
  refuse(folder, {"merge", "a.ckpt", "bc.ckpt", "-o", "x.ckpt", "--error-map", "x.exr"}, 2, {"--error-map is of a"});
  refuse(folder, {"merge", "a.ckpt", "bc.ckpt", "-o", "x.ckpt", "--exposure", "3"}, 2, {"--exposure is of a picture"});
  refuse(folder, {"merge", "a.ckpt", "bc.ckpt", "-o", "x.ckpt", "--png-bits", "8"}, 2, {"--png-bits is of a picture"});
  const std::vector<std::string> all{"merge", "a.ckpt", "bc.ckpt", "d.ckpt", "-o", "out.png"};
  refuse(folder, all + std::vector<std::string>{"--error-map", "out.normal.png"}, 2,
         {"--error-map", "the picture of the AOV normal", "are one file"});
  fs::copy_file(folder.path("d.ckpt"), folder.path("out.normal.png"));
  refuse(folder, {"merge", "a.ckpt", "bc.ckpt", "out.normal.png", "-o", "out.png"}, 2, {"written over a part"});
}

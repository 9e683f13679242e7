// SPDX-License-Identifier: MIT
// Inputs that cannot be read: the cause is said, and nothing is read for ever.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <thread>

#include "cli/program.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

/// Ends the program where it still runs after a minute: then it reads for ever.
Outcome run_a_minute(const Folder& folder, const std::vector<std::string>& arguments) {
  return folder.run(arguments, {}, [](pid_t child) {
    using namespace std::chrono_literals;
    for (int wait = 0; wait < 600; ++wait) {
      siginfo_t state{};
      if (waitid(P_PID, static_cast<id_t>(child), &state, WEXITED | WNOHANG | WNOWAIT) != 0 || state.si_pid != 0)
        return;
      std::this_thread::sleep_for(100ms);
    }
    kill(child, SIGKILL);
  });
}

}  // namespace

TEST_CASE("why a scene cannot be read") {
  const Folder folder;
  fs::create_directory(folder.path("folder"));
  fs::create_directory(folder.path("folder.obj"));
  fs::create_symlink("b.xml", folder.path("a.xml"));
  fs::create_symlink("a.xml", folder.path("b.xml"));
  fs::create_symlink("loop", folder.path("loop"));
  folder.file("file", "");
  struct Fault {
    const char* path;
    const char* says;
  };
  for (const Fault& fault : std::vector<Fault>{{"folder", "it is a folder"},
                                               {"folder.obj", "it is a folder"},
                                               {"./a.xml", "symbolic links go round in a loop"},
                                               {"loop", "symbolic links go round in a loop"},
                                               {"none.xml", "there is no such file; is the path right?"},
                                               {"none.ply", "there is no such file; is the path right?"},
                                               {"file/none.xml", "a part of its path is no folder"},
                                               {"/dev/zero", "it is a device"},
                                               {"/dev/null", "it is a device"}}) {
    INFO(fault.path);
    const Outcome outcome = run_a_minute(folder, {fault.path});
    INFO(outcome.err);
    CHECK(outcome.code == 3);
    CHECK(contains(outcome.err, fault.says));
  }
}

TEST_CASE("a file without permission") {
  if (geteuid() == 0) return;  // Root may read anything.
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  chmod(folder.path("scene.xml").c_str(), 0);
  const Outcome outcome = folder.run({"scene.xml"});
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "no permission to read it"));
}

TEST_CASE("why a scene's file, a picture and rays cannot be read") {
  const Folder folder;
  fs::create_directory(folder.path("mesh.obj"));
  fs::create_symlink("/dev/zero", folder.path("endless.npy"));
  fs::create_symlink("/dev/zero", folder.path("endless.png"));
  folder.file("scene.xml", R"(<scene version="3.0.0"><sensor type="perspective"/>
    <shape type="obj"><string name="filename" value="mesh.obj"/></shape></scene>)");
  const Outcome mesh = folder.run({"scene.xml"});
  CHECK(mesh.code == 3);
  CHECK(contains(mesh.err, "scene.xml:2:23: error: cannot read \"mesh.obj\": it is a folder"));
  const Outcome picture = run_a_minute(folder, {"compare", "endless.png", "endless.png"});
  CHECK(picture.code == 3);
  CHECK(contains(picture.err, "it is a device"));
  folder.file("glow.xml", glowing_sphere);
  const Outcome rays = run_a_minute(folder, {"intersect", "glow.xml", "--rays", "endless.npy", "-o", "h.npy"});
  CHECK(rays.code == 3);
  CHECK(contains(rays.err, "it is a device"));
}

TEST_CASE("a scene larger than any is refused before it is read") {
  const Folder folder;
  folder.file("large.xml", "<scene>");
  fs::resize_file(folder.path("large.xml"), (std::uintmax_t{1} << 30) + 1);  // A hole: it takes no room.
  const Outcome outcome = run_a_minute(folder, {"large.xml"});
  INFO(outcome.err);
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "more than 1024 MiB, the most that is read"));
}

TEST_CASE("a pipe is a scene's file as any other") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  mkfifo(folder.path("pipe.xml").c_str(), 0600);
  std::thread writer([&] { folder.file("pipe.xml", glowing_sphere); });
  const Outcome outcome = folder.run({"explain", "pipe.xml", "--lanes", "1"});
  writer.join();
  INFO(outcome.err);
  CHECK(outcome.code == 0);
}

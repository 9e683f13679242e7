// SPDX-License-Identifier: MIT
#include "cli/render_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "cli/distinct_files.h"
#include "cli/output_file.h"

namespace strahl::cli {
namespace {

namespace fs = std::filesystem;

/// The picture and its layers (picture_files.cpp): EXR holds them itself.
void add_picture(const RenderOptions& options, const std::string& name, const std::string& path,
                 std::vector<NamedFile>& files) {
  files.push_back({name, path});
  if (options.keep.snapshot_every) files.push_back({"the snapshot", path_beside(path, "snapshot")});
  if (image_format(path) == ImageFormat::exr) return;
  for (const std::string& layer : std::set(options.kernel.aovs.begin(), options.kernel.aovs.end()))
    files.push_back({"the picture of --aov " + layer, path_beside(path, layer)});
}

/// Links followed as far as they lead somewhere.
std::string followed(const std::string& path) {
  std::error_code unknown;
  return fs::weakly_canonical(path, unknown).string();
}

/// The number in "out.0001.png", "out.0001.depth.png" for "out.png"; 0 where there is none.
int frame_number(const std::string& picture, const std::string& path) {
  const std::string stem = fs::path(picture).stem().string() + ".", name = fs::path(path).filename().string();
  int number = 0;
  if (name.starts_with(stem)) std::from_chars(name.data() + stem.size(), name.data() + name.size(), number);
  return number;
}

}  // namespace

std::string frame_path(const std::string& path, int frame) { return path_beside(path, fmt::format("{:04}", frame)); }

void require_writable_frames(const std::string& picture, int frames, const std::vector<std::string>& layers) {
  const auto require_frame = [&](int frame) {
    const std::string path = frame_path(picture, frame);
    require_writable(path);
    require_writable_layers(path, layers);
  };
  // Of up to a million frames those whose names are the shortest and the longest, and those that are there already.
  std::set<int> numbers{1, frames};
  const std::string folder = fs::path(picture).parent_path().string();
  std::error_code unknown;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, unknown), end; !unknown && at != end;
       at.increment(unknown))
    numbers.insert(std::clamp(frame_number(picture, at->path().string()), 1, frames));
  for (const int number : numbers) require_frame(number);
}

void require_distinct_files(const RenderOptions& options, const std::string& picture,
                            const std::vector<std::string>& scene_files) {
  std::vector<NamedFile> outputs{
      {"--error-map", options.error_map}, {"--stats", options.stats}, {"--dump-kernel", options.dump_kernel}};
  // What is resumed may be written on to, by name: it is whole at any moment.
  if (!options.keep.target().empty()) outputs.push_back({"the checkpoint", options.keep.target()});
  std::vector<NamedFile> inputs = cli::scene_files(options.scene.path, scene_files);
  if (options.keep.resume != options.keep.target()) inputs.push_back({"--resume", options.keep.resume});
  if (!picture.empty() && !options.goal.frames) {
    add_picture(options, options.output.empty() ? "the picture" : "-o", picture, outputs);
  } else if (!picture.empty()) {
    // Of up to a million frames those that another file's name could be.
    std::set<int> numbers;
    for (const std::vector<NamedFile>& files : {outputs, inputs})
      for (const NamedFile& file : files)
        for (const std::string& path : {file.path, followed(file.path)}) numbers.insert(frame_number(picture, path));
    for (const int number : numbers)
      if (number >= 1 && number <= *options.goal.frames)
        add_picture(options, fmt::format("frame {}", number), frame_path(picture, number), outputs);
  }
  require_distinct(outputs, inputs);
}

}  // namespace strahl::cli

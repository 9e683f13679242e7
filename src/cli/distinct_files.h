// SPDX-License-Identifier: MIT
// No file of a command is written over another one of it: neither two outputs under one name, nor an input by an
// output.
#pragma once

#include <string>
#include <vector>

namespace strahl::cli {

/// A file that a command reads or writes, and what the user calls it: "-o", "the scene".
struct NamedFile {
  std::string name;
  std::string path;
};

/// Throws UsageError where two of the outputs, or an output and an input, are one file: by device and inode where they
/// are there, else by the path with its links followed. Pipes and devices may be named twice, and "-" is what standard
/// output is. Files without a path are passed over.
void require_distinct(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs);

/// The files that a scene was read from, as inputs.
[[nodiscard]] std::vector<NamedFile> scene_files(const std::string& scene, const std::vector<std::string>& files);

}  // namespace strahl::cli

// SPDX-License-Identifier: MIT
// The files that an OBJ file's mtllib line names.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "scene/meshes/mtl_reader.h"

namespace strahl {

class MtlLibraryFinder {
 public:
  /// Reads every file that `names` (the text after mtllib) names, relative to the OBJ file, each once. Several names
  /// are separated by blanks, yet a name may hold blanks, with or without a backslash before each: the longest run of
  /// words that is a file counts. Backslashes are also taken for slashes. Returns the names without a file.
  std::vector<std::string> read(const std::string& obj_path, const std::string& names, MtlLibrary& library);

 private:
  std::set<std::string> done_;
};

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Files that are written.
#include "cli/output_file.h"

#include <filesystem>

#include "cli/console.h"
#include "image/atomic_file.h"

namespace strahl::cli {
namespace fs = std::filesystem;

void require_writable(const std::string& path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  // A pipe's reader would take opening and closing it for the whole of what comes.
  const bool is_stream = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  if (!is_stream || is_open_already(path)) const AtomicFile never_committed(path);
}

void write_text(const std::string& path, const std::string& text) {
  if (path == "-") return print(text);
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace strahl::cli

// SPDX-License-Identifier: MIT
#include "scene/xml/search_path.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace strahl {

std::string SearchPath::find(std::string_view name, const std::string& asking_file) const {
  namespace fs = std::filesystem;
  const fs::path beside_asking = fs::path(asking_file).parent_path();
  std::vector<fs::path> folders(folders_.begin(), folders_.end());
  folders.push_back(beside_asking);
  folders.push_back(fs::path(main_file_).parent_path());
  folders.emplace_back();  // The current folder.
  const auto existing = [&](std::string_view spelling) -> std::optional<std::string> {
    std::error_code ignored;
    for (const fs::path& folder : folders)
      if (fs::exists(folder / spelling, ignored)) return (folder / spelling).lexically_normal().string();
    return std::nullopt;
  };
  if (const auto path = existing(name)) return *path;
  std::string slashed(name);
  std::ranges::replace(slashed, '\\', '/');
  if (slashed != name)
    if (const auto path = existing(slashed)) return *path;
  return (beside_asking / name).lexically_normal().string();
}

}  // namespace strahl

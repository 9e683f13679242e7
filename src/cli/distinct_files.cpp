// SPDX-License-Identifier: MIT
// POSIX: device and inode say what a file is.
#include "cli/distinct_files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "errors.h"

namespace strahl::cli {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // As Linux follows.

/// Where a file of this name is or would be made: links followed, the last one too where it leads to nothing yet.
fs::path place_of(fs::path path) {
  std::error_code fault;
  for (int link = 0; link < most_links; ++link) {
    fs::path there = fs::canonical(path, fault);
    if (!fault) return there;
    const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const fs::path folder = fs::weakly_canonical(parent, fault);
    if (fault) return path;
    path = folder / path.filename();
    const fs::path target = fs::read_symlink(path, fault);
    if (fault) return path;
    path = target.is_absolute() ? target : folder / target;
  }
  return path;
}

/// What tells one file from another.
struct Identity {
  std::string place;                                ///< Empty for standard output.
  std::optional<std::pair<dev_t, ino_t>> existing;  ///< Of a file that is there.

  [[nodiscard]] bool is(const Identity& other) const {
    if (existing && other.existing && *existing == *other.existing) return !place.empty() || !other.place.empty();
    return !place.empty() && place == other.place;
  }
};

/// None for what can take two texts one after the other: a pipe, a terminal, a device.
std::optional<Identity> identity_of(const std::string& path) {
  struct stat status {};
  if (path.empty()) return std::nullopt;
  const bool is_stream = path == "-";
  const bool is_there = (is_stream ? fstat(STDOUT_FILENO, &status) : stat(path.c_str(), &status)) == 0;
  if (is_there && !S_ISREG(status.st_mode)) return std::nullopt;
  Identity identity;
  if (!is_stream) identity.place = place_of(path).string();
  if (is_there) identity.existing = {status.st_dev, status.st_ino};
  return identity;
}

struct IdentifiedFile {
  const NamedFile* file;
  Identity identity;
};

std::vector<IdentifiedFile> identified(const std::vector<NamedFile>& files) {
  std::vector<IdentifiedFile> all;
  for (const NamedFile& file : files)
    if (std::optional<Identity> identity = identity_of(file.path)) all.push_back({&file, std::move(*identity)});
  return all;
}

}  // namespace

void require_distinct(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs) {
  const std::vector<IdentifiedFile> written = identified(outputs), read = identified(inputs);
  for (std::size_t i = 0; i < written.size(); ++i) {
    const auto& [file, identity] = written[i];
    for (std::size_t j = 0; j < i; ++j)
      if (identity.is(written[j].identity))
        throw UsageError(fmt::format("{} and {} are one file, \"{}\"; give each a name of its own",
                                     written[j].file->name, file->name, file->path));
    for (const IdentifiedFile& input : read)
      if (identity.is(input.identity))
        throw UsageError(fmt::format("{} would be written over {}, \"{}\"; choose another name", file->name,
                                     input.file->name, input.file->path));
  }
}

std::vector<NamedFile> scene_files(const std::string& scene, const std::vector<std::string>& files) {
  std::vector<NamedFile> named{{"the scene", scene}};
  for (const std::string& file : files)
    if (file != scene) named.push_back({"a file of the scene", file});
  return named;
}

}  // namespace strahl::cli

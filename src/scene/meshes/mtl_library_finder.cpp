// SPDX-License-Identifier: MIT
// Splits an mtllib line into file names by looking which of them exist.
#include "scene/meshes/mtl_library_finder.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>

namespace strahl {
namespace {

constexpr std::size_t most_words_in_a_name = 16;  // keeps a line of many words from asking for many^2 files

std::string with_plain_blanks(const std::string& name) {
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name.compare(i, 2, "\\ ") != 0) plain += name[i];
  return plain;
}

std::optional<std::string> existing_file(const std::filesystem::path& folder, const std::string& name) {
  std::string plain = with_plain_blanks(name);
  if (plain.find('\0') != std::string::npos) return std::nullopt;
  std::string slashed = plain;
  std::ranges::replace(slashed, '\\', '/');
  for (const std::string& candidate : {plain, slashed}) {
    const std::filesystem::path path = folder / candidate;
    std::error_code code;
    if (std::filesystem::is_regular_file(path, code)) return path.string();
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> MtlLibraryFinder::read(const std::string& obj_path, const std::string& names,
                                                MtlLibrary& library) {
  const std::filesystem::path folder = std::filesystem::path(obj_path).parent_path();
  std::vector<std::string> words, missing;
  std::istringstream stream(names);
  for (std::string word; stream >> word;) {
    // Words that end in a backslash were one name in any case.
    if (!words.empty() && words.back().ends_with('\\'))
      words.back().append(" ").append(word);
    else
      words.push_back(word);
  }
  for (std::size_t i = 0; i < words.size();) {
    std::optional<std::string> file;
    std::size_t n = std::min(words.size() - i, most_words_in_a_name);
    for (; n > 0; --n) {
      std::string name = words[i];
      for (std::size_t k = 1; k < n; ++k) name += ' ' + words[i + k];
      if ((file = existing_file(folder, name))) break;
    }
    if (!file) {
      missing.push_back(with_plain_blanks(words[i]));
    } else if (done_.insert(*file).second) {
      try {
        read_mtl(*file, library);
      } catch (const SceneError& fault) {  // Of no matter to shapes that have a material of their own.
        library.diagnostics.insert(library.diagnostics.end(), fault.diagnostics().begin(), fault.diagnostics().end());
      }
    }
    i += std::max<std::size_t>(n, 1);
  }
  if (words.empty()) missing.emplace_back();
  return missing;
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// Reading a mesh file in one go; diagnostics with line and column counted on demand.
#include "scene/meshes/mesh_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "image/file_bytes.h"
#include "scene/meshes/mesh_file.h"

namespace strahl {
namespace {

constexpr std::ptrdiff_t bytes_between_reports = 1 << 20;

}  // namespace

MeshSource::MeshSource(const std::string& path, std::function<void(double share)> progress, FileRange range)
    : path_(path), progress_(std::move(progress)), from_(range.from) {
  const std::string obstacle = unreadable_because(path);
  if (!obstacle.empty()) fail(nullptr, "cannot be read: " + obstacle);
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code))
    fail(nullptr, "cannot be read: it is a pipe, and a mesh is read in parts; write it to a file first");
  std::ifstream file(path, std::ios::binary);
  const auto file_size = std::filesystem::file_size(path, code);
  if (!file || code) fail(nullptr, fmt::format("cannot be read: {}", code ? code.message() : std::strerror(errno)));
  const auto size = static_cast<std::size_t>(std::min(range.size, file_size - std::min(file_size, from_)));
  file.seekg(static_cast<std::streamoff>(from_));
  bytes_ = std::make_unique_for_overwrite<char[]>(size);
  if (!file.read(bytes_.get(), static_cast<std::streamsize>(size))) fail(nullptr, "cannot be read to its end");
  size_ = size;
  begin_pass(0, 1);
}

void MeshSource::begin_pass(double from, double to) {
  pass_from_ = from, pass_to_ = to;
  next_report_ = begin() + std::min(bytes_between_reports, end() - begin());
}

void MeshSource::report(const char* at) {
  if (progress_ && end() - begin() > bytes_between_reports)
    progress_(pass_from_ + (pass_to_ - pass_from_) * static_cast<double>(at - begin()) / static_cast<double>(size_));
  next_report_ = at + std::min(bytes_between_reports, end() - at);
}

const char* MeshSource::begin_text() {
  const std::string_view text(begin(), size_);
  const bool marked = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  const bool unmarked = text.size() >= 2 && (text[0] == '\0') != (text[1] == '\0');
  if (marked || unmarked) {
    fail(begin(), fmt::format("the text is UTF-16; convert it to UTF-8, for example with iconv -f UTF-16 -t UTF-8 {}",
                              std::filesystem::path(path_).filename().string()));
  }
  if (text.find('\n') == std::string_view::npos) unify_line_ends(size_);
  return begin() + (text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
}

void MeshSource::unify_line_ends(std::size_t size) { std::replace(bytes_.get(), bytes_.get() + size, '\r', '\n'); }

void MeshSource::error(const char* at, std::string message) {
  if (++errors_ <= most_listed) notes_.push_back({at, Severity::error, std::move(message)});
}

void MeshSource::warn(const char* at, std::string message) {
  if (++warnings_ <= most_listed) notes_.push_back({at, Severity::warning, std::move(message)});
}

void MeshSource::fail(const char* at, std::string message) {
  error(at, std::move(message));
  throw SceneError(finish());
}

int MeshSource::line(const char* at) const { return 1 + static_cast<int>(std::count(begin(), at, '\n')); }

Diagnostic MeshSource::diagnostic(const Note& note) const {
  if (note.at == nullptr) return {note.severity, {path_}, note.message};
  if (is_binary(note.at)) {
    return {note.severity,
            {path_},
            fmt::format("byte {}: {}", static_cast<std::uint64_t>(note.at - begin()) + from_, note.message)};
  }
  return {note.severity, place(note.at), note.message};
}

SourceLocation MeshSource::place(const char* at) const { return places({&at, 1}).front(); }

std::vector<SourceLocation> MeshSource::places(std::span<const char* const> at) const {
  std::vector<SourceLocation> places;
  const char* counted = begin();
  int row = 1;
  for (const char* place : at) {
    row += static_cast<int>(std::count(counted, place, '\n'));
    counted = place;
    const char* line_begin = place;
    while (line_begin > begin() && line_begin[-1] != '\n') --line_begin;
    places.push_back({path_, row, 1 + static_cast<int>(place - line_begin)});
  }
  return places;
}

std::vector<Diagnostic> MeshSource::all() const {
  std::vector<Note> notes = notes_;
  std::ranges::stable_sort(notes, {}, [&](const Note& n) { return n.at == nullptr ? end() + 1 : n.at; });
  std::vector<Diagnostic> all;
  for (const Note& note : notes) all.push_back(diagnostic(note));
  if (warnings_ > most_listed) {
    all.push_back(
        {Severity::warning, {path_}, fmt::format("{} more warnings are not listed", warnings_ - most_listed)});
  }
  if (errors_ > most_listed) {
    all.push_back({Severity::error, {path_}, fmt::format("{} more errors are not listed", errors_ - most_listed)});
  }
  return all;
}

void MeshSource::error_of_empty_mesh(const char* at) {
  is_empty_mesh_ = errors_ == 0;
  error(at, "mesh without triangles; give it at least one face with an area");
}

std::vector<Diagnostic> MeshSource::finish() const {
  std::vector<Diagnostic> all = this->all();
  if (is_empty_mesh_ && errors_ == 1) throw EmptyMeshError(std::move(all));
  if (has_errors()) throw SceneError(std::move(all));
  return all;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string shown(text.substr(0, most));
  std::ranges::replace_if(
      shown, [](char c) { return (c >= '\0' && c < ' ') || c == '\x7F'; }, '?');
  return fmt::format("\"{}{}\"", shown, text.size() > most ? "..." : "");
}

bool BadNumbers::check(std::size_t index, const char* user, MeshSource& source) {
  if (entries_.empty()) return false;
  const auto entry = std::ranges::lower_bound(entries_, index, {}, &Entry::index);
  if (entry == entries_.end() || entry->index != index) return false;
  if (!entry->used) {
    entry->used = true;
    // Lines are counted from the top of the file: not worth it for what is not listed.
    const int line = source.is_binary(user) || !source.lists_more_errors() ? 0 : source.line(user);
    source.error(entry->at, fmt::format("{} {} is not made of finite numbers, and {} uses it", noun_, index + 1,
                                        line == 0 ? "a face" : fmt::format("the face in line {}", line)));
  }
  return true;
}

void BadNumbers::warn_unused(MeshSource& source) const {
  Tally unused;
  for (const Entry& entry : entries_) {
    if (!entry.used) unused.add(entry.at);
  }
  if (unused.count > 0) {
    source.warn(unused.first, fmt::format("{} not made of finite numbers: {} that no face uses (this is the first)",
                                          noun_, unused.count));
  }
}

}  // namespace strahl

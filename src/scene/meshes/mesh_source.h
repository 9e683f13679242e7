// SPDX-License-Identifier: MIT
// The bytes of a mesh file, read at once, and what there is to say about them.
//
// Places are plain pointers into the bytes; line and column are counted only when something is reported, so parsing
// pays nothing for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "errors.h"

namespace strahl {

/// So many bytes of a file from one on; all that there are.
struct FileRange {
  std::uint64_t from = 0, size = std::numeric_limits<std::uint64_t>::max();
};

/// Contents of a file and the diagnostics that point into them.
class MeshSource {
 public:
  /// Throws SceneError where the file cannot be read.
  explicit MeshSource(const std::string& path, std::function<void(double share)> progress = {}, FileRange range = {});
  MeshSource(const MeshSource&) = delete;
  MeshSource& operator=(const MeshSource&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const char* begin() const { return bytes_.get(); }
  [[nodiscard]] const char* end() const { return bytes_.get() + size_; }

  /// Skips a UTF-8 byte order mark and turns the line ends of old Macs (CR alone) into LF; throws SceneError where
  /// the text is UTF-16. Returns where the text begins.
  const char* begin_text();
  /// The same for the part of a PLY file that is text: the first `size` bytes, whose lines end in CR alone.
  void unify_line_ends(std::size_t size);
  /// From here on the file is binary: places are named by byte offset.
  void begin_binary(const char* at) { binary_ = at; }
  [[nodiscard]] bool is_binary(const char* at) const { return binary_ != nullptr && at >= binary_; }

  /// What passed() reports from here on lies between these shares.
  void begin_pass(double from, double to);
  /// Parsing has come to this place; to be called often.
  void passed(const char* at) {
    if (at >= next_report_) report(at);
  }

  /// Of a place, not kept with the others.
  [[nodiscard]] Diagnostic warning_at(const char* at, std::string message) const {
    return diagnostic({at, Severity::warning, std::move(message)});
  }
  [[nodiscard]] Diagnostic error_at(const char* at, std::string message) const {
    return diagnostic({at, Severity::error, std::move(message)});
  }
  /// `at` may be null: the file as a whole. After `most_listed` errors or warnings the rest is only counted.
  void error(const char* at, std::string message);
  void warn(const char* at, std::string message);
  /// The error of a mesh without triangles.
  void error_of_empty_mesh(const char* at);
  /// Reports an error that makes the rest unreadable.
  [[noreturn]] void fail(const char* at, std::string message);

  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] bool lists_more_errors() const { return errors_ < most_listed; }
  /// Line of a place in the text part.
  [[nodiscard]] int line(const char* at) const;
  [[nodiscard]] SourceLocation place(const char* at) const;
  /// Of places in ascending order, with one look at the text.
  [[nodiscard]] std::vector<SourceLocation> places(std::span<const char* const> at) const;
  /// Everything reported, in file order.
  [[nodiscard]] std::vector<Diagnostic> all() const;
  /// The same; thrown as SceneError where there is an error in it, as EmptyMeshError where that is the only one.
  [[nodiscard]] std::vector<Diagnostic> finish() const;

  static constexpr std::size_t most_listed = 20;

 private:
  struct Note {
    const char* at;
    Severity severity;
    std::string message;
  };
  [[nodiscard]] Diagnostic diagnostic(const Note& note) const;
  void report(const char* at);

  std::string path_;
  std::function<void(double share)> progress_;
  const char* next_report_ = nullptr;
  double pass_from_ = 0, pass_to_ = 1;
  std::unique_ptr<char[]> bytes_;  // not cleared before it is read into
  std::size_t size_ = 0;
  std::uint64_t from_ = 0;  // where in the file they begin
  const char* binary_ = nullptr;
  std::vector<Note> notes_;
  std::size_t errors_ = 0, warnings_ = 0;
  bool is_empty_mesh_ = false;
};

/// Text of a file in quotation marks, fit to be shown: cut to 40 characters, control characters as '?'.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Something that is warned of once, with its count and its first place.
struct Tally {
  const char* first = nullptr;
  std::size_t count = 0;
  void add(const char* at) {
    if (count++ == 0) first = at;
  }
};

/// Numbers of a file that are not finite or not numbers at all. A face that uses one is an error; unused ones are a
/// warning.
class BadNumbers {
 public:
  /// `noun` names what holds the number: "vertex".
  explicit BadNumbers(std::string noun) : noun_(std::move(noun)) {}
  /// Indices arrive in ascending order, counted from 0; `at` is the number or the line that lacks it.
  void add(std::size_t index, const char* at) { entries_.push_back({index, at, false}); }
  /// True, and an error at the number's place (once), where `index` is unusable. `user` is the face.
  [[nodiscard]] bool check(std::size_t index, const char* user, MeshSource& source);
  void warn_unused(MeshSource& source) const;

 private:
  struct Entry {
    std::size_t index;
    const char* at;
    bool used;
  };
  std::string noun_;
  std::vector<Entry> entries_;
};

}  // namespace strahl

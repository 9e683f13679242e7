// SPDX-License-Identifier: MIT
// An output file that is complete or absent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace strahl {

/// Writes to a temporary name in the target's folder; commit() renames it to the target, and without commit() the
/// destructor removes it, so that a failure leaves an older file as it was. What writers that were killed left in the
/// folder is removed. A symbolic link is followed. A device, a pipe or an open file without a name cannot be replaced
/// and is written to directly. All members throw Error with cause and remedy.
class AtomicFile {
 public:
  /// Creates the temporary file: what can be known to fail, fails here.
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, std::size_t size);
  void write(const std::string& bytes) { write(bytes.data(), bytes.size()); }
  /// false: a pipe, a terminal or what was open already, whose bytes must come in their order.
  [[nodiscard]] bool can_seek() const;
  void seek(std::uint64_t position);
  [[nodiscard]] std::uint64_t tell();
  /// Once, after the last write. Fails if any earlier call failed, even if somebody swallowed that exception. Where
  /// only the target cannot be replaced, the complete file stays under another name, which the message states.
  void commit();
  /// The same, and it outlives a power failure: file and folder are flushed to the disk before it returns.
  void commit_to_disk();

 private:
  [[noreturn]] void fail(int error, const std::string& what_is_left = {});
  void put(std::string_view bytes);
  void flush_buffer();
  void flush_folder();
  [[nodiscard]] std::string set_aside();

  std::string path_;       // As the user named it.
  std::string target_;     // The same with a symbolic link resolved.
  std::string temporary_;  // Empty where target_ is written to directly.
  int descriptor_ = -1;
  bool begins_anew_ = true;  // false: something may be in the file already.
  std::string buffer_;       // Behind what is in the file.
  int failure_ = 0;          // The first errno.
};

/// Whether the path names a descriptor that this process has open (/dev/stdout, /dev/fd/3, a link to them): what is
/// written there comes behind what is there.
[[nodiscard]] bool is_open_already(const std::string& path);

}  // namespace strahl

// SPDX-License-Identifier: MIT
// POSIX: rename() replaces its target in one step as long as both names are in one file system, hence in one folder.
// commit() promises that no other process sees half a file, not that it outlives a power failure: flushing takes
// milliseconds, and a picture can be rendered again.
#include "image/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "errors.h"
#include "image/temporary_file.h"
#include "write_all.h"

namespace strahl {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 16;

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// A mount point cannot be replaced. Where the system does not say what is one, commit() finds out.
bool is_mount_point(const std::string& path) {
#ifdef STATX_ATTR_MOUNT_ROOT
  struct statx status {};
  return ::statx(AT_FDCWD, path.c_str(), AT_SYMLINK_NOFOLLOW, STATX_TYPE, &status) == 0 &&
         (status.stx_attributes & status.stx_attributes_mask & STATX_ATTR_MOUNT_ROOT) != 0;
#else
  static_cast<void>(path);
  return false;
#endif
}

/// In a folder as /tmp only its owner, the file's and root rename or replace a file, whoever may write to it.
bool is_kept_by_sticky_folder(const std::string& path) {
  struct stat folder {
  }, file{};
  const uid_t user = ::geteuid();
  return user != 0 && ::stat(folder_of(path).c_str(), &folder) == 0 && (folder.st_mode & S_ISVTX) != 0 &&
         ::stat(path.c_str(), &file) == 0 && folder.st_uid != user && file.st_uid != user;
}

/// Why a file that is there, and may be written to, cannot be replaced; empty where nothing is known against it.
std::string irreplaceable_because(const std::string& path) {
  if (is_mount_point(path)) return "it is a mount point, which cannot be replaced; mount its folder, or name another";
  if (is_kept_by_sticky_folder(path))
    return "it belongs to another user, in a folder whose files their owners alone replace (sticky); name another";
  return {};
}

std::string cause_and_remedy(const std::string& path, int error) {
  const std::string folder = folder_of(path);
  switch (error) {
    case ENOENT:
      return fmt::format("the folder \"{}\" does not exist; create it first", folder);
    case ENOTDIR:
      return fmt::format("\"{}\" is not a folder", folder);
    case EISDIR:
      return "it is a folder; name a file";
    case EACCES:
    case EPERM:
    case EROFS:
      return fmt::format("no permission to write here ({}); choose another folder", std::strerror(error));
    case ENOSPC:
    case EDQUOT:
      return fmt::format("the disk is full ({}); free some space or choose another folder", std::strerror(error));
    default:
      return std::strerror(error);
  }
}

/// Where a link leads that has no file yet: somebody has made it for one that is to come.
std::string end_of_links(fs::path path) {
  std::error_code unknown;
  constexpr int most_links = 40;  // As the system.
  for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, unknown)); ++i)
    path = path.parent_path() / fs::read_symlink(path, unknown);
  return path.string();
}

/// The open descriptor of this process that a path names (/dev/stdout, /dev/fd/3, a link to them); else -1.
int own_descriptor(fs::path path) {
  std::error_code unknown;
  const fs::path descriptors = fs::canonical("/proc/self/fd", unknown);
  if (unknown) return -1;
  constexpr int most_links = 40;  // As the system.
  for (int i = 0; i < most_links; ++i) {
    const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : fs::path("."), unknown);
    if (unknown) return -1;
    if (folder == descriptors) {
      const std::string name = path.filename().string();
      int number = -1;
      const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
      return error == std::errc() && end == name.data() + name.size() ? number : -1;
    }
    if (!fs::is_symlink(fs::symlink_status(path, unknown))) return -1;
    path = folder / fs::read_symlink(path, unknown);
  }
  return -1;
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (path.empty()) throw Error("cannot write to a file without a name");
  if (fs::is_directory(status)) fail(EISDIR);
  // What is open already is written on: opened anew, a file that others append to would begin anew.
  if (const int open = own_descriptor(path); open >= 0) {
    if ((::fcntl(open, F_GETFL) & O_ACCMODE) == O_RDONLY)
      throw Error(fmt::format("cannot write \"{}\": it is not open for writing", path_));
    descriptor_ = ::fcntl(open, F_DUPFD_CLOEXEC, 0);
    if (descriptor_ < 0) fail(errno);
    begins_anew_ = false;
    return;
  }
  bool replaces = fs::is_regular_file(status);
  if (fs::exists(status)) {
    // rename() would replace a write-protected file without asking.
    if (::access(path.c_str(), W_OK) != 0) fail(errno);
    // What another process's descriptor leads to may be a file that was removed: it has no name that it could be
    // replaced under.
    if (replaces) {
      const fs::path named = fs::canonical(path, unknown);
      if (unknown && unknown != std::errc::no_such_file_or_directory) fail(unknown.value());
      replaces = !unknown;
      if (replaces) target_ = named.string();
    }
    if (!replaces) {
      descriptor_ = ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
      if (descriptor_ < 0) fail(errno);
      return;
    }
    if (const std::string why = irreplaceable_because(target_); !why.empty())
      throw Error(fmt::format("cannot write \"{}\": {}", path_, why));
  } else {
    target_ = end_of_links(path);
    if (fs::is_symlink(fs::symlink_status(target_, unknown))) fail(ELOOP);
  }

  remove_abandoned_files(folder_of(target_));
  const TemporaryFile file = make_temporary_file(folder_of(target_));
  if (file.descriptor < 0) fail(file.error);
  temporary_ = file.path;
  descriptor_ = file.descriptor;
  if (!replaces || ::fchmod(descriptor_, static_cast<mode_t>(status.permissions()) & 07777) == 0) return;
  const int error = errno;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
  fail(error);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::put(std::string_view bytes) {
  if (const int error = write_all(descriptor_, bytes); error != 0) fail(error);
}

void AtomicFile::flush_buffer() {
  put(buffer_);
  buffer_.clear();
}

void AtomicFile::write(const void* data, std::size_t size) {
  const std::string_view bytes(static_cast<const char*>(data), size);
  if (buffer_.size() + size > buffer_bytes) flush_buffer();
  if (size > buffer_bytes)
    put(bytes);
  else
    buffer_.append(bytes);
}

bool AtomicFile::can_seek() const { return begins_anew_ && ::lseek(descriptor_, 0, SEEK_CUR) >= 0; }

void AtomicFile::seek(std::uint64_t position) {
  flush_buffer();
  if (::lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail(errno);
}

std::uint64_t AtomicFile::tell() {
  const off_t position = ::lseek(descriptor_, 0, SEEK_CUR);
  if (position < 0) fail(errno);
  return static_cast<std::uint64_t>(position) + buffer_.size();
}

void AtomicFile::commit() {
  if (failure_ != 0) fail(failure_);
  flush_buffer();
  // Its lock holds until it has its name; else another process might take it for abandoned.
  const int lock = temporary_.empty() ? -1 : ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  const int descriptor = descriptor_;
  descriptor_ = -1;
  int error = ::close(descriptor) == 0 ? 0 : errno;
  std::string aside;
  if (error == 0 && !temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    error = errno;
    aside = set_aside();
  }
  if (lock >= 0) ::close(lock);
  if (error != 0) fail(error, aside);
  temporary_.clear();
}

/// The file is complete, and may be hours of work: it stays under another name, which is returned with what is to be
/// said of it. The name is of the target and of this process, so that what fails again and again leaves one.
std::string AtomicFile::set_aside() {
  constexpr std::size_t most_letters = 200;  // Of the 255 that a name may have.
  const fs::path target(target_);
  const std::string name = fmt::format("{}.unplaced-{}{}", target.stem().string().substr(0, most_letters), ::getpid(),
                                       target.extension().string());
  const std::string aside = (target.parent_path() / name).string();
  const std::string temporary = std::exchange(temporary_, {});
  if (std::rename(temporary.c_str(), aside.c_str()) == 0) return fmt::format("; the complete file is \"{}\"", aside);
  if (::access(temporary.c_str(), F_OK) != 0) return {};
  return fmt::format("; the complete file is \"{}\" until strahl next writes to that folder", temporary);
}

void AtomicFile::commit_to_disk() {
  if (failure_ != 0) fail(failure_);
  flush_buffer();
  // Pipes and some devices have nothing to flush.
  if (::fsync(descriptor_) != 0 && (!temporary_.empty() || errno != EINVAL)) fail(errno);
  // Nobody reads it soon, and the next one can have its pages. A virtual machine gets fresh ones from its host, which
  // takes several times as long as it takes to fill them.
  static_cast<void>(::posix_fadvise(descriptor_, 0, 0, POSIX_FADV_DONTNEED));
  const bool is_renamed = !temporary_.empty();
  commit();
  if (is_renamed) flush_folder();
}

void AtomicFile::flush_folder() {
  const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) fail(errno);
  const int error = ::fsync(folder) == 0 || errno == EINVAL ? 0 : errno;  // Some file systems cannot.
  ::close(folder);
  if (error != 0) fail(error);
}

bool is_open_already(const std::string& path) { return own_descriptor(path) >= 0; }

void AtomicFile::fail(int error, const std::string& what_is_left) {
  if (failure_ == 0) failure_ = error;
  throw Error(fmt::format("cannot write \"{}\": {}{}", path_, cause_and_remedy(target_, failure_), what_is_left));
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// POSIX: rename() replaces its target in one step as long as both names are in one file system, hence in one folder.
// commit() promises that no other process sees half a file, not that it outlives a power failure: flushing takes
// milliseconds, and a picture can be rendered again.
#include "image/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "errors.h"

namespace strahl {
namespace fs = std::filesystem;

namespace {

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
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

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (path.empty()) throw Error("cannot write to a file without a name");
  if (fs::is_directory(status)) fail(EISDIR);
  const bool replaces = fs::is_regular_file(status);
  if (fs::exists(status)) {
    // rename() would replace a write-protected file without asking.
    if (::access(path.c_str(), W_OK) != 0) fail(errno);
    target_ = fs::canonical(path, unknown).string();
    if (unknown) fail(unknown.value());
    if (!replaces) {
      file_ = std::fopen(target_.c_str(), "wb");
      if (!file_) fail(errno);
      return;
    }
  }

  // The name is free of the target's, which may already be as long as a name can be.
  static std::atomic<unsigned> counter{0};
  int descriptor = -1;
  do {
    temporary_ = (fs::path(folder_of(target_)) / fmt::format(".strahl-{}-{}.tmp", ::getpid(), counter++)).string();
    descriptor = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor < 0 && errno == EEXIST);
  if (descriptor < 0) {
    const int error = errno;
    temporary_.clear();
    fail(error);
  }
  int error = replaces && ::fchmod(descriptor, static_cast<mode_t>(status.permissions()) & 07777) != 0 ? errno : 0;
  if (error == 0) {
    file_ = ::fdopen(descriptor, "wb");
    if (file_) return;
    error = errno;
  }
  ::close(descriptor);
  ::unlink(temporary_.c_str());
  fail(error);
}

AtomicFile::~AtomicFile() {
  if (file_) std::fclose(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(const void* data, std::size_t size) {
  if (size != 0 && std::fwrite(data, 1, size, file_) != size) fail(errno);
}

void AtomicFile::seek(std::uint64_t position) {
  if (::fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0) fail(errno);
}

std::uint64_t AtomicFile::tell() {
  const off_t position = ::ftello(file_);
  if (position < 0) fail(errno);
  return static_cast<std::uint64_t>(position);
}

void AtomicFile::commit() {
  if (failure_ != 0) fail(failure_);
  std::FILE* file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail(errno);
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void AtomicFile::commit_to_disk() {
  if (failure_ == 0 && (std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0)) {
    // Pipes and some devices have nothing to flush.
    if (!temporary_.empty() || errno != EINVAL) fail(errno);
  }
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

void AtomicFile::fail(int error) {
  if (failure_ == 0) failure_ = error;
  throw Error(fmt::format("cannot write \"{}\": {}", path_, cause_and_remedy(path_, failure_)));
}

}  // namespace strahl

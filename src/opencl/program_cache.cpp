// SPDX-License-Identifier: MIT
// Files: magic, key size, binary size, FNV-1a of all that follows, key, binary; integers as this machine has them.
#include "opencl/program_cache.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkstemp, mkstemps
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "opencl/program.h"
#include "write_all.h"

namespace strahl {

namespace {

namespace fs = std::filesystem;

struct Header {
  char magic[8] = {'s', 't', 'r', 'a', 'h', 'l', 'P', '1'};
  std::uint64_t key_size = 0;
  std::uint64_t binary_size = 0;
  std::uint64_t checksum = 0;
};
static_assert(sizeof(Header) == 32);

const char* variable_of(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != 0 ? value : nullptr;
}

/// strahl's own folder in the user's cache; empty where there is none.
std::string own_directory() {
  // A relative XDG_CACHE_HOME is invalid and to be ignored (XDG Base Directory Specification).
  if (const char* cache = variable_of("XDG_CACHE_HOME"); cache != nullptr && *cache == '/') {
    return (fs::path(cache) / "strahl").string();
  }
  if (const char* home = variable_of("HOME")) return (fs::path(home) / ".cache" / "strahl").string();
  return {};
}

std::string named_directory() {
  if (const char* directory = variable_of("STRAHL_CACHE_DIR")) return directory;
  return own_directory();
}

/// For its owner alone, whatever the umask; those above it as the umask has it.
void make_directory(const fs::path& directory) {
  std::error_code failed;
  if (!directory.parent_path().empty()) fs::create_directories(directory.parent_path(), failed);
  ::mkdir(directory.c_str(), 0700);
}

constexpr mode_t by_others = S_IWGRP | S_IWOTH;

/// Made under a umask of 002 strahl's own folder is open to a group, as a rule the user's own, and under one of 0 to
/// everyone. Nobody else has a use for it, so it is closed to both; what others have put there is not theirs to be run
/// in any case, for files of others do not count. Not through a link, and not a folder that the user has named, which
/// may have other uses. False: it is as it was.
bool is_closed_now(const std::string& directory) {
  if (variable_of("STRAHL_CACHE_DIR") != nullptr) return false;
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return false;
  struct stat status {};
  const bool is_closed = ::fstat(descriptor, &status) == 0 && status.st_uid == ::geteuid() &&
                         ::fchmod(descriptor, status.st_mode & 07777 & ~by_others) == 0;
  ::close(descriptor);
  return is_closed;
}

fs::path cached_file(const std::string& name, const std::string& key) {
  return fs::path(program_cache_directory()) / fmt::format("{}-{:016x}.program", name, fnv1a(key));
}

constexpr const char* size_variable = "STRAHL_CACHE_MIB";
constexpr std::uintmax_t usual_mebibytes = 512;

/// None where it is no whole number.
std::optional<std::uintmax_t> most_mebibytes() {
  const char* stated = variable_of(size_variable);
  if (stated == nullptr) return usual_mebibytes;
  std::uintmax_t mebibytes = 0;
  const auto [end, error] = std::from_chars(stated, stated + std::strlen(stated), mebibytes);
  if (error != std::errc() || *end != 0) return std::nullopt;
  return mebibytes;
}

std::uintmax_t most_bytes() {
  constexpr std::uintmax_t mebibyte = 1 << 20;
  return std::min(most_mebibytes().value_or(usual_mebibytes), UINTMAX_MAX / mebibyte) * mebibyte;
}

/// Until what is left fits; `newest` stays. Another process may remove files at the same time.
void remove_unused(const fs::path& newest) {
  struct Entry {
    fs::path path;
    fs::file_time_type used;
    std::uintmax_t bytes;
  };
  std::vector<Entry> entries;
  std::uintmax_t bytes = 0;
  std::error_code failed;
  for (fs::directory_iterator at(newest.parent_path(), failed), end; !failed && at != end; at.increment(failed)) {
    const std::string name = at->path().filename().string();
    // What a writer that was killed left behind counts too: its turn comes.
    if (name.find(".program") == std::string::npos) continue;
    std::error_code gone;
    Entry entry{at->path(), at->last_write_time(gone), 0};
    if (!gone) entry.bytes = at->file_size(gone);
    if (gone) continue;
    bytes += entry.bytes;
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
  for (const Entry& entry : entries) {
    if (bytes <= most_bytes()) return;
    if (entry.path == newest) continue;
    fs::remove(entry.path, failed);
    bytes -= entry.bytes;
  }
}

}  // namespace

std::string program_cache_fault() {
  const std::string directory = named_directory();
  struct stat status {};
  if (directory.empty() || ::stat(directory.c_str(), &status) != 0) return {};
  const bool is_ours = status.st_uid == ::geteuid() || status.st_uid == 0;
  if (is_ours && ((status.st_mode & by_others) == 0 || is_closed_now(directory))) return {};
  const char* remedy = is_ours ? "chmod go-w it" : "it belongs to another user";
  return fmt::format(
      "the program cache \"{}\" is not used, because others can write to it: {}, or name another folder "
      "with STRAHL_CACHE_DIR",
      directory, remedy);
}

std::string program_cache_size_fault() {
  if (most_mebibytes()) return {};
  return fmt::format("{} is \"{}\", which is no whole number of MiB: the program cache holds {} MiB", size_variable,
                     variable_of(size_variable), usual_mebibytes);
}

std::string program_cache_directory() { return program_cache_fault().empty() ? named_directory() : std::string(); }

std::vector<unsigned char> read_cached_binary(const std::string& name, const std::string& key) {
  if (program_cache_directory().empty()) return {};
  const fs::path file = cached_file(name, key);
  struct stat status {};
  if (::lstat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_uid != ::geteuid()) return {};
  std::ifstream in(file, std::ios::binary);
  Header header;
  if (!in.read(reinterpret_cast<char*>(&header), sizeof header)) return {};
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (std::memcmp(header.magic, Header().magic, sizeof header.magic) != 0 || header.key_size != key.size() ||
      size < sizeof header + key.size() || header.binary_size != size - sizeof header - key.size()) {
    return {};
  }
  std::string found(key.size(), 0);
  std::vector<unsigned char> binary(header.binary_size);
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  in.read(reinterpret_cast<char*>(binary.data()), static_cast<std::streamsize>(binary.size()));
  const std::string_view bytes(reinterpret_cast<const char*>(binary.data()), binary.size());
  if (!in || found != key || header.checksum != fnv1a(bytes, fnv1a(key))) return {};
  ::utimensat(AT_FDCWD, file.c_str(), nullptr, 0);  // Used now, for remove_unused().
  return binary;
}

bool write_cached_binary(const std::string& name, const std::string& key, const std::vector<unsigned char>& binary) {
  if (program_cache_directory().empty() || binary.empty()) return false;
  const fs::path file = cached_file(name, key);
  std::error_code failed;
  make_directory(file.parent_path());
  std::string temporary = file.string() + ".XXXXXX";
  const int descriptor = mkstemp(temporary.data());
  if (descriptor < 0) return false;
  close(descriptor);

  std::string payload = key;
  payload.append(binary.begin(), binary.end());
  Header header;
  header.key_size = key.size();
  header.binary_size = binary.size();
  header.checksum = fnv1a(payload);
  std::ofstream out(temporary, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&header), sizeof header);
  out.write(payload.data(), static_cast<std::streamsize>(payload.size()));
  out.close();
  if (out) fs::rename(temporary, file, failed);
  const bool is_stored = out && !failed;
  if (!is_stored) fs::remove(temporary, failed);
  remove_unused(file);
  return is_stored;
}

std::string keep_failed_program(const std::string& name, const std::string& text) {
  constexpr std::string_view ending = ".failed.cl";
  const fs::path cache = program_cache_directory();
  if (!cache.empty()) make_directory(cache);
  std::string path;
  int descriptor = -1;
  if (!cache.empty() && access(cache.c_str(), W_OK) == 0) {
    path = (cache / (name + std::string(ending))).string();
    descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0600);
  } else {
    std::error_code failed;
    const fs::path temporary = fs::temp_directory_path(failed);
    if (failed) return fmt::format("nowhere: neither the program cache nor TMPDIR can be used ({})", failed.message());
    path = (temporary / (name + "-XXXXXX" + std::string(ending))).string();
    descriptor = ::mkstemps(path.data(), static_cast<int>(ending.size()));
  }
  const int error = descriptor < 0 ? errno : write_all(descriptor, text);
  if (descriptor >= 0) ::close(descriptor);
  if (error == 0) return path;
  if (descriptor >= 0) ::unlink(path.c_str());
  return fmt::format("could not be written to {} ({})", path, std::strerror(error));
}

std::size_t clear_program_cache() {
  const fs::path cache = program_cache_directory();
  if (!fs::is_directory(cache)) return 0;
  std::size_t removed = 0;
  try {
    const std::vector<fs::directory_entry> entries(fs::directory_iterator(cache), fs::directory_iterator{});
    for (const fs::directory_entry& entry : entries) {
      const std::string name = entry.path().filename().string();
      const bool is_binary = name.ends_with(".program");
      const bool is_cut_short = name.find(".program.") != std::string::npos;
      if (!is_binary && !is_cut_short && !name.ends_with(".failed.cl")) continue;
      fs::remove(entry.path());
      if (is_binary) ++removed;
    }
  } catch (const fs::filesystem_error& error) {
    throw Error(fmt::format("the program cache cannot be cleared: {}", error.what()));
  }
  return removed;
}

}  // namespace strahl

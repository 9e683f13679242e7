// SPDX-License-Identifier: MIT
// A file ends in a list of where its meshes begin (64 bits each, in version 3: 32) and their number (32 bits). The
// first mesh needs no such list; it begins at 0.
#include "scene/meshes/serialized_part.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <optional>

#include "errors.h"
#include "image/byte_order.h"
#include "image/file_bytes.h"

namespace strahl {
namespace {

constexpr std::uint64_t header_size = 4;

class PartFinder {
 public:
  explicit PartFinder(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    const std::string obstacle = unreadable_because(path);
    if (!obstacle.empty()) fail("cannot be read: " + obstacle);
    std::error_code code;
    size_ = std::filesystem::file_size(path, code);
    if (!file_ || code) fail("cannot be read: " + code.message());
    if (size_ < header_size || read<std::uint16_t>(0) != 0x041C)
      fail("not a file of serialized meshes: it does not begin with the bytes 1C 04");
    version_ = read<std::uint16_t>(2);
    if (version_ != 3 && version_ != 4)
      fail(fmt::format("version {} of serialized meshes is not read, only 3 and 4", version_));
  }

  SerializedPart find(int index) {
    const std::optional<std::uint32_t> count = mesh_count();
    if (!count && index > 0) fail("the list of meshes at the end of the file is damaged; only the first can be read");
    if (!count) return {0, size_, version_};
    if (static_cast<std::uint32_t>(index) >= *count)
      fail(fmt::format("shape_index {} is out of range: the file has {} meshes, counted from 0", index, *count));
    const auto i = static_cast<std::uint32_t>(index);
    const std::uint64_t list = size_ - 4 - *count * entry_size();
    const SerializedPart part{entry(list, i), i + 1 < *count ? entry(list, i + 1) : list, version_};
    if (part.end > list || part.begin > part.end || part.end - part.begin < header_size)
      fail(fmt::format("the list at the end of the file puts mesh {} where no mesh can be", index));
    if (read<std::uint16_t>(part.begin) != 0x041C || read<std::uint16_t>(part.begin + 2) != version_)
      fail(fmt::format("no mesh begins at byte {}, where the list at the end of the file puts mesh {}", part.begin,
                       index));
    return part;
  }

 private:
  [[nodiscard]] std::uint64_t entry_size() const { return version_ == 3 ? 4 : 8; }

  /// None where there is no such list that begins with 0.
  std::optional<std::uint32_t> mesh_count() {
    if (size_ < header_size + 4 + entry_size()) return std::nullopt;
    const auto count = read<std::uint32_t>(size_ - 4);
    if (count == 0 || count > (size_ - header_size - 4) / entry_size()) return std::nullopt;
    if (entry(size_ - 4 - count * entry_size(), 0) != 0) return std::nullopt;
    return count;
  }

  std::uint64_t entry(std::uint64_t list, std::uint32_t i) {
    const std::uint64_t at = list + i * entry_size();
    return version_ == 3 ? read<std::uint32_t>(at) : read<std::uint64_t>(at);
  }

  template <class T>
  T read(std::uint64_t at) {
    std::array<char, sizeof(T)> bytes{};
    file_.seekg(static_cast<std::streamoff>(at));
    if (!file_.read(bytes.data(), bytes.size())) fail("cannot be read to its end");
    return load<T>(bytes.data(), std::endian::little);
  }

  [[noreturn]] void fail(const std::string& message) const { throw SceneError({{Severity::error, {path_}, message}}); }

  std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  int version_ = 4;
};

}  // namespace

SerializedPart find_serialized_part(const std::string& path, int index) { return PartFinder(path).find(index); }

}  // namespace strahl

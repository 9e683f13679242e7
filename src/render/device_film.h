// SPDX-License-Identifier: MIT
// A film that lies on a device: it is cleared there, and the host looks at its words where they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "opencl/device.h"

namespace strahl {

/// Bytes of the film that a device holds at a time. A device that shares the host's memory has all of it where it can,
/// since what bands leave would lie there a second time; not one of several, whose host keeps the film in any case.
[[nodiscard]] std::size_t largest_film_buffer(const DeviceInfo& device, bool is_helper);

/// Sets the buffer's first bytes to 0, in as many commands as the device may run at once: the first touch of new memory
/// takes longer than all else (docs/decisions/0002-film.md). Blocking. Throws DeviceError.
void clear_film(const Device& device, const cl::Buffer& film, std::size_t bytes);

/// A part of the film for the host to read, while this lives. On a CPU it is not copied.
class MappedWords {
 public:
  /// Throws DeviceError.
  MappedWords(const Device& device, const cl::Buffer& film, std::size_t first, std::size_t count);
  ~MappedWords();
  MappedWords(const MappedWords&) = delete;
  MappedWords& operator=(const MappedWords&) = delete;

  [[nodiscard]] std::span<const std::int64_t> words() const { return words_; }

 private:
  cl::CommandQueue queue_;
  cl::Buffer film_;
  std::span<std::int64_t> words_;
};

}  // namespace strahl

// SPDX-License-Identifier: MIT
// A film that lies on a device: it is cleared there, and the host looks at its words where they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <thread>

#include "opencl/device.h"

namespace strahl {

/// Bytes of the film that a device holds at a time. A device that shares the host's memory has all of it where it can,
/// since what bands leave would lie there a second time; not one of several, whose host keeps the film in any case.
[[nodiscard]] std::size_t largest_film_buffer(const DeviceInfo& device, bool is_helper);

/// The film's buffer. The first touch of new memory takes longer than all else (docs/decisions/0002-film.md), so where
/// a processor is the device a thread clears the buffer while the host goes on.
class FilmBuffer {
 public:
  /// A new buffer of the device. ahead: the bytes that are cleared until clear() is called, as far as there is time.
  FilmBuffer(const Device& device, cl::Buffer buffer, std::size_t ahead);
  FilmBuffer(const FilmBuffer&) = delete;
  FilmBuffer& operator=(const FilmBuffer&) = delete;

  [[nodiscard]] const cl::Buffer& buffer() const { return buffer_; }
  /// Sets the first bytes to 0, in as many commands as the device may run at once. Blocking. Throws DeviceError.
  void clear(std::size_t bytes);

 private:
  void clear_ahead(std::size_t bytes, const std::stop_token& stop);

  Device device_;
  cl::Buffer buffer_;
  std::size_t cleared_ = 0;  ///< How far the thread has come.
  std::jthread thread_;      ///< The last: it ends before what it uses.
};

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

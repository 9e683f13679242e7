// SPDX-License-Identifier: MIT
#include "render/device_film.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "errors.h"

namespace strahl {
namespace {

/// Smaller parts take less time than the commands for them.
constexpr std::size_t least_bytes = std::size_t{1} << 20;

/// On a card, and of a helper.
constexpr std::size_t most_bytes = std::size_t{512} << 20;

/// Ahead of the render, between two looks at whether it begins.
constexpr std::size_t bytes_ahead = std::size_t{16} << 20;

/// From `first` to before `end`, multiples of a word.
void clear_bytes(const Device& device, const cl::Buffer& film, std::size_t first, std::size_t end) {
  constexpr std::size_t word = sizeof(cl_long);
  const std::size_t words = (end - first) / word;
  const std::size_t parts = std::clamp<std::size_t>((end - first) / least_bytes, 1, device.info().compute_units);
  checked(device.info().text(), [&] {
    const auto properties = device.device().getInfo<CL_DEVICE_QUEUE_PROPERTIES>();
    const cl::CommandQueue queue(device.context(), device.device(),
                                 properties & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
    for (std::size_t i = 0; i < parts; ++i) {
      const std::size_t from = words * i / parts, to = words * (i + 1) / parts;
      queue.enqueueFillBuffer(film, cl_long{0}, first + from * word, (to - from) * word);
    }
    return queue.finish();
  });
}

}  // namespace

std::size_t largest_film_buffer(const DeviceInfo& device, bool is_helper) {
  if (device.shares_host_memory && !is_helper) return device.max_allocation;
  return std::min<std::size_t>(most_bytes, device.max_allocation);
}

FilmBuffer::FilmBuffer(const Device& device, cl::Buffer buffer, std::size_t ahead)
    : device_(device), buffer_(std::move(buffer)) {
  if (device.info().type != "CPU") return;
  try {
    thread_ = std::jthread([this, ahead](const std::stop_token& stop) { clear_ahead(ahead, stop); });
  } catch (const std::system_error&) {
    // Without a thread clear() does all.
  }
}

void FilmBuffer::clear_ahead(std::size_t bytes, const std::stop_token& stop) {
  try {
    for (std::size_t end; cleared_ < bytes && !stop.stop_requested(); cleared_ = end) {
      end = std::min(cleared_ + bytes_ahead, bytes);
      clear_bytes(device_, buffer_, cleared_, end);
    }
  } catch (const DeviceError&) {
    // clear() does the rest, and says what the device cannot do.
  }
}

void FilmBuffer::clear(std::size_t bytes) {
  thread_ = {};  // Asks it to stop, and waits.
  const std::size_t cleared = std::exchange(cleared_, 0);
  if (cleared < bytes) clear_bytes(device_, buffer_, cleared, bytes);
}

MappedWords::MappedWords(const Device& device, const cl::Buffer& film, std::size_t first, std::size_t count)
    : queue_(device.queue()), film_(film) {
  constexpr std::size_t word = sizeof(std::int64_t);
  void* const at = checked(device.info().text(), [&] {
    return queue_.enqueueMapBuffer(film_, CL_TRUE, CL_MAP_READ, first * word, count * word);
  });
  words_ = {static_cast<std::int64_t*>(at), count};
}

MappedWords::~MappedWords() {
  try {
    queue_.enqueueUnmapMemObject(film_, words_.data());
  } catch (const cl::Error&) {
    // What was read is whole. A device that has failed says so at its next command.
  }
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
#include "render/device_film.h"

#include <algorithm>

namespace strahl {
namespace {

/// Smaller parts take less time than the commands for them.
constexpr std::size_t least_bytes = std::size_t{1} << 20;

/// On a card, and of a helper.
constexpr std::size_t most_bytes = std::size_t{512} << 20;

}  // namespace

std::size_t largest_film_buffer(const DeviceInfo& device, bool is_helper) {
  if (device.shares_host_memory && !is_helper) return device.max_allocation;
  return std::min<std::size_t>(most_bytes, device.max_allocation);
}

void clear_film(const Device& device, const cl::Buffer& film, std::size_t bytes) {
  constexpr std::size_t word = sizeof(cl_long);
  const std::size_t words = bytes / word;
  const std::size_t parts = std::clamp<std::size_t>(bytes / least_bytes, 1, device.info().compute_units);
  checked(device.info().text(), [&] {
    const auto properties = device.device().getInfo<CL_DEVICE_QUEUE_PROPERTIES>();
    const cl::CommandQueue queue(device.context(), device.device(),
                                 properties & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
    for (std::size_t i = 0; i < parts; ++i) {
      const std::size_t first = words * i / parts, end = words * (i + 1) / parts;
      queue.enqueueFillBuffer(film, cl_long{0}, first * word, (end - first) * word);
    }
    return queue.finish();
  });
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

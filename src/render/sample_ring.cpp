// SPDX-License-Identifier: MIT
#include "render/sample_ring.h"

#include <algorithm>

#include "packing/cl_layout.h"
#include "packing/scene_buffers.h"

namespace strahl {
namespace {

/// Kernels read as many reals at a time as they have lanes, beyond the last pixel too.
constexpr std::size_t reals_beyond = 16;

constexpr std::size_t cached_bytes = std::size_t{8} << 20;
constexpr std::size_t least_rows = 20;

}  // namespace

SampleRing::SampleRing(const Device& device, int reach, std::size_t real_bytes)
    : device_(device), reach_(reach), real_bytes_(real_bytes) {}

std::size_t SampleRing::row_bytes(const Launch& launch) const {
  const auto columns = static_cast<std::size_t>(launch.columns + 2 * reach_);
  return columns * static_cast<std::size_t>(launch.samples) * layout::RING_PLANES * real_bytes_;
}

/// What a CPU's threads share is best in their caches; but rows that are kept for the next launch should be few of
/// them.
std::size_t SampleRing::rows_of(const Launch& launch, std::size_t memory) const {
  const std::size_t row = std::max<std::size_t>(row_bytes(launch), 1);
  const std::size_t cached = device_.info().type == "CPU" ? std::max(cached_bytes / row, least_rows) : memory / row;
  return std::min(cached, memory / row);
}

std::vector<Launch> SampleRing::parts(const Launch& launch, std::size_t memory) const {
  const std::size_t kept = 2 * static_cast<std::size_t>(reach_), fitting = rows_of(launch, memory);
  if (static_cast<std::size_t>(launch.rows) + kept <= fitting) return {launch};
  std::vector<Launch> all;
  if (fitting > kept) {
    const int rows = static_cast<int>(fitting - kept), end = launch.row_first + launch.rows;
    for (int row = launch.row_first; row < end; row += rows) {
      all.push_back(launch);
      all.back().row_first = row;
      all.back().rows = std::min(rows, end - row);
    }
    return all;
  }
  Launch first = launch, second = launch;
  if (launch.samples > 1) {
    first.samples = launch.samples / 2;
    second.sample_first += first.samples;
    second.samples -= first.samples;
  } else if (launch.columns > 1) {
    first.columns = launch.columns / 2;
    second.column_first += first.columns;
    second.columns -= first.columns;
  } else {
    return {launch};  // A pixel's sample: the device says why it has no room.
  }
  for (const Launch& half : {first, second})
    for (const Launch& part : parts(half, memory)) all.push_back(part);
  return all;
}

bool SampleRing::has_kind_of(const Launch& launch) const {
  return column_first_ == launch.column_first - reach_ && columns_ == launch.columns + 2 * reach_ &&
         sample_first_ == launch.sample_first && samples_ == launch.samples;
}

Launch SampleRing::prepare(const Launch& launch, int film_rows, std::size_t memory) {
  const int first = launch.row_first - reach_, end = launch.row_first + launch.rows + reach_, needed = end - first;
  if (!has_kind_of(launch) || needed > rows_) {
    column_first_ = launch.column_first - reach_;
    columns_ = launch.columns + 2 * reach_;
    sample_first_ = launch.sample_first;
    samples_ = launch.samples;
    const auto all = static_cast<std::size_t>(film_rows + 2 * reach_);
    rows_ = std::max(needed, static_cast<int>(std::min(rows_of(launch, memory), all)));
    first_ = end_ = first;
    const std::size_t bytes = static_cast<std::size_t>(rows_) * row_bytes(launch) + reals_beyond * real_bytes_;
    if (bytes > bytes_) {
      buffer_ = {};  // Before there are two of them.
      bytes_ = 0;
      buffer_ = allocate(device_, bytes, "samples that count in several pixels");
      bytes_ = bytes;
    }
  }
  if (first < first_ || first > end_) first_ = end_ = first;
  first_ = first;
  asked_end_ = std::max(end, end_);
  const int begin = std::max(end_, first);
  return {column_first_, begin, columns_, std::max(end - begin, 0), launch.sample_first, launch.samples};
}

}  // namespace strahl

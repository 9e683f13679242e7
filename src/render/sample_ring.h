// SPDX-License-Identifier: MIT
// Where samples wait that count in several pixels (cl/film/sample_ring.h, docs/decisions/0035-shared-samples.md): rows
// of the film and of what is around it, of one range of samples. What a launch needs and the one before has left there
// is not rendered again.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "opencl/device.h"
#include "render/launch_plan.h"

namespace strahl {

class SampleRing {
 public:
  /// reach: of the filter, in pixels. real_bytes: of the kernels' reals.
  SampleRing(const Device& device, int reach, std::size_t real_bytes);

  /// Parts of a launch whose samples a ring can hold, in the order in which they share most.
  [[nodiscard]] std::vector<Launch> parts(const Launch& launch, std::size_t memory) const;
  /// Makes room for the samples that a launch's pixels are made of, a part of the film's rows. Returns those that are
  /// not there yet, which may lie around the film. Throws DeviceError, NoDeviceError.
  [[nodiscard]] Launch prepare(const Launch& launch, int film_rows, std::size_t memory);
  /// What prepare() returned last is there.
  void filled() { end_ = asked_end_; }
  /// The samples are another picture's from here on, or their AOVs are asked for.
  void forget() { end_ = first_; }

  [[nodiscard]] const cl::Buffer& buffer() const { return buffer_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_);
  }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  /// Of a row and a column of the film.
  [[nodiscard]] int ring_row(int row) const { return (row + reach_) % rows_; }
  /// Of the first row whose samples count in that row.
  [[nodiscard]] int ring_row_above(int row) const { return ring_row(row - reach_); }
  [[nodiscard]] int ring_column(int column) const { return column - column_first_; }

 private:
  [[nodiscard]] std::size_t rows_of(const Launch& launch, std::size_t memory) const;
  [[nodiscard]] std::size_t row_bytes(const Launch& launch) const;
  [[nodiscard]] bool has_kind_of(const Launch& launch) const;

  Device device_;
  int reach_;
  std::size_t real_bytes_;
  cl::Buffer buffer_;
  std::size_t bytes_ = 0;
  int rows_ = 1, columns_ = 0;
  int column_first_ = 0, sample_first_ = 0, samples_ = 0;
  int first_ = 0, end_ = 0;  ///< Rows of the film whose samples are there.
  int asked_end_ = 0;
};

}  // namespace strahl

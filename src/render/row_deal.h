// SPDX-License-Identifier: MIT
// Rows of a picture, dealt to several devices by their measured speed.
#pragma once

#include <optional>
#include <vector>

#include "render/goal.h"

namespace strahl {

/// Each device asks for rows when it has none: one while its speed is unknown, then half of its share of those that
/// are left, so that all end together, and what takes it a second at the most, so that little is lost with a device
/// that fails. Not for several threads at a time.
class RowDeal {
 public:
  struct Worker {
    double speed = 0;     ///< Rows a second, as measured last; 0: not known yet.
    bool is_out = false;  ///< It takes no part.
    Rows rows = {};       ///< That it has; count 0: none.
  };

  RowDeal(const Rows& rows, std::vector<Worker> workers);

  /// None: nothing is left, or a faster device will have done all of it before this one a single row. Where rows come
  /// back from one that failed, asking again helps.
  [[nodiscard]] std::optional<Rows> next(std::size_t worker);
  /// The rows that it has are rendered.
  void done(std::size_t worker, double seconds);
  /// It has ended before its time, with this share of its rows' samples. They stay its own: nobody renders the others.
  void stopped(std::size_t worker, double share, double seconds);
  /// It takes no part any more; its rows are for the others.
  void failed(std::size_t worker);
  /// All rows are rendered.
  [[nodiscard]] bool is_finished() const;
  [[nodiscard]] const Worker& worker(std::size_t index) const { return workers_[index]; }

 private:
  static void learn(Worker& worker, double rows, double seconds);
  [[nodiscard]] int rows_left() const;
  [[nodiscard]] int fitting(const Worker& worker) const;

  std::vector<Rows> left_;
  std::vector<Worker> workers_;
};

}  // namespace strahl

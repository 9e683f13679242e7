// SPDX-License-Identifier: MIT
// What is said of work under way, and when; nothing here looks at a clock or writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace strahl::cli {

struct ProgressView {
  std::string label;                       ///< "render"
  std::string what;                        ///< What is under way; may be empty.
  double seconds = 0;                      ///< So far.
  std::optional<double> share;             ///< Of the work, 0 to 1; none: not known.
  std::optional<double> left;              ///< Seconds; none: there is no estimate.
  std::optional<double> samples_a_second;  ///< Of a render.
  bool compiling = false;
};

/// For one line of a terminal: a bar.
[[nodiscard]] std::string progress_line(const ProgressView& view);
/// For a log: words.
[[nodiscard]] std::string progress_report(const ProgressView& view);

/// How long work will go on, from how fast its share has grown lately.
class RemainingTime {
 public:
  void add(double seconds, double share);
  /// None before there is an estimate: a second has gone by, and the first half of the time and the second saw the
  /// share grow alike. Launches begin small, and what a goal takes is not known from its first look.
  [[nodiscard]] std::optional<double> left() const;

 private:
  struct Point {
    double seconds, share;
  };
  Point first_{};
  std::vector<Point> points_;  ///< Thinned out, so that they stay few.
};

/// When a log gets a line: after 10 s, 20 s, 40 s and so on.
class ReportSchedule {
 public:
  [[nodiscard]] bool is_due(double seconds);

 private:
  double next_ = 10;
};

}  // namespace strahl::cli

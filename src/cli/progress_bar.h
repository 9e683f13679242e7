// SPDX-License-Identifier: MIT
// How far loading, a render or a self test is, with what remains: on one line of a terminal, or now and then as a line
// of a log. A thread of its own speaks while the work does not, as in a compiler.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "cli/progress_text.h"
#include "render/renderer.h"
#include "stopwatch.h"

namespace strahl::cli {

/// Where progress is shown; nothing is where both are empty.
struct ProgressScreen {
  std::function<void(const std::string&)> line;    ///< A terminal: replaces the one before; empty: wipes it.
  std::function<void(const std::string&)> report;  ///< A log: another line.
};

class ProgressBar {
 public:
  /// On standard error, as that is; nowhere unless wanted.
  ProgressBar(std::string label, bool wanted);
  ProgressBar(std::string label, ProgressScreen screen);
  /// Wipes the line.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const Progress& progress);
  /// share: of the work, 0 to 1; what: that is under way.
  void show(double share, const std::string& what);

 private:
  [[nodiscard]] bool is_enabled() const { return screen_.line || screen_.report; }
  void advance(std::optional<double> share);
  void draw();
  void watch();

  ProgressScreen screen_;
  Stopwatch watch_;
  std::mutex mutex_;  ///< Of all below.
  std::condition_variable wake_;
  bool ended_ = false;
  ProgressView view_;
  RemainingTime remaining_;
  ReportSchedule schedule_;
  double advanced_at_ = -1, drawn_at_ = -1;
  double compiling_since_ = -1;
  bool compiling_said_ = false;
  std::thread thread_;
};

}  // namespace strahl::cli

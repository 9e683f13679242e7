// SPDX-License-Identifier: MIT
// How far loading, a render or a self test is, with what remains, on one line of a terminal.
#pragma once

#include <string>

#include "render/renderer.h"
#include "render/stopwatch.h"

namespace strahl::cli {

/// Draws on standard error where that is a terminal, nothing elsewhere; the destructor wipes the line.
class ProgressBar {
 public:
  ProgressBar(std::string label, bool wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const Progress& progress);
  /// share: of the work, 0 to 1; what: that is under way.
  void show(double share, const std::string& what);

 private:
  std::string label_;
  bool enabled_;
  Stopwatch watch_;
  double shown_at_ = -1;  ///< Progress::seconds of the last drawing.
};

}  // namespace strahl::cli

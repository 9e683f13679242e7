// SPDX-License-Identifier: MIT
// How far a render is, with rate and remaining time, on one line of a terminal.
#pragma once

#include <string>

#include "render/renderer.h"

namespace strahl::cli {

/// Draws on standard error where that is a terminal, nothing elsewhere; the destructor wipes the line.
class ProgressBar {
 public:
  ProgressBar(std::string label, bool wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const Progress& progress);

 private:
  std::string label_;
  bool enabled_;
  double shown_at_ = -1;  ///< Progress::seconds of the last drawing.
};

}  // namespace strahl::cli

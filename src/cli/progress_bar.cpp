// SPDX-License-Identifier: MIT
// A progress bar on one line of standard error.
#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace strahl::cli {
namespace {

constexpr double kRedrawSeconds = 0.1;
constexpr int kWidth = 30;

}  // namespace

ProgressBar::ProgressBar(std::string label, bool wanted)
    : label_(std::move(label)), enabled_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (enabled_ && shown_at_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(const Progress& progress) {
  if (!enabled_ || progress.samples_total == 0 || progress.seconds <= 0) return;
  if (shown_at_ >= 0 && progress.seconds < shown_at_ + kRedrawSeconds) return;
  shown_at_ = progress.seconds;
  const double done = static_cast<double>(progress.samples_done);
  const double total = static_cast<double>(progress.samples_total);
  const double rate = done / progress.seconds;
  const int filled = std::clamp(static_cast<int>(kWidth * done / total), 0, kWidth);
  const std::string left = rate > 0 ? fmt::format("{:.0f} s left", (total - done) / rate) : "";
  const std::string line =
      fmt::format("\r{} {:3.0f} % [{:<{}}] {:.2f} Msamples/s  {}\033[K", label_, 100 * done / total,
                  std::string(static_cast<std::size_t>(filled), '='), kWidth, rate / 1e6, left);
  std::fputs(line.c_str(), stderr);
}

void ProgressBar::show(double share, const std::string& what) {
  if (!enabled_) return;
  if (shown_at_ >= 0 && watch_.seconds() < shown_at_ + kRedrawSeconds) return;
  shown_at_ = watch_.seconds();
  const std::string left = share > 0.1 ? fmt::format("{:.0f} s left · ", shown_at_ * (1 - share) / share) : "";
  const auto filled = static_cast<std::size_t>(kWidth * std::clamp(share, 0.0, 1.0));
  const std::string line = fmt::format("\r{} {:3.0f} % [{:<{}}] {}{}\033[K", label_, 100 * share,
                                       std::string(filled, '='), kWidth, left, what);
  std::fputs(line.c_str(), stderr);
}

}  // namespace strahl::cli

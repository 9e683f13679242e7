// SPDX-License-Identifier: MIT
#include "cli/progress_bar.h"

#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <system_error>

#include "cli/console.h"
#include "opencl/compiling.h"

namespace strahl::cli {
namespace {

constexpr double redraw_seconds = 0.1;
constexpr double idle_redraw_seconds = 1;     ///< While the work says nothing.
constexpr double compiling_said_seconds = 1;  ///< A log hears of no compiler that is quicker.

ProgressScreen standard_error(bool wanted) {
  if (!wanted) return {};
  if (isatty(STDERR_FILENO) == 1) return {show_line, nullptr};
  return {nullptr, say};
}

}  // namespace

ProgressBar::ProgressBar(std::string label, bool wanted) : ProgressBar(std::move(label), standard_error(wanted)) {}

ProgressBar::ProgressBar(std::string label, ProgressScreen screen) : screen_(std::move(screen)) {
  view_.label = std::move(label);
  if (!is_enabled()) return;
  // Signals are the main thread's.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    thread_ = std::thread([this] { watch(); });
  } catch (const std::system_error&) {  // No thread can be begun: a picture is worth more than its bar.
    screen_ = {};
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

ProgressBar::~ProgressBar() {
  if (!is_enabled()) return;
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
  }
  wake_.notify_one();
  thread_.join();
  if (screen_.line && drawn_at_ >= 0) screen_.line("");
}

void ProgressBar::show(const Progress& progress) {
  if (!is_enabled() || progress.seconds <= 0) return;
  const std::scoped_lock lock(mutex_);
  const double done = static_cast<double>(progress.samples_done);
  view_.samples_a_second = done / progress.seconds;
  if (progress.samples_total == 0)
    advance(std::nullopt);
  else
    advance(done / static_cast<double>(progress.samples_total));
}

void ProgressBar::show(double share, const std::string& what) {
  if (!is_enabled()) return;
  const std::scoped_lock lock(mutex_);
  view_.what = what;
  advance(share);
}

void ProgressBar::advance(std::optional<double> share) {
  view_.share = share;
  view_.compiling = false;
  const double seconds = watch_.seconds();
  if (advanced_at_ >= 0 && seconds < advanced_at_ + redraw_seconds) return;
  advanced_at_ = seconds;
  if (share) remaining_.add(seconds, *share);
  view_.left = share ? remaining_.left() : std::nullopt;
  if (screen_.line) draw();
}

void ProgressBar::draw() {
  drawn_at_ = view_.seconds = watch_.seconds();
  screen_.line(progress_line(view_));
}

void ProgressBar::watch() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::duration<double>(redraw_seconds), [this] { return ended_; })) {
    const double seconds = view_.seconds = watch_.seconds();
    const bool was_compiling = view_.compiling;
    view_.compiling = Compiling::is_under_way();
    if (view_.compiling && !was_compiling) compiling_since_ = seconds;
    if (screen_.line) {
      const bool is_idle = view_.compiling && seconds > drawn_at_ + idle_redraw_seconds;
      if (view_.compiling != was_compiling || is_idle) draw();
      continue;
    }
    const bool is_long = view_.compiling && seconds >= compiling_since_ + compiling_said_seconds;
    if (schedule_.is_due(seconds) || (is_long && !compiling_said_)) screen_.report(progress_report(view_));
    compiling_said_ = compiling_said_ || is_long;
  }
}

}  // namespace strahl::cli

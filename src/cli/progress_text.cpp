// SPDX-License-Identifier: MIT
#include "cli/progress_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strahl::cli {
namespace {

constexpr std::size_t bar_width = 30;
constexpr std::size_t most_points = 64;
constexpr double first_estimate = 1;  ///< Seconds.
constexpr double alike = 1.5;         ///< The halves' rates differ by no more than this factor.

std::string seconds_text(double seconds) {
  const double whole = std::round(seconds);
  if (whole < 120) return fmt::format("{:.0f} s", whole);
  if (whole < 7200) return fmt::format("{:.0f} min", whole / 60);
  return fmt::format("{:.1f} h", whole / 3600);
}

}  // namespace

std::string progress_line(const ProgressView& view) {
  if (view.compiling) return fmt::format("{} · compiling, {:.0f} s so far", view.label, view.seconds);
  std::string line = view.label;
  if (view.share) {
    const double share = std::clamp(*view.share, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(static_cast<double>(bar_width) * share);
    line += fmt::format(" {:3.0f} % [{:<{}}]", 100 * share, std::string(filled, '='), bar_width);
  }
  if (view.samples_a_second) line += fmt::format(" {:.2f} Msamples/s", *view.samples_a_second / 1e6);
  if (view.left) line += fmt::format(" {} left", seconds_text(*view.left));
  if (!view.what.empty()) line += (view.left ? " · " : " ") + view.what;
  return line;
}

std::string progress_report(const ProgressView& view) {
  std::string text = "strahl: " + view.label;
  if (view.compiling)
    text += " · compiling";
  else if (view.share)
    text += fmt::format(" {:.0f} %", 100 * std::clamp(*view.share, 0.0, 1.0));
  text += fmt::format(" · {} so far", seconds_text(view.seconds));
  if (view.left && !view.compiling) text += fmt::format(" · about {} left", seconds_text(*view.left));
  if (!view.what.empty()) text += " · " + view.what;
  return text;
}

void RemainingTime::add(double seconds, double share) {
  if (points_.empty()) first_ = {seconds, share};
  points_.push_back({seconds, share});
  if (points_.size() < most_points) return;
  for (std::size_t i = 0; i < most_points / 2; ++i) points_[i] = points_[2 * i + 1];
  points_.resize(most_points / 2);
}

std::optional<double> RemainingTime::left() const {
  if (points_.empty() || points_.back().seconds - first_.seconds < first_estimate) return std::nullopt;
  const Point& now = points_.back();
  const Point& half = *std::lower_bound(points_.begin(), points_.end(), (first_.seconds + now.seconds) / 2,
                                        [](const Point& point, double seconds) { return point.seconds < seconds; });
  const auto rate = [](const Point& from, const Point& to) {
    return (to.share - from.share) / (to.seconds - from.seconds);
  };
  if (!(first_.seconds < half.seconds && half.seconds < now.seconds)) return std::nullopt;
  const double early = rate(first_, half), late = rate(half, now);
  if (!(early > 0 && late > 0) || late * alike < early || early * alike < late) return std::nullopt;
  return std::max(0.0, 1 - now.share) / late;
}

bool ReportSchedule::is_due(double seconds) {
  if (seconds < next_) return false;
  while (next_ <= seconds) next_ *= 2;
  return true;
}

}  // namespace strahl::cli

// SPDX-License-Identifier: MIT
#include "render/pilot.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "kinds/integrators.h"
#include "stopwatch.h"

namespace strahl {
namespace {

constexpr int first_spp = 8;          ///< Where the renderer first estimates the error.
constexpr int least_spp = 4;          ///< The fewest that allow an estimate of the error.
constexpr int growth = 4;             ///< From look to look: all looks together take a third more than the last.
constexpr double probe_share = 0.15;  ///< Of the pilot's time, to see whether the whole picture is quick.

/// The time of a shorter strip depends more on launches than on samples. No strip is more than a sixteenth of the
/// picture, and fewer than three strips do not show how strips differ.
constexpr double strip_seconds = 0.01;
constexpr int least_strips = 16;
constexpr std::size_t least_seen = 3;
constexpr double unseen_spread = 0.5;

struct Timed {
  RenderResult result;
  double seconds = 0;  ///< Without what comes after the last sample.
};

Look look_of(int spp, const ErrorEstimate& error) {
  const double mse = error.rmse * error.rmse;
  if (!(mse > 0)) return {static_cast<double>(spp), 0, 0, 1, 0};
  const double spread = squared_spread(error);
  return {static_cast<double>(spp), mse, spread, error.rmse_high / error.rmse, spread};
}

double mean_of(const std::vector<double>& parts) {
  return parts.empty() ? 0 : std::accumulate(parts.begin(), parts.end(), 0.0) / static_cast<double>(parts.size());
}

double mean_of(const Image& image) {
  double sum = 0;
  for (const float value : image.data) sum += static_cast<double>(value);
  return image.data.empty() ? 0 : sum / static_cast<double>(image.data.size());
}

/// Relative standard deviation of the mean of equally large parts, which are `share` of the whole.
double spread_of(const std::vector<double>& parts, double share) {
  if (parts.size() < least_seen) return share < 1 ? unseen_spread : 0;
  const double mean = mean_of(parts), n = static_cast<double>(parts.size());
  double squares = 0;
  for (const double part : parts) squares += (part - mean) * (part - mean);
  return mean > 0 ? std::sqrt(squares / (n - 1) / n * std::max(0.0, 1 - share)) / mean : 0;
}

/// Strips of the picture, all with as many samples.
struct Strips {
  int spp = 0;
  std::vector<double> seconds{}, errors{}, variances{};  ///< Of each: mse, and the variance of that.
  std::vector<double> means{};

  void add(const Timed& timed) {
    seconds.push_back(timed.seconds);
    means.push_back(mean_of(timed.result.color));
    if (!timed.result.error) return;
    const Look look = look_of(spp, *timed.result.error);
    errors.push_back(look.mse);
    variances.push_back(look.mse * look.spread * look.mse * look.spread);
  }
  /// Relative standard deviation of the errors' mean, by the strips' own variances.
  [[nodiscard]] double own_spread() const {
    const double mean = mean_of(errors);
    return mean > 0 ? std::sqrt(mean_of(variances) / static_cast<double>(variances.size())) / mean : 0;
  }
};

class PilotRun {
 public:
  PilotRun(Renderer& renderer, int most_spp, const std::function<double(const Pilot&)>& most_seconds)
      : renderer_(renderer), most_spp_(most_spp), most_seconds_(most_seconds) {
    spp_ = std::min(first_spp, most_spp);
    is_whole_only_ = kinds::integrator(renderer.scene().integrator.name).from_lights;
  }

  Pilot run() {
    const double most = most_seconds_(pilot_);
    RenderGoal goal;
    goal.spp = spp_;
    const Timed first = timed_render(goal, [&](const Progress&) { return watch_.seconds() < probe_share * most; });
    rows_ = first.result.color.height;
    const double pixels = static_cast<double>(first.result.color.width) * rows_;
    sample_seconds_ = first.seconds * pixels / std::max(1.0, static_cast<double>(first.result.stats.camera_rays));
    if (first.result.complete && whole_is_quick()) {
      add_whole(first, spp_);
      whole_picture();
    } else if (is_whole_only_) {
      whole_picture();
      if (pilot_.passes.empty()) add_whole_of(1);
    } else if (strips()) {
      of_strips_ = pilot_;
      pilot_.looks.clear();
      pilot_.passes.clear();
      pilot_.share = 1;
      pilot_.common_spread = 0;
      whole_picture();
    }
    pilot_.seconds = watch_.seconds();
    return pilot_;
  }

 private:
  /// What strips have told holds until there is a look at the whole picture.
  [[nodiscard]] double left() const {
    return most_seconds_(of_strips_ && pilot_.passes.empty() ? *of_strips_ : pilot_) - watch_.seconds();
  }

  /// At least two looks at the whole picture: one look does not show how the error falls.
  [[nodiscard]] bool whole_is_quick() const { return sample_seconds_ * std::min(most_spp_, growth * spp_) < left(); }

  void add_whole(const Timed& timed, int spp) {
    pilot_.passes.push_back({static_cast<double>(spp), timed.seconds});
    pilot_.spread = ratio_spread;
    const PhaseSeconds& seconds = timed.result.stats.seconds;
    pilot_.look_seconds = seconds.readback + seconds.error;
    if (timed.result.error) pilot_.looks.push_back(look_of(spp, *timed.result.error));
    pilot_.mean = mean_of(timed.result.color);
    sample_seconds_ = timed.seconds / spp;
  }

  void whole_picture() {
    int spp = pilot_.passes.empty() ? spp_ : growth * spp_;
    while (spp <= most_spp_) {
      const double fitting = left() / sample_seconds_;
      const int last = pilot_.passes.empty() ? 0 : static_cast<int>(pilot_.passes.back().samples);
      if (fitting < spp) spp = static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(fitting, 0.0))));
      if (spp < 2 * last || spp == 0) break;
      add_whole_of(spp);
      spp *= growth;
    }
  }

  void add_whole_of(int spp) {
    RenderGoal goal;
    goal.spp = spp;
    goal.seed = static_cast<std::uint32_t>(spp);  // Looks that share no samples differ by chance independently.
    add_whole(timed_render(goal), spp);
  }

  Timed timed_render(RenderGoal goal, const ProgressCallback& goes_on = {}) {
    goal.is_pilot = true;
    const Stopwatch watch;
    Timed timed{renderer_.render(goes_on, goal), 0};
    const RunStats& stats = timed.result.stats;
    timed.seconds = watch.seconds() - stats.seconds.readback - stats.seconds.error;
    pilot_.not_finite += stats.unusual.not_finite();
    return timed;
  }

  Timed render_strip(int strip, int rows, int spp) {
    RenderGoal goal;
    goal.spp = spp;
    goal.seed = static_cast<std::uint32_t>(spp);
    goal.rows = Rows{strip * rows, rows};
    return timed_render(goal);
  }

  /// Renders each strip with few samples, and one of four with more, until the time is over. true: the render takes so
  /// long that there is time for the whole picture.
  bool strips() {
    const int most = std::min(most_spp_, growth * first_spp);
    Strips few{std::clamp(most / growth, std::min(least_spp, most), most)};
    Strips more{most};
    Strips paired{few.spp};  // Those of `few` where there are those of `more`.
    const double row = sample_seconds_ / rows_ * few.spp;
    const int rows = std::clamp(static_cast<int>(std::ceil(strip_seconds / row)), 1, std::max(1, rows_ / least_strips));
    const int count = rows_ / rows;
    const unsigned bits = static_cast<unsigned>(std::bit_width(static_cast<unsigned>(std::max(count - 1, 1))));
    double seconds = most_seconds_(pilot_);
    for (unsigned i = 0; i < (1U << bits); ++i) {
      const int strip = reversed(i, bits);  // Radical inverses (van der Corput 1935): any first few are evenly spread.
      if (strip >= count) continue;
      const Timed timed = render_strip(strip, rows, few.spp);
      if (more.spp > few.spp && is_looked_at_twice(few.seconds.size())) {
        paired.add(timed);
        more.add(render_strip(strip, rows, more.spp));
      }
      few.add(timed);
      const std::size_t seen = few.seconds.size();
      if (watch_.seconds() < seconds && seen < static_cast<std::size_t>(count)) continue;
      const PhaseSeconds& s = timed.result.stats.seconds;
      pilot_.look_seconds = (s.readback + s.error) * rows_ / rows;
      pilot_.share = static_cast<double>(seen) * rows / rows_;
      sum_up(few, more, paired, static_cast<double>(rows_) / rows);
      seconds = most_seconds_(pilot_);
      sample_seconds_ = pilot_.passes.back().seconds / pilot_.passes.back().samples;
      if (sample_seconds_ * (few.spp + most) < seconds - watch_.seconds()) return true;
      if (watch_.seconds() >= seconds && seen >= least_seen) return false;
    }
    return false;
  }

  /// One of four consecutive strips, each time the next of the four: in the order of radical inverses, the first of
  /// four is always in the picture's first quarter.
  static bool is_looked_at_twice(std::size_t number) { return number % growth == number / growth % growth; }

  static int reversed(unsigned value, unsigned bits) {
    unsigned result = 0;
    for (unsigned bit = 0; bit < bits; ++bit) result |= ((value >> bit) & 1U) << (bits - 1 - bit);
    return static_cast<int>(result);
  }

  /// strips: the number of strips in the picture.
  void sum_up(const Strips& few, const Strips& more, const Strips& paired, double strips) {
    pilot_.looks.clear();
    pilot_.passes = {{static_cast<double>(few.spp), strips * mean_of(few.seconds)}};
    pilot_.spread = std::hypot(ratio_spread, spread_of(few.seconds, pilot_.share));
    pilot_.mean = mean_of(few.means);
    if (!more.seconds.empty()) {
      // The same strips with few samples show how much of the difference comes from the number of samples.
      const double factor = mean_of(more.seconds) / mean_of(paired.seconds);
      pilot_.passes.push_back({static_cast<double>(more.spp), factor * pilot_.passes.front().seconds});
    }
    if (few.errors.empty()) return;
    // Of the whole picture, which has more pixels than were looked at.
    const double mse = mean_of(few.errors), own = few.own_spread(), told = own * std::sqrt(pilot_.share);
    const double upper = relative_upper(told);
    pilot_.common_spread = spread_of(few.errors, pilot_.share);
    pilot_.looks.push_back({static_cast<double>(few.spp), mse, own, upper, told});
    const double before = mean_of(paired.errors);
    if (more.errors.empty() || !(before > 0)) return;
    const double spread = std::hypot(more.own_spread(), own * std::sqrt(static_cast<double>(growth)));
    pilot_.looks.push_back({static_cast<double>(more.spp), mse * mean_of(more.errors) / before, spread, upper, told});
  }

  Renderer& renderer_;
  int most_spp_;
  const std::function<double(const Pilot&)>& most_seconds_;
  Stopwatch watch_;
  Pilot pilot_;
  std::optional<Pilot> of_strips_;
  int spp_ = first_spp;
  int rows_ = 1;
  bool is_whole_only_ = false;  ///< Light paths end anywhere: some rows alone have another error.
  double sample_seconds_ = 0;   ///< One of every pixel.
};

}  // namespace

Pilot run_pilot(Renderer& renderer, int most_spp, const std::function<double(const Pilot&)>& most_seconds) {
  return PilotRun(renderer, most_spp, most_seconds).run();
}

}  // namespace strahl

// SPDX-License-Identifier: MIT
// A picture on several devices (docs/decisions/0031-several-devices.md): a thread for each renders rows on its device
// and reads their film back; this run adds up what they bring.
#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>

#include "errors.h"
#include "render/film_run.h"
#include "render/row_deal.h"

namespace strahl {
namespace {

/// All rows get a range of samples that takes about so long before the next range begins.
constexpr double range_seconds = 10;
/// Of the first range, while no device's speed is known.
constexpr int first_samples = 4;

}  // namespace

/// Where the threads leave what they have made. All of it belongs to the mutex.
class FilmRun::Table {
 public:
  struct Done {
    std::size_t worker;
    Launch launch;
    Part part;
  };

  Table(const Launch& all, RowDeal&& deal) : launch(all), rows(std::move(deal)) {}

  const Launch launch;
  std::mutex mutex;
  std::condition_variable changed;
  RowDeal rows;
  std::vector<Done> done;
  std::vector<std::uint64_t> under_way;  ///< Samples of each worker's rows so far.
  std::vector<double> seconds;           ///< That each worker has been at it.
  std::size_t at_work = 0;               ///< Threads.
  bool is_stopped = false;
  bool has_news = false;     ///< For the run that adds them up.
  std::exception_ptr fault;  ///< Of anything but a device: it ends the render.

  void tell() {
    has_news = true;
    changed.notify_all();
  }
};

Renderer::State& FilmRun::device_of(std::size_t worker) const {
  return worker == 0 ? state_ : *state_.helpers[worker - 1];
}

Renderer::State& FilmRun::living_device() const {
  for (std::size_t i = 0; i <= state_.helpers.size(); ++i)
    if (device_of(i).fault.empty()) return device_of(i);
  return state_;
}

FilmRun::Part FilmRun::part(const Launch& launch) {
  write_header();
  has_first_samples_ = launch.sample_first == 0;
  bool carry_on = true;
  for (int row = 0; row < height_ && carry_on; row += band_rows_) {
    begin_rows(row);
    clear(band_.count, has_first_samples_);
    Launch pixels = launch;
    if (film_.kind == FilmKind::pixels) {
      pixels.row_first = row;
      pixels.rows = band_.count;
    }
    carry_on = render_all_of(pixels);
    end_band();
  }
  return {state_now(), std::move(result_.stats), is_cut_};
}

/// The rows of a part's film: those of the launch; of light paths, which end in any row, all.
Rows FilmRun::rows_of_part(const Launch& launch) const {
  return film_.kind == FilmKind::splats ? Rows{0, height_} : Rows{launch.row_first, launch.rows};
}

/// Of a device's thread: the part as a picture of its own.
FilmRun::Part FilmRun::part_on(Renderer::State& device, const Launch& launch, const ProgressCallback& progress) const {
  RenderGoal goal;
  goal.spp = end_;
  goal.seed = result_.stats.seed;
  goal.samples = {launch.sample_first, launch.samples};
  const RowsOnly only(device.window, rows_of_part(launch));
  FilmRun run(device, goal, progress, nullptr, sums_);
  run.samples_until_ = samples_until_;
  return run.part(launch);
}

std::string FilmRun::all_faults() const {
  std::string all;
  for (std::size_t i = 0; i <= state_.helpers.size(); ++i)
    if (!device_of(i).fault.empty()) all += (all.empty() ? "" : "; ") + device_of(i).fault;
  return all;
}

/// Of one thread: rows, as long as there are some.
void FilmRun::work_at(Table& table, std::size_t worker) {
  Renderer::State& device = device_of(worker);
  std::unique_lock lock(table.mutex);
  const ProgressCallback progress = [&table, worker](const Progress& now) {
    const std::scoped_lock locked(table.mutex);
    table.under_way[worker] = now.samples_done;
    table.tell();
    return !table.is_stopped;
  };
  while (!table.is_stopped && !table.rows.is_finished()) {
    const std::optional<Rows> rows = table.rows.next(worker);
    if (!rows) {
      table.changed.wait(lock);
      continue;
    }
    Launch launch = table.launch;
    launch.row_first = rows->first;
    launch.rows = rows->count;
    lock.unlock();
    std::string device_fault;
    std::exception_ptr other_fault;
    const Stopwatch start;
    try {
      Part part = part_on(device, launch, progress);
      const double seconds = start.seconds();
      lock.lock();
      const double share = static_cast<double>(part.stats.camera_rays) /
                           (static_cast<double>(launch.columns) * launch.rows * launch.samples);
      if (share < 1)
        table.rows.stopped(worker, share, seconds);
      else
        table.rows.done(worker, seconds);
      if (part.is_cut) table.is_stopped = true;
      table.done.push_back({worker, launch, std::move(part)});
    } catch (const DeviceError& fault) {
      device_fault = fault.what();
    } catch (const NoDeviceError& fault) {
      device_fault = fault.what();
    } catch (...) {
      other_fault = std::current_exception();
    }
    if (!lock.owns_lock()) lock.lock();
    table.under_way[worker] = 0;
    table.seconds[worker] += start.seconds();
    if (!device_fault.empty()) {
      device.fault = device_fault;
      table.rows.failed(worker);
    }
    if (other_fault) {
      table.fault = other_fault;
      table.is_stopped = true;
    }
    table.tell();
    if (!device_fault.empty()) break;
  }
  --table.at_work;
  table.tell();
}

void FilmRun::add(const Part& part, const Launch& launch, std::size_t worker) {
  const FilmState& state = part.state;
  const int top = rows_of_part(launch).first;
  film_.add_words(top, state.film.words);
  const std::size_t first = static_cast<std::size_t>(top) * static_cast<std::size_t>(width_);
  for (std::size_t i = 0; i < state.film.samples.size(); ++i) film_.samples[first + i] += state.film.samples[i];
  if (launch.sample_first == 0 && state_.has_aov()) {
    for (std::size_t i = 0; i < state.film.samples.size(); ++i) {
      if (state.film.samples[i] == 0) continue;
      std::copy_n(&state.aov_reals[i * layout::AOV_REALS], layout::AOV_REALS,
                  &aov_reals_[(first + i) * layout::AOV_REALS]);
      std::copy_n(&state.aov_ints[i * layout::AOV_INTS], layout::AOV_INTS, &aov_ints_[(first + i) * layout::AOV_INTS]);
    }
  }
  RunStats& run = result_.stats;
  run.unusual += state.unusual;
  run.camera_rays += part.stats.camera_rays;
  for (const auto counted :
       {&RunStats::shadow_rays, &RunStats::bounce_rays, &RunStats::nodes_visited, &RunStats::primitives_tested})
    if (run.*counted && part.stats.*counted) *(run.*counted) += *(part.stats.*counted);
  run.add_launches(part.stats);
  run.shares[worker].samples += part.stats.camera_rays;
  is_cut_ = is_cut_ || part.is_cut;
}

/// false as render_all_of. Throws Error where no device is left.
bool FilmRun::deal(const Launch& all) {
  const double work_of_row = static_cast<double>(all.columns) * all.samples;
  const std::size_t workers = state_.helpers.size() + 1;
  std::vector<RowDeal::Worker> known(workers);
  for (std::size_t i = 0; i < workers; ++i)
    known[i] = {device_of(i).rate / work_of_row, !device_of(i).fault.empty(), {}};
  Table table(all, RowDeal({all.row_first, all.rows}, std::move(known)));
  table.under_way.resize(workers, 0);
  table.seconds.resize(workers, 0);
  bool carry_on = true;
  {
    std::vector<std::jthread> threads;
    /// Threads end with this block, whatever ends it.
    struct Stop {
      Table& table;
      ~Stop() {
        const std::scoped_lock lock(table.mutex);
        table.is_stopped = true;
        table.changed.notify_all();
      }
    } stop{table};
    std::unique_lock lock(table.mutex);
    for (std::size_t i = 0; i < workers; ++i) {
      if (table.rows.worker(i).is_out) continue;
      ++table.at_work;
      threads.emplace_back([this, &table, i] { work_at(table, i); });
    }
    while (table.at_work > 0 || !table.done.empty()) {
      table.changed.wait(lock, [&table] { return table.has_news; });
      table.has_news = false;
      const std::vector<Table::Done> done = std::exchange(table.done, {});
      under_way_ = std::accumulate(table.under_way.begin(), table.under_way.end(), std::uint64_t{0});
      lock.unlock();
      for (const Table::Done& one : done) add(one.part, one.launch, one.worker);
      if (carry_on && !report()) carry_on = false;
      lock.lock();
      if (!carry_on) table.is_stopped = true;
      table.changed.notify_all();
    }
    under_way_ = 0;
  }
  for (std::size_t i = 0; i < workers; ++i) {
    device_of(i).rate = table.rows.worker(i).speed * work_of_row;
    result_.stats.shares[i].seconds += table.seconds[i];
    result_.stats.shares[i].fault = device_of(i).fault;
  }
  if (table.fault) std::rethrow_exception(table.fault);
  if (carry_on && !is_cut_ && !table.rows.is_finished())
    throw Error(fmt::format("none of {} devices is left: {}", workers, all_faults()));
  return carry_on && !is_cut_;
}

bool FilmRun::render_shared(const Launch& all) {
  const Stopwatch start;
  Launch range = all;
  bool carry_on = true;
  for (int left = all.samples; left > 0 && carry_on; left -= range.samples) {
    double rate = 0;
    for (std::size_t i = 0; i <= state_.helpers.size(); ++i)
      if (device_of(i).fault.empty()) rate += device_of(i).rate;
    const double fitting = range_seconds * rate / (static_cast<double>(all.columns) * all.rows);
    range.samples = rate > 0 ? static_cast<int>(std::clamp(fitting, 1.0, static_cast<double>(left)))
                             : std::min(left, first_samples);
    carry_on = deal(range);
    range.sample_first += range.samples;
  }
  result_.stats.seconds.kernel += start.seconds();
  return carry_on;
}

}  // namespace strahl

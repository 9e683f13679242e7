// SPDX-License-Identifier: MIT
#include "render/row_deal.h"

#include <algorithm>
#include <utility>

namespace strahl {
namespace {

/// Of the rows that a device gets at a time.
constexpr double most_seconds = 1;

/// At a time a device's speed falls to no less of what it was: a row that waited for the processor is no slow device.
constexpr double least_of_speed = 0.25;

}  // namespace

RowDeal::RowDeal(const Rows& rows, std::vector<Worker> workers) : left_{rows}, workers_(std::move(workers)) {}

int RowDeal::rows_left() const {
  int sum = 0;
  for (const Rows& rows : left_) sum += rows.count;
  return sum;
}

/// 0: none.
int RowDeal::fitting(const Worker& worker) const {
  const int left = rows_left();
  // It may be a thousand times as slow as the others, who would wait for more.
  if (worker.speed <= 0) return std::min(1, left);
  double sum = 0;
  for (const Worker& other : workers_) {
    if (other.is_out) continue;
    if (other.speed > worker.speed * left) return 0;
    // Of one that is not known yet the same is expected.
    sum += other.speed > 0 ? other.speed : worker.speed;
  }
  const double rows = std::min(left * worker.speed / (2 * sum), most_seconds * worker.speed);
  return static_cast<int>(std::clamp(rows, 1.0, static_cast<double>(left)));
}

std::optional<Rows> RowDeal::next(std::size_t index) {
  Worker& worker = workers_[index];
  if (left_.empty() || worker.is_out) return std::nullopt;
  Rows& from = left_.back();
  const int count = std::min(fitting(worker), from.count);
  if (count == 0) return std::nullopt;
  worker.rows = {from.first, count};
  from = {from.first + count, from.count - count};
  if (from.count == 0) left_.pop_back();
  return worker.rows;
}

void RowDeal::learn(Worker& worker, double rows, double seconds) {
  worker.speed = std::max(rows / std::max(seconds, 1e-6), least_of_speed * worker.speed);
}

void RowDeal::done(std::size_t index, double seconds) {
  Worker& worker = workers_[index];
  learn(worker, worker.rows.count, seconds);
  worker.rows = {};
}

void RowDeal::stopped(std::size_t index, double share, double seconds) {
  Worker& worker = workers_[index];
  if (share > 0) learn(worker, share * worker.rows.count, seconds);
}

void RowDeal::failed(std::size_t index) {
  Worker& worker = workers_[index];
  if (worker.rows.count > 0) left_.push_back(worker.rows);
  worker.rows = {};
  worker.is_out = true;
}

bool RowDeal::is_finished() const {
  return left_.empty() &&
         std::all_of(workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.rows.count == 0; });
}

}  // namespace strahl

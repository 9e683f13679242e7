// SPDX-License-Identifier: MIT
#include "cli/process_clock.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

namespace strahl::cli {
namespace {

constexpr double gpu_exit_seconds = 0.12;

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Processor time of this process and of the children it has waited for, which a launcher runs one after the other.
double processor_seconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    if (getrusage(who, &used) == 0) seconds += seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  }
  return seconds;
}

/// Field 22 of /proc/self/stat, ticks since boot; 0 where there is no such thing. The second field, the program's name,
/// may hold anything but ends with the last parenthesis.
double start_ticks() {
  std::ifstream file("/proc/self/stat");
  std::string line;
  std::getline(file, line);
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(line.substr(name_end + 1));
  std::string skipped;
  for (int field = 3; field < 22; ++field) fields >> skipped;
  double ticks = 0;
  return fields >> ticks ? ticks : 0;
}

/// Second field of /proc/self/statm, in pages; 0 where there is no such thing.
double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return file ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}

double memory_exit_seconds(double more_bytes) {
  constexpr std::size_t piece = std::size_t{8} << 20;
  void* memory = mmap(nullptr, piece, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 0;
  madvise(memory, piece, MADV_NOHUGEPAGE);  // As most of a heap is.
  for (std::size_t at = 0; at < piece; at += 4096) static_cast<volatile char*>(memory)[at] = 1;
  const Clock::time_point start = Clock::now();
  munmap(memory, piece);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return (resident_bytes() + more_bytes) / static_cast<double>(piece) * seconds;
}

}  // namespace

Clock::time_point process_start() {
  const Clock::time_point now = Clock::now();
  const double ticks = start_ticks();
  timespec since_boot{};
  if (ticks <= 0 || clock_gettime(CLOCK_BOOTTIME, &since_boot) != 0) return now;
  const double tick = 1.0 / static_cast<double>(sysconf(_SC_CLK_TCK));
  const double boot = static_cast<double>(since_boot.tv_sec) + 1e-9 * static_cast<double>(since_boot.tv_nsec);
  const double oldest = boot - ticks * tick;
  const double age = std::clamp(processor_seconds(), std::max(0.0, oldest - tick), std::max(0.0, oldest));
  return later(now, -age);
}

double expected_exit_seconds(const std::vector<Device>& devices, double more_bytes) {
  const bool has_gpu =
      std::any_of(devices.begin(), devices.end(), [](const Device& device) { return device.info().type == "GPU"; });
  return memory_exit_seconds(more_bytes) + (has_gpu ? gpu_exit_seconds : 0);
}

}  // namespace strahl::cli

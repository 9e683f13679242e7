// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM, SIGHUP and SIGUSR1 while a picture is rendered (POSIX).
#include "cli/interrupt.h"

namespace strahl::cli {
namespace {

volatile std::sig_atomic_t received_signal = 0;
volatile std::sig_atomic_t is_snapshot_wanted = 0;

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

auto handler_of(int signal) {
  struct sigaction current {};
  sigaction(signal, nullptr, &current);
  return current.sa_handler;
}

extern "C" void remember_signal(int signal) {
  received_signal = signal;
  // Whichever comes next ends the process; one that the caller ignores stays ignored.
  for (const int one : signals)
    if (handler_of(one) == remember_signal) std::signal(one, SIG_DFL);
}

extern "C" void remember_snapshot(int /*signal*/) { is_snapshot_wanted = 1; }

void install(int signal, void (*handler)(int), struct sigaction& old) {
  sigaction(signal, nullptr, &old);
  if (old.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void block_ignored_signals() {
  sigset_t ignored;
  sigemptyset(&ignored);
  for (const int one : signals)
    if (handler_of(one) == SIG_IGN) sigaddset(&ignored, one);
  // Threads that are begun later inherit it.
  sigprocmask(SIG_BLOCK, &ignored, nullptr);
}

InterruptGuard::InterruptGuard() {
  received_signal = 0;
  is_snapshot_wanted = 0;
  for (std::size_t i = 0; i < signals.size(); ++i) install(signals[i], remember_signal, old_[i]);
  install(SIGUSR1, remember_snapshot, old_snapshot_);
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &old_[i], nullptr);
  sigaction(SIGUSR1, &old_snapshot_, nullptr);
}

bool InterruptGuard::wants_snapshot() const { return is_snapshot_wanted != 0; }

void InterruptGuard::snapshot_is_taken() { is_snapshot_wanted = 0; }

bool InterruptGuard::interrupted() const { return received_signal != 0; }

ExitCode InterruptGuard::exit_code() const {
  switch (received_signal) {
    case SIGINT:
      return ExitCode::interrupted;
    case SIGTERM:
      return ExitCode::terminated;
    case SIGHUP:
      return ExitCode::hung_up;
    default:
      return ExitCode::ok;
  }
}

}  // namespace strahl::cli

// SPDX-License-Identifier: MIT
// Signals (POSIX).
#include "cli/interrupt.h"

#include <ctime>

namespace strahl::cli {
namespace {

volatile std::sig_atomic_t received_signal = 0;

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

extern "C" void do_nothing(int /*signal*/) {}

void install(int signal, void (*handler)(int), struct sigaction* old = nullptr) {
  sigaction(signal, nullptr, old);
  if (handler_of(signal) == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void set_up_signals() {
  sigset_t blocked;
  sigemptyset(&blocked);
  for (const int one : signals)
    if (handler_of(one) == SIG_IGN) sigaddset(&blocked, one);
  sigaddset(&blocked, SIGXFSZ);
  // It stays pending until it is asked for: a handler would be replaced by LLVM's, which forgets it.
  if (handler_of(SIGUSR1) != SIG_IGN) sigaddset(&blocked, SIGUSR1);
  // Threads that are begun later inherit it.
  sigprocmask(SIG_BLOCK, &blocked, nullptr);
  // LLVM leaves SIGPIPE alone. A handler, unlike SIG_IGN, is not inherited by the programs that a driver starts.
  install(SIGPIPE, do_nothing);
}

bool wants_snapshot() {
  sigset_t pending;
  sigemptyset(&pending);
  sigpending(&pending);
  return sigismember(&pending, SIGUSR1) == 1;
}

void snapshot_is_taken() {
  sigset_t snapshot;
  sigemptyset(&snapshot);
  sigaddset(&snapshot, SIGUSR1);
  const timespec at_once{};
  sigtimedwait(&snapshot, nullptr, &at_once);
}

InterruptGuard::InterruptGuard() {
  received_signal = 0;
  for (std::size_t i = 0; i < signals.size(); ++i) install(signals[i], remember_signal, &old_[i]);
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &old_[i], nullptr);
}

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

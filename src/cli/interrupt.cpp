// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and SIGHUP while a picture is rendered (POSIX).
#include "cli/interrupt.h"

namespace strahl::cli {
namespace {

volatile std::sig_atomic_t received_signal = 0;

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

extern "C" void remember_signal(int signal) {
  received_signal = signal;
  // Whichever comes next ends the process.
  for (const int one : signals) std::signal(one, SIG_DFL);
}

void install(int signal, struct sigaction& old) {
  sigaction(signal, nullptr, &old);
  if (old.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = remember_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  received_signal = 0;
  for (std::size_t i = 0; i < signals.size(); ++i) install(signals[i], old_[i]);
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

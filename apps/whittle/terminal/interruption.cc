#include "terminal/interruption.hh"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

#include "terminal/errors.hh"

namespace whittle::app {
namespace {

// The signal handler uses both, so they must be lock-free.
std::atomic<int> pending_signal{0};
std::atomic<int> n_waiting{0};
static_assert(std::atomic<int>::is_always_lock_free);

/// The signal handler. Calls async-signal-safe functions only.
void on_signal(int signal) {
  pending_signal = signal;
  if (n_waiting > 0) return;
  constexpr std::string_view message = interrupted_message;
  // The program ends even if the message can't be written.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(128 + signal);
}

}  // namespace

void handle_signals() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction inherited = {};
    // A signal that the caller ignores (nohup, a background job of a script) stays ignored.
    if (sigaction(signal, nullptr, &inherited) == 0 && inherited.sa_handler == SIG_IGN) continue;
    sigaction(signal, &action, nullptr);
  }
  // Writing then fails with a message, and temporary files go.
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
}

SignalsWait::SignalsWait() { ++n_waiting; }

SignalsWait::~SignalsWait() { --n_waiting; }

bool SignalsWait::pending() { return pending_signal != 0; }

void SignalsWait::throw_if_pending() {
  if (const int signal = pending_signal) throw Interrupted(signal);
}

}  // namespace whittle::app

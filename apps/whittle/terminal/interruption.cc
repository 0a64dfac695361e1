#include "terminal/interruption.hh"

#include <atomic>

#include "system/system.hh"
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
  end_at_once(interrupted_message, 128 + signal);
}

}  // namespace

void handle_signals() { watch_signals(on_signal); }

SignalsWait::SignalsWait() { ++n_waiting; }

SignalsWait::~SignalsWait() { --n_waiting; }

bool SignalsWait::pending() { return pending_signal != 0; }

void SignalsWait::throw_if_pending() {
  if (const int signal = pending_signal) throw Interrupted(signal);
}

}  // namespace whittle::app

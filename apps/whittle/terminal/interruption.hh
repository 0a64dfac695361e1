#pragma once

namespace whittle::app {

/// Has Ctrl-C, SIGTERM and SIGHUP end the program with 128 + the signal's number and one line on stderr: at once where
/// nothing needs tidying up, else as soon as the code in charge looks. Writing to a closed pipe becomes an error like
/// any other.
void handle_signals();

/// While one of these lives, a signal waits to be asked for instead of ending the program: for stretches that look
/// often, and for those that have temporary files to remove.
class SignalsWait {
 public:
  SignalsWait();
  ~SignalsWait();
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

  /// Whether a signal is waiting.
  static bool pending();
  /// \throw Interrupted if one is.
  static void throw_if_pending();
};

/// What an interrupted run says.
inline constexpr char interrupted_message[] = "whittle: interrupted\n";

}  // namespace whittle::app

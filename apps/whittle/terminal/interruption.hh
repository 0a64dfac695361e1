#pragma once

namespace whittle::app {

/// Makes Ctrl-C, SIGTERM and SIGHUP end the program with 128 + the signal's number and one line on stderr. The program
/// ends at once, or, while a `SignalsWait` exists, as soon as the code asks for signals. Writing to a closed pipe
/// becomes an ordinary error.
void handle_signals();

/// While an object of this class exists, a signal doesn't end the program; it stays pending until the code asks for it.
/// For code that asks often, and for code that has temporary files to remove.
class SignalsWait {
 public:
  SignalsWait();
  ~SignalsWait();
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

  /// Whether a signal is pending.
  static bool pending();
  /// \throw Interrupted if one is.
  static void throw_if_pending();
};

/// The message of an interrupted run on stderr.
inline constexpr char interrupted_message[] = "whittle: interrupted\n";

}  // namespace whittle::app

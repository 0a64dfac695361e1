#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// What POSIX and Windows do in different ways: posix.cc and windows.cc, of which one is built.

namespace whittle::app {

/// The words of the command line in UTF-8, the program's name first. (Windows gives main() another encoding.)
std::vector<std::string> words_of_command_line(int argc, char** argv);

/// To be called first: the standard streams carry bytes as they are, and a console shows UTF-8.
void set_up_streams();

/// Whether standard error is a terminal that can show colours and erase lines.
bool is_at_terminal();

/// Of standard error, in characters; 80 if it isn't known.
std::size_t terminal_width();

/// From now on `on_signal` is called, with its number, when the user or the system ends the program: SIGINT, SIGTERM,
/// and SIGHUP where that exists. A signal that the caller ignores (nohup, a background job of a script) stays ignored.
/// Writing to a closed pipe or beyond a limit is an error of the write from now on, no signal. `on_signal` may call
/// only async-signal-safe functions, such as `end_at_once`.
void watch_signals(void (*on_signal)(int));

/// Ends the program with a message on standard error, without any cleaning up. Async-signal-safe.
[[noreturn]] void end_at_once(std::string_view message, int status);

/// Why no file can be made in the folder; empty if one can.
std::string why_not_writable(const std::string& folder);

/// The most memory that the program has had so far, in bytes; 0 if it isn't known.
std::uint64_t peak_memory_bytes();

/// Opens a file with the program that the desktop has for it, which prints nothing. \return whether there is such a
/// program
bool open_on_desktop(const std::string& path);

}  // namespace whittle::app

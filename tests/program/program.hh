#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/temporary_folder.hh"

/// The program under test, run as its users run it.
namespace whittle::test {

/// How a run ended and what it printed.
struct Outcome {
  int exit_code = -1;  ///< 128 + the number of the signal that killed it
  std::string out;
  std::string err;
};
/// All of it in one string, for failure messages.
std::ostream& operator<<(std::ostream& stream, const Outcome& outcome);

struct RunOptions {
  std::string input;                               ///< contents of stdin
  std::filesystem::path folder;                    ///< working folder; empty: the current one
  std::map<std::string, std::string> environment;  ///< variables added to the test's environment
  std::string stdout_to;                           ///< a file to write to instead of `out`
  int stderr_to = -1;             ///< file descriptor, such as a terminal, to write to instead of `err`
  std::function<void()> prepare;  ///< called in the child process right before the program starts
};

/// Runs the program with these arguments until it ends.
Outcome whittle(const std::vector<std::string>& arguments, const RunOptions& options = {});
/// Runs any program. Our program's folder comes first in PATH.
Outcome run(const std::vector<std::string>& command, const RunOptions& options = {});
/// The program and its arguments.
std::vector<std::string> command(std::vector<std::string> arguments);

/// A program that is still running. The destructor kills it if it has not ended.
class Running {
 public:
  explicit Running(const std::vector<std::string>& command, const RunOptions& options = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void signal(int number) const;
  /// Writes to its stdin, and waits until the program has read that. `finish` writes the rest of the input, if it is
  /// called.
  void feed(const std::string& text) const;
  Outcome finish(const std::string& rest_of_input = {});

 private:
  pid_t process_ = -1;
  int input_ = -1;
  int output_ = -1;
  int errors_ = -1;
};

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

/// The file of data/, as a string.
std::string data_file(const std::string& name);

/// \throw an exception with the whole text if it isn't JSON.
nlohmann::json parse_json(const std::string& text);

}  // namespace whittle::test

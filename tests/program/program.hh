#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// The program under test, run as its users run it.
namespace whittle::test {

/// How a run ended and what it said.
struct Outcome {
  int exit_code = -1;  ///< 128 + the number of the signal that killed it
  std::string out;
  std::string err;
};
/// Everything at once, for failure messages.
std::ostream& operator<<(std::ostream& stream, const Outcome& outcome);

struct RunOptions {
  std::string input;                               ///< what stdin has to offer
  std::filesystem::path folder;                    ///< to run in; empty: this one
  std::map<std::string, std::string> environment;  ///< set on top of ours
  std::string stdout_to;                           ///< a file to write to instead of `out`
  int stderr_to = -1;                              ///< a terminal, say, to write to instead of `err`
  std::function<void()> prepare;                   ///< called in the child, right before the program
};

/// Runs the program with these arguments to its end.
Outcome whittle(const std::vector<std::string>& arguments, const RunOptions& options = {});
/// Runs any program; along PATH, ours is first.
Outcome run(const std::vector<std::string>& command, const RunOptions& options = {});
/// The program and its arguments.
std::vector<std::string> command(std::vector<std::string> arguments);

/// A program that is still running. Killed when this goes before it ended.
class Running {
 public:
  explicit Running(const std::vector<std::string>& command, const RunOptions& options = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void signal(int number) const;
  /// Writes to its stdin, and waits until it has taken that. The rest of the input comes with `finish`, or never.
  void feed(const std::string& text) const;
  Outcome finish(const std::string& rest_of_input = {});

 private:
  pid_t process_ = -1;
  int input_ = -1;
  int output_ = -1;
  int errors_ = -1;
};

/// A new folder that is gone in the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  /// Names of all files in it, sorted.
  std::vector<std::string> files() const;

 private:
  std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

/// The file of data/, as a string.
std::string data_file(const std::string& name);

/// \throw with the whole text if it isn't JSON.
nlohmann::json parse_json(const std::string& text);

}  // namespace whittle::test

#pragma once

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace whittle::app {

bool is_root();

/// A folder that is there as long as this.
class WorkFolder {
 public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  /// The path of a file in it.
  std::string operator/(const char* name) const { return path_ + '/' + name; }

 private:
  std::string path_;
};

/// Runs a program to its end, and lets it print nothing. \return its exit status, or nothing if there is no such
/// program
std::optional<int> run_quietly(std::vector<std::string> arguments);

/// A program that reads from its file descriptor 3 and writes to 4, and prints nothing.
class TalkingProcess {
 public:
  /// \return null if there is no such program \throw std::runtime_error if it can't be run
  static std::unique_ptr<TalkingProcess> start(std::vector<std::string> arguments);
  /// Waits until the program has ended; stops it if that takes long.
  ~TalkingProcess();
  TalkingProcess(const TalkingProcess&) = delete;
  TalkingProcess& operator=(const TalkingProcess&) = delete;

  /// \throw std::runtime_error if it has ended
  void write(const std::string& text);
  /// What it writes up to the next `end`, without that. \throw std::runtime_error if it has ended, or writes nothing
  /// for two minutes
  std::string read_until(char end);

 private:
  TalkingProcess(std::string name, pid_t process, int to, int from);

  std::string name_;
  pid_t process_;
  int to_, from_;
  std::string read_;  ///< and not asked for yet
};

}  // namespace whittle::app

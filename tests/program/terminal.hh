#pragma once

#include <string>

namespace whittle::test {

/// A pseudo-terminal that a program writes to, and what it wrote.
class Terminal {
 public:
  /// \param columns of the window.
  explicit Terminal(unsigned short columns = 80);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// File descriptor for the program.
  int descriptor() const { return program_end_; }
  /// Waits until it has written `text`, at most a minute. \return everything written so far
  std::string read_until(const std::string& text);
  /// Everything written until all programs have closed the terminal.
  std::string read_all();

 private:
  bool read_more();

  int our_end_ = -1;
  int program_end_ = -1;
  std::string read_;
};

}  // namespace whittle::test

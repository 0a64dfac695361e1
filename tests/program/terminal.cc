#include "program/terminal.hh"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace whittle::test {

Terminal::Terminal(unsigned short columns) {
  const winsize size{24, columns, 0, 0};
  if (::openpty(&our_end_, &program_end_, nullptr, nullptr, &size) != 0) {
    throw std::system_error(errno, std::generic_category(), "openpty");
  }
  ::fcntl(our_end_, F_SETFD, FD_CLOEXEC);
}

Terminal::~Terminal() {
  ::close(our_end_);
  if (program_end_ >= 0) ::close(program_end_);
}

bool Terminal::read_more() {
  constexpr int patience_ms = 60'000;
  pollfd waiting{our_end_, POLLIN, 0};
  if (::poll(&waiting, 1, patience_ms) <= 0) return false;
  std::array<char, 4096> buffer;
  const ssize_t size = ::read(our_end_, buffer.data(), buffer.size());
  if (size <= 0) return false;
  read_.append(buffer.data(), static_cast<std::size_t>(size));
  return true;
}

std::string Terminal::read_until(const std::string& text) {
  while (read_.find(text) == std::string::npos && read_more()) {
  }
  return read_;
}

std::string Terminal::read_all() {
  ::close(program_end_);
  program_end_ = -1;
  while (read_more()) {
  }
  return read_;
}

}  // namespace whittle::test

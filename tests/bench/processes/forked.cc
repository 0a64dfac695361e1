#include "bench/processes/forked.hh"

#include <malloc.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace whittle::bench {
namespace {

using Time = std::chrono::steady_clock::time_point;

// The first character of the message. The rest is the result, or the error.
constexpr char done = '+';
constexpr char failed = '-';

/// \return whether everything was written
bool send(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

/// Runs in the forked process. It ends by `_exit`: the cleaning up belongs to its parent.
[[noreturn]] void work_and_send(const std::function<std::string()>& work, int descriptor) {
  malloc_trim(0);
  std::string message;
  try {
    message = done + work();
  } catch (const std::exception& error) {
    message = failed + std::string(error.what());
  }
  _exit(send(descriptor, message) ? 0 : 1);
}

/// \return false after the deadline
bool wait_for_bytes(int descriptor, Time deadline) {
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) return false;
    constexpr long longest = 60'000;  // poll() takes an int
    pollfd poll_descriptor{descriptor, POLLIN, 0};
    if (poll(&poll_descriptor, 1, static_cast<int>(std::min<long>(left.count(), longest))) > 0) return true;
  }
}

/// Everything until the other end is closed; nothing after the deadline.
std::optional<std::string> receive(int descriptor, Time deadline) {
  std::string bytes;
  while (wait_for_bytes(descriptor, deadline)) {
    constexpr std::size_t piece = 1 << 16;  // the capacity of a pipe
    const std::size_t size = bytes.size();
    bytes.resize(size + piece);
    const ssize_t n = read(descriptor, bytes.data() + size, piece);
    bytes.resize(size + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "read");
    if (n == 0) return bytes;
  }
  return std::nullopt;
}

int wait_for_end(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
  return status;
}

}  // namespace

std::string run_forked(const std::function<std::string()>& work, double limit_s) {
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const Time deadline = std::chrono::steady_clock::now() +
                        std::chrono::duration_cast<Time::duration>(std::chrono::duration<double>(limit_s));
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    close(ends[0]);
    work_and_send(work, ends[1]);
  }
  close(ends[1]);
  const std::optional<std::string> message = receive(ends[0], deadline);
  close(ends[0]);
  if (!message) kill(child, SIGKILL);
  const int status = wait_for_end(child);
  if (!message) throw std::runtime_error("not done after " + std::to_string(std::lround(limit_s)) + " s");
  if (WIFSIGNALED(status)) throw std::runtime_error(std::string("ended by a signal: ") + strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0 || message->empty()) throw std::runtime_error("ended without an answer");
  if (message->front() == failed) throw std::runtime_error(message->substr(1));
  return message->substr(1);
}

}  // namespace whittle::bench

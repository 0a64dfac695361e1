#include "measure.hh"

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
#include <span>
#include <stdexcept>
#include <system_error>

namespace whittle::bench {
namespace {

double ms_of(const Meter& meter, Clock clock) { return clock == Clock::wall ? meter.wall_ms() : meter.cpu_ms(); }

/// What the forked process sends first; then come `n_text` characters, the positions and the faces.
struct Header {
  bool has_answer = false;
  bool has_peak = false;
  double ms = 0;
  std::uint64_t peak_bytes = 0;
  std::uint64_t n_text = 0;
  std::uint64_t n_positions = 0;
  std::uint64_t n_faces = 0;
};

template <class T>
std::span<const char> bytes_of(const T* data, std::size_t count) {
  return {reinterpret_cast<const char*>(data), count * sizeof(T)};
}

/// \return whether all of it was taken
bool send(int descriptor, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

/// The forked process's side. It ends without the usual cleaning up, which belongs to its parent.
[[noreturn]] void run_and_send(const Peer& peer, const IndexedMesh& input, std::size_t n_faces, Clock clock,
                               int descriptor) {
  Header header;
  IndexedMesh answer;
  std::string text;
  try {
    Meter meter(Meter::Memory::watched);
    answer = peer.decimate(input, n_faces, meter);
    header.has_answer = true;
    header.ms = ms_of(meter, clock);
    header.has_peak = meter.peak_bytes().has_value();
    header.peak_bytes = meter.peak_bytes().value_or(0);
  } catch (const std::exception& error) {
    text = error.what();
  }
  header.n_text = text.size();
  header.n_positions = answer.positions.size();
  header.n_faces = answer.faces.size();
  const bool is_sent = send(descriptor, bytes_of(&header, 1)) && send(descriptor, text) &&
                       send(descriptor, bytes_of(answer.positions.data(), answer.positions.size())) &&
                       send(descriptor, bytes_of(answer.faces.data(), answer.faces.size()));
  _exit(is_sent ? 0 : 1);
}

/// The other end of the pipe.
class Receiver {
 public:
  using Time = std::chrono::steady_clock::time_point;

  Receiver(int descriptor, Time deadline) : descriptor_(descriptor), deadline_(deadline) {}

  enum class End { complete, closed, late };

  template <class T>
  End fill(std::span<T> values) {
    auto* data = reinterpret_cast<char*>(values.data());
    std::size_t left = values.size_bytes();
    while (left > 0) {
      if (!wait()) return End::late;
      const ssize_t n = read(descriptor_, data, left);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return End::closed;
      data += n;
      left -= static_cast<std::size_t>(n);
    }
    return End::complete;
  }

 private:
  /// \return false when the time is over
  bool wait() const {
    while (true) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - std::chrono::steady_clock::now());
      if (left.count() <= 0) return false;
      pollfd poll_descriptor{descriptor_, POLLIN, 0};
      constexpr std::int64_t longest = 60'000;  // poll() takes an int
      if (poll(&poll_descriptor, 1, static_cast<int>(std::min<std::int64_t>(left.count(), longest))) > 0) return true;
    }
  }

  int descriptor_;
  Time deadline_;
};

Receiver::End receive(Receiver& receiver, FirstRun& run) {
  using End = Receiver::End;
  Header header;
  if (const End end = receiver.fill(std::span(&header, 1)); end != End::complete) return end;
  run.failure.resize(header.n_text);
  if (const End end = receiver.fill(std::span(run.failure)); end != End::complete) return end;
  if (!header.has_answer) return End::complete;
  IndexedMesh answer;
  answer.positions.resize(header.n_positions);
  answer.faces.resize(header.n_faces);
  if (const End end = receiver.fill(std::span(answer.positions)); end != End::complete) return end;
  if (const End end = receiver.fill(std::span(answer.faces)); end != End::complete) return end;
  run.answer = std::move(answer);
  run.ms = header.ms;
  if (header.has_peak) run.peak_bytes = header.peak_bytes;
  return End::complete;
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) return std::string("ended by a signal: ") + strsignal(WTERMSIG(status));
  return "ended without an answer";
}

std::system_error system_error(const char* what) { return {errno, std::generic_category(), what}; }

}  // namespace

FirstRun first_run(const Peer& peer, const IndexedMesh& input, std::size_t n_faces, Clock clock, double limit_s) {
  int ends[2];
  if (pipe(ends) != 0) throw system_error("pipe");
  const auto limit =
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(limit_s));
  const pid_t child = fork();
  if (child < 0) throw system_error("fork");
  if (child == 0) {
    close(ends[0]);
    run_and_send(peer, input, n_faces, clock, ends[1]);
  }
  close(ends[1]);
  FirstRun run;
  Receiver receiver(ends[0], std::chrono::steady_clock::now() + limit);
  const Receiver::End end = receive(receiver, run);
  close(ends[0]);
  if (end == Receiver::End::late) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (end == Receiver::End::late) run.failure = "not done after " + std::to_string(std::lround(limit_s)) + " s";
  if (end == Receiver::End::closed) run.failure = how_it_ended(status);
  return run;
}

std::vector<std::vector<double>> time_interleaved(const std::vector<const Peer*>& peers, const IndexedMesh& input,
                                                  std::size_t n_faces, Clock clock, int rounds) {
  std::vector<std::vector<double>> times(peers.size());
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < peers.size(); ++i) {
      Meter meter;
      peers[i]->decimate(input, n_faces, meter);
      if (round > 0) times[i].push_back(ms_of(meter, clock));
    }
  }
  return times;
}

}  // namespace whittle::bench

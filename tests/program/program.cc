#include "program/program.hh"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "support/meshes.hh"

namespace whittle::test {
namespace {

namespace fs = std::filesystem;

void require(bool condition, const char* what) {
  if (!condition) throw std::system_error(errno, std::generic_category(), what);
}

void close_if_open(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

struct Pipe {
  int read_end = -1;
  int write_end = -1;
  Pipe() {
    std::array<int, 2> ends{};
    require(::pipe2(ends.data(), O_CLOEXEC) == 0, "pipe");
    read_end = ends[0];
    write_end = ends[1];
  }
};

std::string search_path() {
  const char* path = ::getenv("PATH");
  return fs::path(WHITTLE_PROGRAM).parent_path().string() + ":" + (path != nullptr ? path : "/usr/bin:/bin");
}

/// Never returns.
[[noreturn]] void become(const std::vector<std::string>& command, const RunOptions& options) {
  if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) ::_exit(126);
  if (!options.stdout_to.empty()) {
    const int file = ::open(options.stdout_to.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0) ::_exit(126);
    ::dup2(file, STDOUT_FILENO);
  }
  ::setenv("PATH", search_path().c_str(), 1);
  for (const auto& [name, value] : options.environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (options.prepare) options.prepare();
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

/// Writes `input` to the program and reads both streams until both are closed.
void talk(int& input, const std::string& text, int output, int errors, Outcome& outcome) {
  std::size_t fed = 0;
  bool output_open = output >= 0;
  bool errors_open = errors >= 0;
  while (output_open || errors_open) {
    if (fed == text.size()) close_if_open(input);
    std::array<pollfd, 3> waiting{pollfd{input, POLLOUT, 0}, pollfd{output_open ? output : -1, POLLIN, 0},
                                  pollfd{errors_open ? errors : -1, POLLIN, 0}};
    require(::poll(waiting.data(), waiting.size(), -1) >= 0 || errno == EINTR, "poll");
    if (input >= 0 && waiting[0].revents != 0) {
      const ssize_t written = ::write(input, text.data() + fed, text.size() - fed);
      // A program may end without reading all its input.
      if (written < 0 && errno != EAGAIN) fed = text.size();
      if (written > 0) fed += static_cast<std::size_t>(written);
    }
    const auto drain = [](int descriptor, std::string& to) {
      std::array<char, 65536> buffer;
      const ssize_t size = ::read(descriptor, buffer.data(), buffer.size());
      if (size > 0) to.append(buffer.data(), static_cast<std::size_t>(size));
      return size > 0 || (size < 0 && errno == EINTR);
    };
    if (waiting[1].revents != 0) output_open = drain(output, outcome.out);
    if (waiting[2].revents != 0) errors_open = drain(errors, outcome.err);
  }
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) require(errno == EINTR, "waitpid");
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const Outcome& outcome) {
  return stream << "exit code " << outcome.exit_code << "\n--- stdout ---\n"
                << outcome.out << "--- stderr ---\n"
                << outcome.err << "--------------";
}

Outcome whittle(const std::vector<std::string>& arguments, const RunOptions& options) {
  return run(command(arguments), options);
}

Outcome run(const std::vector<std::string>& command, const RunOptions& options) {
  return Running(command, options).finish(options.input);
}

std::vector<std::string> command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), WHITTLE_PROGRAM);
  return arguments;
}

Running::Running(const std::vector<std::string>& command, const RunOptions& options) {
  ::signal(SIGPIPE, SIG_IGN);
  Pipe in;
  Pipe out;
  Pipe err;
  process_ = ::fork();
  require(process_ >= 0, "fork");
  if (process_ == 0) {
    ::signal(SIGPIPE, SIG_DFL);
    ::dup2(in.read_end, STDIN_FILENO);
    ::dup2(out.write_end, STDOUT_FILENO);
    ::dup2(options.stderr_to >= 0 ? options.stderr_to : err.write_end, STDERR_FILENO);
    become(command, options);
  }
  ::close(in.read_end);
  ::close(out.write_end);
  ::close(err.write_end);
  input_ = in.write_end;
  output_ = out.read_end;
  errors_ = err.read_end;
  require(::fcntl(input_, F_SETFL, O_NONBLOCK) == 0, "fcntl");
}

Running::~Running() {
  for (int* descriptor : {&input_, &output_, &errors_}) close_if_open(*descriptor);
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Running::signal(int number) const { require(::kill(process_, number) == 0, "kill"); }

void Running::feed(const std::string& text) const {
  require(::write(input_, text.data(), text.size()) == static_cast<ssize_t>(text.size()), "write to stdin");
  for (int left = 1; left > 0; ::usleep(1000)) require(::ioctl(input_, FIONREAD, &left) == 0, "FIONREAD");
}

Outcome Running::finish(const std::string& rest_of_input) {
  Outcome outcome;
  talk(input_, rest_of_input, output_, errors_, outcome);
  outcome.exit_code = wait_for(process_);
  process_ = -1;
  return outcome;
}

std::string read_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("can't read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

std::string data_file(const std::string& name) { return data_mesh(name).string(); }

nlohmann::json parse_json(const std::string& text) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string(error.what()) + " in:\n" + text);
  }
}

}  // namespace whittle::test

#include "commands/page/child_process.hh"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

extern char** environ;

namespace whittle::app {
namespace {

/// What a child does with its file descriptors.
class FileActions {
 public:
  FileActions() {
    ::posix_spawn_file_actions_init(&actions_);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      ::posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_WRONLY, 0);
    }
  }
  ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  void give(int file, int as) { ::posix_spawn_file_actions_adddup2(&actions_, file, as); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// \return nothing if there is no such program
std::optional<pid_t> spawn(std::vector<std::string>& arguments, const FileActions& actions) {
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, words.front(), actions.get(), nullptr, words.data(), environ);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) throw std::runtime_error(arguments.front() + " can't be run: " + std::strerror(error));
  return child;
}

/// A pipe whose ends are not file descriptors that a child is given by number.
std::array<int, 2> make_pipe() {
  constexpr int lowest = 10;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  for (int& end : ends) {
    const int high = ::fcntl(end, F_DUPFD_CLOEXEC, lowest);
    ::close(end);
    end = high;
  }
  return ends;
}

}  // namespace

WorkFolder::WorkFolder() : path_((std::filesystem::temp_directory_path() / "whittle-XXXXXX").string()) {
  if (::mkdtemp(path_.data()) == nullptr) {
    throw std::runtime_error("can't make a folder for pictures: " + std::string(std::strerror(errno)));
  }
}

WorkFolder::~WorkFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

bool is_root() { return ::geteuid() == 0; }

std::optional<int> run_quietly(std::vector<std::string> arguments) {
  const std::optional<pid_t> child = spawn(arguments, FileActions());
  if (!child) return std::nullopt;
  int status = 0;
  while (::waitpid(*child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

std::unique_ptr<TalkingProcess> TalkingProcess::start(std::vector<std::string> arguments) {
  constexpr int its_input = 3;
  constexpr int its_output = 4;
  const auto [input, to] = make_pipe();
  const auto [from, output] = make_pipe();
  FileActions actions;
  actions.give(input, its_input);
  actions.give(output, its_output);
  const std::optional<pid_t> child = spawn(arguments, actions);
  ::close(input);
  ::close(output);
  if (!child) {
    ::close(to);
    ::close(from);
    return nullptr;
  }
  return std::unique_ptr<TalkingProcess>(new TalkingProcess(arguments.front(), *child, to, from));
}

TalkingProcess::TalkingProcess(std::string name, pid_t process, int to, int from)
    : name_(std::move(name)), process_(process), to_(to), from_(from) {}

TalkingProcess::~TalkingProcess() {
  constexpr int most_waits = 100;
  constexpr std::chrono::milliseconds wait(50);
  ::close(to_);
  ::close(from_);
  for (int i = 0; i < most_waits; ++i) {
    if (::waitpid(process_, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(wait);
  }
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void TalkingProcess::write(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const ssize_t n = ::write(to_, text.data() + i, text.size() - i);
    if (n < 0 && errno != EINTR) throw std::runtime_error(name_ + " has ended");
    if (n > 0) i += static_cast<std::size_t>(n);
  }
}

std::string TalkingProcess::read_until(char end) {
  constexpr int longest_wait = 120'000;  // milliseconds
  std::size_t at = 0;
  while ((at = read_.find(end, at)) == std::string::npos) {
    at = read_.size();
    pollfd file{from_, POLLIN, 0};
    const int n_ready = ::poll(&file, 1, longest_wait);
    if (n_ready == 0) throw std::runtime_error(name_ + " doesn't answer");
    std::array<char, 65536> bytes{};
    const ssize_t n = ::read(from_, bytes.data(), bytes.size());
    if (n == 0 || (n < 0 && errno != EINTR)) throw std::runtime_error(name_ + " has ended");
    if (n > 0) read_.append(bytes.data(), static_cast<std::size_t>(n));
  }
  std::string text = read_.substr(0, at);
  read_.erase(0, at + 1);
  return text;
}

}  // namespace whittle::app

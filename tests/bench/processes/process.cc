#include "bench/processes/process.hh"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace whittle::bench {
namespace {

constexpr int cannot_start = 127;  // the shell's exit status

[[noreturn]] void become(const std::vector<std::string>& command, const std::filesystem::path& log, double limit_s) {
  const int input = open("/dev/null", O_RDONLY);
  const int output = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (input < 0 || output < 0 || dup2(input, 0) < 0 || dup2(output, 1) < 0 || dup2(output, 2) < 0) _exit(cannot_start);
  // The alarm outlives exec: SIGALRM ends the new program.
  itimerval limit{};
  limit.it_value.tv_sec = static_cast<time_t>(std::ceil(limit_s));
  setitimer(ITIMER_REAL, &limit, nullptr);
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments.front(), arguments.data());
  _exit(cannot_start);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::string failure_of(int status, double limit_s) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return "not done after " + std::to_string(std::lround(limit_s)) + " s";
  if (WIFSIGNALED(status)) return std::string("ended by a signal: ") + strsignal(WTERMSIG(status));
  if (WEXITSTATUS(status) == cannot_start) return "can't be started";
  return WEXITSTATUS(status) == 0 ? "" : "exit status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

ProcessRun run_process(const std::vector<std::string>& command, const std::filesystem::path& log, double limit_s) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) become(command, log, limit_s);
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "wait4");
  }
  ProcessRun run;
  run.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  run.failure = failure_of(status, limit_s);
  return run;
}

}  // namespace whittle::bench

#include "commands/page/browser.hh"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <vector>

extern char** environ;

namespace whittle::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 5> browsers{"chromium", "chromium-browser", "google-chrome", "google-chrome-stable",
                                              "chrome"};

/// A folder that is there as long as this.
class WorkFolder {
 public:
  WorkFolder() {
    std::string path = (fs::temp_directory_path() / "whittle-XXXXXX").string();
    if (::mkdtemp(path.data()) == nullptr) {
      throw std::runtime_error("can't make a folder for the picture: " + std::string(std::strerror(errno)));
    }
    path_ = path;
  }
  ~WorkFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

/// Runs a program to its end, and lets it print nothing. \return its exit status, or nothing if there is no such
/// program
std::optional<int> run_quietly(std::vector<std::string> arguments) {
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  }
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, words.front(), &actions, nullptr, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) throw std::runtime_error(arguments.front() + " can't be run: " + std::strerror(error));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// Of the options of a picture: all that is drawn is computed, by the processor alone, and the page's own clock waits.
std::vector<std::string> drawing_options(const WorkFolder& folder, const PictureSize& size) {
  std::vector<std::string> options{"--headless",
                                   "--hide-scrollbars",
                                   "--use-angle=swiftshader",
                                   "--enable-unsafe-swiftshader",
                                   "--no-first-run",
                                   "--virtual-time-budget=20000",
                                   "--force-device-scale-factor=1",
                                   "--user-data-dir=" + (folder / "profile").string(),
                                   "--window-size=" + std::to_string(size.width) + ',' + std::to_string(size.height),
                                   "--screenshot=" + (folder / "picture.png").string()};
  if (::geteuid() == 0) options.emplace_back("--no-sandbox");
  return options;
}

}  // namespace

std::string picture_of(const std::string& page, const std::string& view, const PictureSize& size) {
  const WorkFolder folder;
  std::ofstream(folder / "page.html", std::ios::binary) << page;
  std::vector<std::string> arguments = drawing_options(folder, size);
  arguments.push_back("file://" + (folder / "page.html").string() + "#picture&" + view);
  for (const char* const browser : browsers) {
    std::vector<std::string> words{browser};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const std::optional<int> status = run_quietly(std::move(words));
    if (!status) continue;
    std::ifstream picture(folder / "picture.png", std::ios::binary);
    if (*status != 0 || !picture) throw std::runtime_error("--png: " + std::string(browser) + " has drawn no picture");
    return {std::istreambuf_iterator<char>(picture), std::istreambuf_iterator<char>()};
  }
  throw std::runtime_error("--png needs Chromium, which is not installed (on Debian: apt install chromium)");
}

bool open_on_desktop(const std::string& path) { return run_quietly({"xdg-open", path}).value_or(1) == 0; }

}  // namespace whittle::app

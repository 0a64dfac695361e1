// The program, in this process: its main function is compiled under another name.
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "fuzz/check/promise.hh"
#include "fuzz/decode/command_line_bytes.hh"
#include "fuzz/targets.hh"

int whittle_main(int argc, char** argv);

namespace whittle::test {
namespace {

/// Takes what is written to a stream, until destroyed.
class Captured {
 public:
  explicit Captured(std::ostream& stream) : stream_(stream), before_(stream.rdbuf(text_.rdbuf())) {}
  ~Captured() { stream_.rdbuf(before_); }
  Captured(const Captured&) = delete;
  Captured& operator=(const Captured&) = delete;

  std::string text() const { return text_.str(); }

 private:
  std::ostream& stream_;
  std::ostringstream text_;
  std::streambuf* before_;
};

Ending run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "whittle");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const Captured out(std::cout);
  const Captured err(std::cerr);
  const int exit_code = whittle_main(static_cast<int>(arguments.size()), argv.data());
  return {exit_code, out.text(), err.text()};
}

void enter_empty_folder() {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "whittle_fuzz_command_line";
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
}

}  // namespace

void fuzz_command_line(std::string_view bytes) {
  [[maybe_unused]] static const bool is_ready = (enter_empty_folder(), true);
  ByteSource source(bytes);
  const std::vector<std::string> arguments = decode_command_line(source);
  const Ending ending = run(arguments);
  try {
    check_ending(arguments, ending);
  } catch (const BrokenPromise& error) {
    std::string text = error.what() + std::string("\nwhittle");
    for (const std::string& argument : arguments) text += " '" + argument + "'";
    throw BrokenPromise(text + "\n" + ending.err + ending.out);
  }
}

}  // namespace whittle::test

#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX  // MinGW's headers of C++ define it, too
#define NOMINMAX
#endif
#include <windows.h>
// After windows.h, which they need.
#include <fcntl.h>
#include <io.h>
#include <psapi.h>
#include <shellapi.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>

#include "system/system.hh"

namespace whittle::app {
namespace {

constexpr int standard_input = 0;
constexpr int standard_output = 1;
constexpr int standard_error = 2;

HANDLE error_console() { return ::GetStdHandle(STD_ERROR_HANDLE); }

std::string utf8_of(const wchar_t* text) {
  const int size = ::WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  if (size <= 1) return {};
  std::string utf8(static_cast<std::size_t>(size), '\0');
  ::WideCharToMultiByte(CP_UTF8, 0, text, -1, utf8.data(), size, nullptr, nullptr);
  utf8.pop_back();  // its end
  return utf8;
}

}  // namespace

std::vector<std::string> words_of_command_line(int argc, char** argv) {
  int n = 0;
  wchar_t** wide = ::CommandLineToArgvW(::GetCommandLineW(), &n);
  if (wide == nullptr) return {argv, argv + argc};
  std::vector<std::string> words;
  for (int i = 0; i < n; ++i) words.push_back(utf8_of(wide[i]));
  ::LocalFree(wide);
  return words;
}

void set_up_streams() {
  ::SetConsoleOutputCP(CP_UTF8);
  for (const int stream : {standard_input, standard_output, standard_error}) ::_setmode(stream, _O_BINARY);
}

bool is_at_terminal() {
  DWORD mode = 0;
  return ::GetConsoleMode(error_console(), &mode) != 0 &&
         ::SetConsoleMode(error_console(), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

std::size_t terminal_width() {
  CONSOLE_SCREEN_BUFFER_INFO info = {};
  if (::GetConsoleScreenBufferInfo(error_console(), &info) == 0) return 80;
  return static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1);
}

void watch_signals(void (*on_signal)(int)) {
  for (const int signal : {SIGINT, SIGTERM, SIGBREAK}) std::signal(signal, on_signal);
}

void end_at_once(std::string_view message, int status) {
  ::_write(standard_error, message.data(), static_cast<unsigned>(message.size()));
  std::_Exit(status);
}

// Rights are lists there, and only an attempt to write tells.
std::string why_not_writable(const std::string& /*folder*/) { return {}; }

std::uint64_t peak_memory_bytes() {
  PROCESS_MEMORY_COUNTERS counters = {};
  if (::K32GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters) == 0) return 0;
  return counters.PeakWorkingSetSize;
}

bool open_on_desktop(const std::string& path) {
  const std::filesystem::path file(std::u8string(path.begin(), path.end()));
  const auto result =
      reinterpret_cast<std::intptr_t>(::ShellExecuteW(nullptr, L"open", file.c_str(), nullptr, nullptr, SW_SHOWNORMAL));
  return result > 32;  // as its reference says
}

}  // namespace whittle::app

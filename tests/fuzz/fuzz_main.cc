// What libFuzzer calls: the library's target that the build names, or else the command line. With a folder in
// WHITTLE_FUZZ_FINDINGS, inputs that break a promise are kept there, a few of each promise, and fuzzing goes on.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

#include "fuzz/decode/byte_source.hh"
#include "fuzz/targets.hh"

namespace whittle::test {
namespace {

/// "broken-promise-the-vertex-map-is-total": of a message's first line.
std::string file_name_of(std::string_view message) {
  std::string name;
  for (const char c : message.substr(0, message.find('\n')).substr(0, 100)) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (is_letter || (!name.empty() && name.back() != '-')) name += is_letter ? c : '-';
  }
  return name;
}

void keep(const std::string& folder, std::string_view bytes, std::string_view message) {
  constexpr int most_of_a_kind = 4;
  static std::map<std::string, int> n_kept;
  const std::string name = file_name_of(message);
  if (++n_kept[name] > most_of_a_kind) return;
  std::fprintf(stderr, "%s\n", name.c_str());
  const std::string path = folder + "/" + name + "-" + std::to_string(hash_of(bytes));
  std::ofstream(path, std::ios::binary) << bytes;
}

#ifdef WHITTLE_FUZZ_TARGET
FuzzTarget target() { return library_target(WHITTLE_FUZZ_TARGET); }
#else
FuzzTarget target() { return fuzz_command_line; }
#endif

}  // namespace
}  // namespace whittle::test

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const whittle::test::FuzzTarget target = whittle::test::target();
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    target(bytes);
  } catch (const std::exception& error) {
    const char* const folder = std::getenv("WHITTLE_FUZZ_FINDINGS");
    if (folder == nullptr) {
      std::fprintf(stderr, "%s\n", error.what());
      std::abort();
    }
    whittle::test::keep(folder, bytes, error.what());
  }
  return 0;
}

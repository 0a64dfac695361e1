#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/read_and_check.hh"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  whittle::test::read_and_check(std::string_view(reinterpret_cast<const char*>(data), size));
  return 0;
}

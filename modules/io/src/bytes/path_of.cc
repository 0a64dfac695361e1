#include "whittle/io/path_of.hh"

#include <string>
#include <system_error>

namespace whittle::io {

std::filesystem::path path_of(std::string_view name) {
  try {
    return std::u8string(name.begin(), name.end());
  } catch (const std::system_error&) {  // never on POSIX, where names are bytes
    return name;
  }
}

}  // namespace whittle::io

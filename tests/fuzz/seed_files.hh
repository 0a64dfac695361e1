#pragma once

#include <string>
#include <vector>

#include "whittle/io/format.hh"

namespace whittle::test {

/// A valid input of a reader's fuzz target.
struct SeedFile {
  io::Format format;
  std::string bytes;  ///< a byte for welding, then the file
};

/// Each format as our writer writes it, and by hand features that our writers don't use.
std::vector<SeedFile> seed_files();

}  // namespace whittle::test

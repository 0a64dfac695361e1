#pragma once

#include <string>
#include <vector>

#include "fuzz/decode/byte_source.hh"

namespace whittle::test {

/// Arguments of the program: subcommands, options and values that it knows, others that are like them, and any bytes.
/// None has a '/': all files are looked for in the current folder.
std::vector<std::string> decode_command_line(ByteSource& source);

/// How the program ended.
struct Ending {
  int exit_code;
  std::string out;
  std::string err;
};

/// What is promised of a run in an empty folder, where no input can be read. \throw BrokenPromise
void check_ending(const std::vector<std::string>& arguments, const Ending& ending);

}  // namespace whittle::test

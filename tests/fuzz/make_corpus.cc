// Writes inputs to start fuzzing from: valid files for the readers, and a few of each shape for the others.
//   make_corpus TARGET FOLDER
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/decode/mesh_bytes.hh"
#include "fuzz/seed_files.hh"
#include "support/random.hh"
#include "whittle/io/format.hh"

namespace whittle::test {
namespace {

std::vector<std::string> files_of(io::Format format) {
  std::vector<std::string> inputs;
  for (const SeedFile& file : seed_files()) {
    if (file.format == format) inputs.push_back(file.bytes);
  }
  return inputs;
}

/// Random bytes decode to shapes of all kinds with all options.
std::vector<std::string> random_inputs(std::size_t n) {
  Random random(1);
  std::vector<std::string> inputs;
  for (std::size_t i = 0; i < n; ++i) {
    std::string& input = inputs.emplace_back(20 + random.below(140), '\0');
    for (char& c : input) c = static_cast<char>(random.bits() >> 56);
  }
  return inputs;
}

std::vector<std::string> inputs_of(std::string_view target) {
  for (const io::Format format : io::all_formats) {
    if (io::name_of(format) == target) return files_of(format);
  }
  return random_inputs(60 * n_mesh_kinds());
}

}  // namespace
}  // namespace whittle::test

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: make_corpus TARGET FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[2];
  std::filesystem::create_directories(folder);
  std::size_t n = 0;
  for (const std::string& input : whittle::test::inputs_of(argv[1])) {
    std::ofstream(folder / ("seed" + std::to_string(n++)), std::ios::binary) << input;
  }
  return 0;
}
